// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/pack/pack.h"
#include "core/scene/gltf_convert.h"
#include "tests/core/atlas/pack_support.h"
#include "tests/core/scene/small_scene.h"

using namespace etak;
using namespace etak::test;

namespace {

// Broad waves: content that a fraction of the texels holds.
Image8 waves(int width, int height, int channels, double period) {
  Image8 out(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c)
        out.at(x, y)[static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(
            128 + 90 * std::sin((x + 2 * c) * 6.2831853 / period) * std::cos((y + c) * 6.2831853 / period));
  return out;
}

const std::string both = R"({"materials": [
  {"name": "smooth", "diffuse": "smooth.png", "specular": "smooth.png", "gloss": "smooth_gloss.png"},
  {"name": "rough", "diffuse": "rough.png", "specular": "gold", "gloss": 0.5}]})";

void save_both(const TempFolder& folder) {
  save_png(folder.file("smooth.png"), waves(256, 192, 3, 512));
  save_png(folder.file("smooth_gloss.png"), waves(256, 192, 1, 700));
  save_png(folder.file("rough.png"), noise(64, 64, 3, 5));
}

// Bilinear in linear light at a place in texels, inside a box of the picture.
std::array<double, 4> look(const Image8& image, const PixelBox& box, double x, double y) {
  const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
  std::array<double, 4> out{};
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      const double share =
          (i == 0 ? 1 - (x - 0.5 - left) : x - 0.5 - left) * (j == 0 ? 1 - (y - 0.5 - top) : y - 0.5 - top);
      const int column = std::clamp(static_cast<int>(left) + i, box.x, box.x + box.width - 1);
      const int row = std::clamp(static_cast<int>(top) + j, box.y, box.y + box.height - 1);
      const auto texel = image.at(column, row);
      for (std::size_t c = 0; c < texel.size(); ++c)
        out[c] += share * (c < 3 && texel.size() >= 3 ? srgb_decode(texel[c] / 255.0) : texel[c] / 255.0);
    }
  return out;
}

double color_difference(const std::array<double, 4>& a, const std::array<double, 4>& b) {
  return delta_e2000(to_lab(LinearRgb{a[0], a[1], a[2]}), to_lab(LinearRgb{b[0], b[1], b[2]}));
}

}  // namespace

TEST_CASE("smooth content is stored with fewer texels, and no pixel differs by more than the bound") {
  for (const bool rotate : {false, true})
    for (const double bound : {1.5, 3.0}) {
      const TempFolder folder;
      save_both(folder);
      PackOptions options;
      options.leave_out.max_error = bound;
      options.layout.rotate = rotate;
      options.run.threads = 2;
      const PackResult report = pack_text(folder, both, options);
      const AtlasLayout layout = packed_layout(folder);
      const AtlasRect& smooth = rect_named(layout, "smooth");
      const int width = smooth.rotated ? smooth.height : smooth.width,
                height = smooth.rotated ? smooth.width : smooth.height;
      CHECK(width <= 128);
      CHECK(smooth.crop.width == 256);
      CHECK(rect_named(layout, "rough").width == 64);
      REQUIRE(report.reduced.size() == 1);
      CHECK(report.reduced[0].seen_delta_e <= bound);
      CHECK(report.reduced[0].stored_width == width);
      const LeaveOutLine* line = line_named(report, "resolution");
      REQUIRE(line != nullptr);
      CHECK(line->texels == 2 * (256 * 192 - static_cast<std::uint64_t>(width) * height));
      CHECK(line->error > 0);
      // Between texels too, and by another way of looking than the packer's own.
      const AtlasPage& page = layout.pages[static_cast<std::size_t>(smooth.page)];
      const Image8 a = load_png(folder.file("out/" + page.files[0].at(0))),
                   b = load_png(folder.file("out/" + page.files[1].at(0)));
      const Image8 source = load_png(folder.file("smooth.png")),
                   gloss = load_png(folder.file("smooth_gloss.png"));
      const PixelBox all{smooth.x, smooth.y, smooth.width, smooth.height};  // a gutter repeats its edge
      double worst = 0, worst_gloss = 0;
      for (double y = 0.3; y < 192; y += 1.7)
        for (double x = 0.2; x < 256; x += 1.3) {
          const double u = x * width / 256, v = y * height / 192;
          const double at_x = smooth.rotated ? smooth.x + smooth.width - v : smooth.x + u,
                       at_y = smooth.rotated ? smooth.y + u : smooth.y + v;
          const auto was = look(source, {0, 0, 256, 192}, x, y);
          const auto diffuse = look(a, all, at_x, at_y), specular = look(b, all, at_x, at_y);
          worst = std::max({worst, color_difference(was, diffuse), color_difference(was, specular)});
          worst_gloss = std::max(worst_gloss, std::abs(look(gloss, {0, 0, 256, 192}, x, y)[0] - specular[3]));
        }
      CHECK(worst <= bound + 0.02);
      CHECK(100 * worst_gloss <= bound + 0.02);
      CHECK(worst > 0);
    }
}

TEST_CASE("without the option, or with --keep resolution, every texel stays") {
  const TempFolder folder;
  save_both(folder);
  CHECK(rect_named((void(pack_text(folder, both, {})), packed_layout(folder)), "smooth").width == 256);
  PackOptions options;
  options.leave_out.max_error = 2;
  options.leave_out.keep = {"resolution"};
  const PackResult report = pack_text(folder, both, options);
  CHECK(report.reduced.empty());
  CHECK(rect_named(packed_layout(folder), "smooth").width == 256);
}

TEST_CASE("alpha that is tested keeps its texels") {
  const TempFolder folder;
  save_both(folder);
  save_png(folder.file("alpha.png"), waves(256, 192, 1, 600));
  const auto text = [](const char* mode) {
    return std::string(R"({"materials": [{"name": "smooth", "diffuse": "smooth.png", "specular": 0.04,)") +
           R"("gloss": 0.5, "alpha": "alpha.png", "alpha_mode": ")" + mode + "\"}]}";
  };
  PackOptions options;
  options.leave_out.max_error = 2;
  CHECK(pack_text(folder, text("blend"), options).reduced.size() == 1);
  CHECK(pack_text(folder, text("mask"), options).reduced.empty());
}

TEST_CASE("mips of a region with fewer texels are those of what is stored") {
  const TempFolder folder;
  save_both(folder);
  PackOptions options;
  options.leave_out.max_error = 2;
  options.layout.mips = 2;
  (void)pack_text(folder, both, options);
  const AtlasLayout layout = packed_layout(folder);
  const AtlasRect& rect = rect_named(layout, "smooth");
  REQUIRE(rect.mips >= 2);
  const std::string page = folder.file("out/page" + std::to_string(rect.page) + "_diffuse_alpha");
  const Image8 level_0 = load_png(page + ".png"), level_1 = load_png(page + ".mip1.png");
  int worst = 0;
  for (int y = 0; y < rect.height / 2; ++y)
    for (int x = 0; x < rect.width / 2; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0;
        for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}})
          sum += srgb_decode(level_0.at(rect.x + 2 * x + i, rect.y + 2 * y + j)[c] / 255.0) / 4;
        worst = std::max(worst, std::abs(level_1.at(rect.x / 2 + x, rect.y / 2 + y)[c] - srgb_u8(sum)));
      }
  CHECK(worst <= 1);
}

namespace {

// A square of one unit under a picture of 256 x 256 noise, whose sampler reads mips or not, and a camera that
// shows the square at so many pixels.
std::string square(const TempFolder& folder, int min_filter) {
  save_png(folder.file("a.png"), noise(256, 256, 3, 11));
  spit(folder.file("quad.bin"), unit_quad());
  const std::string rest =
      R"("images":[{"uri":"a.png"}],"samplers":[{"wrapS":33071,"wrapT":33071,"minFilter":)" +
      std::to_string(min_filter) +
      R"(}],"textures":[{"source":0,"sampler":0}],"cameras":[{"type":"orthographic","orthographic":)" +
      R"({"xmag":0.5,"ymag":0.5,"znear":0.1,"zfar":9}}],)";
  std::string json = quad_json(R"([{"name":"m","pbrMetallicRoughness":{"baseColorTexture":{"index":0},)"
                               R"("metallicFactor":0,"roughnessFactor":0.5}}])",
                               rest);
  json = replaced(json, R"("nodes":[{"mesh":0}],)",
                  R"("nodes":[{"children":[1,2]},{"mesh":0},{"camera":0,"translation":[0.5,0.5,5]}],)");
  spit(folder.file("s.gltf"), json);
  return folder.file("s.gltf");
}

PackResult pack_square(const TempFolder& folder, const std::string& scene, const PackOptions& options) {
  return pack(scene, folder.file("out"), options, built_in_library());
}

}  // namespace

TEST_CASE("a scene's texels beyond what its cameras or a density can show are left out, and said") {
  const TempFolder folder;
  const std::string scene = square(folder, 9987);
  PackOptions options;
  CHECK(pack_square(folder, scene, options).reduced.empty());
  options.leave_out.view_height = 70;  // 256 texels on 70 pixels: 128 are enough, 64 are not
  PackResult report = pack_square(folder, scene, options);
  REQUIRE(report.reduced.size() == 1);
  CHECK(report.reduced[0].stored_width == 128);
  CHECK(report.reduced[0].seen_delta_e == 0);
  CHECK(report.reduced[0].delta_e > 1);  // from nearer it would be seen
  options.leave_out.view_height = 300;
  CHECK(pack_square(folder, scene, options).reduced.empty());
  options.leave_out.view_height = 0;
  options.leave_out.texel_density = 60;
  report = pack_square(folder, scene, options);
  REQUIRE(report.reduced.size() == 1);
  CHECK(report.reduced[0].stored_width == 64);
  // Where both speak, both hold.
  options.leave_out.view_height = 70;
  CHECK(pack_square(folder, scene, options).reduced.at(0).stored_width == 128);
  CHECK(contains(slurp(folder.file("out/scene.gltf")), "page0_diffuse_alpha.png"));
}

TEST_CASE(
    "mips that no sampler reads, that no camera comes to, or in which no region has a texel are left out") {
  const TempFolder folder;
  PackOptions options;
  options.output.write.formats = {"png", "ktx2"};
  PackResult report = pack_square(folder, square(folder, 9987), options);
  CHECK(report.levels == 9);
  CHECK(line_named(report, "mips") == nullptr);
  report = pack_square(folder, square(folder, 9729), options);
  CHECK(report.levels == 1);
  REQUIRE(line_named(report, "mips") != nullptr);
  std::uint64_t bytes = 0;
  for (std::uint64_t side = 128; side > 0; side /= 2) bytes += 4 * side * side;  // diffuse alone varies
  CHECK(line_named(report, "mips")->bytes == bytes);
  CHECK(line_named(report, "mips")->texels == 0);
  options.leave_out.keep = {"mips"};
  CHECK(pack_square(folder, square(folder, 9729), options).levels == 9);
  options.leave_out.keep.clear();
  options.leave_out.view_height =
      500;  // texels are larger than pixels; three levels more for a look from the side
  CHECK(pack_square(folder, square(folder, 9987), options).levels == 4);

  const TempFolder other;
  for (const char* name : {"a", "b", "c", "d"})
    save_png(other.file(std::string(name) + ".png"), noise(32, 32, 3, static_cast<unsigned>(name[0])));
  std::string text;
  for (const char* name : {"a", "b", "c", "d"})
    text += (text.empty() ? "" : ", ") + std::string("{\"name\": \"") + name + "\", \"diffuse\": \"" + name +
            ".png\", \"specular\": 0.04, \"gloss\": 0.5}";
  PackOptions all;
  all.output.write.formats = {"dds"};
  all.layout.gutter = 0;
  all.layout.form = PageForm::square;
  report = pack_text(other, "{\"materials\": [" + text + "]}", all);
  CHECK(report.pages.at(0).width == 64);
  CHECK(report.levels == 6);  // not 7: on a texel of the last one four regions would meet
  CHECK(line_named(report, "mips")->bytes == 4);
}

TEST_CASE("the normal map of a scene widens the gloss of its mips, at its own strength") {
  const TempFolder folder;
  const std::string scene = square(folder, 9987);
  std::string json = slurp(scene);
  json = replaced(json, R"("images":[)", R"("images":[{"uri":"n.png"},)");
  json = replaced(json, R"("textures":[{"source":0,"sampler":0}])",
                  R"("textures":[{"source":1,"sampler":0},{"source":0,"sampler":0}])");
  Image8 rough = noise(128, 128, 3, 3);
  for (std::size_t i = 2; i < rough.values.size(); i += 3) rough.values[i] = 255;
  save_png(folder.file("n.png"), rough);
  PackOptions options;
  options.layout.mips = 3;
  options.leave_out.keep = {"constant", "textures"};
  const auto level_2 = [&](const std::string& map) {
    spit(scene, replaced(json, "\"name\":\"m\",", "\"name\":\"m\"," + map));
    (void)pack_square(folder, scene, options);
    return int{load_png(folder.file("out/page0_specular_gloss.mip2.png")).at(20, 20)[3]};
  };
  CHECK(level_2("") == 128);
  const int full = level_2(R"("normalTexture":{"index":1},)");
  const int weak = level_2(R"("normalTexture":{"index":1,"scale":0.2},)");
  CHECK(full < 110);
  CHECK(weak > full);
  CHECK(weak < 128);
  CHECK(level_2(R"("normalTexture":{"index":1,"texCoord":1},)") == 128);  // looked up elsewhere
  json = replaced(json, R"("wrapS":33071,"wrapT":33071,)", "");
  // Turned, moved and repeated it is the same rough map, so all in all as wide.
  const auto mean = [&](const std::string& transform) {
    (void)level_2(R"("normalTexture":{"index":1,"extensions":{"KHR_texture_transform":{)" + transform +
                  "}}},");
    const Image8 level = load_png(folder.file("out/page0_specular_gloss.mip2.png"));
    double sum = 0;
    for (std::size_t i = 3; i < level.values.size(); i += 4) sum += level.values[i];
    return sum / static_cast<double>(level.pixel_count());
  };
  const double still = mean(R"("offset":[0,0])");
  CHECK(still < 120);
  CHECK(mean(R"("offset":[0.25,0.5])") == Approx(still).margin(3));
  CHECK(mean(R"("rotation":1.5707963267948966)") == Approx(still).margin(3));
  CHECK(mean(R"("offset":[0.5,0],"scale":[-1,1])") == Approx(still).margin(3));
  CHECK(mean(R"("scale":[0.25,0.25])") > still + 3);  // enlarged: less rough within a texel
}

TEST_CASE("a normal map lies on a pair by both transforms, and a texel is the mean of what it covers") {
  Image8 map(4, 4, 3, 128);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) map.at(x, y)[0] = static_cast<std::uint8_t>(16 * (4 * y + x));
  const auto red = [](const Image8& image, int x, int y) { return int{image.at(x, y)[0]}; };
  CHECK(scaled_normals(map, 1, 4, 4) == map);
  const Image8 half = scaled_normals(map, 1, 2, 2);
  CHECK(red(half, 0, 0) == (0 + 16 + 64 + 80) / 4);
  CHECK(red(half, 1, 1) == (160 + 176 + 224 + 240) / 4);
  GltfTexture lead, detail;
  TexelUse use;
  CHECK(normals_on_pair(detail, lead, use)->to_map == UvMatrix{1, 0, 0, 0, 1, 0});
  detail.transform.offset = {0.25, 0.5};
  const Image8 moved = scaled_normals(map, 1, 4, 4, *normals_on_pair(detail, lead, use));
  CHECK(red(moved, 0, 0) == red(map, 1, 2));
  CHECK(red(moved, 3, 3) == red(map, 0, 1));
  lead.transform.offset = detail.transform.offset;  // both moved alike, whatever else differs
  detail.sampler.wrap_u = Wrap::clamp;
  CHECK(scaled_normals(map, 1, 4, 4, *normals_on_pair(detail, lead, use)) == map);
  use.fold.offset = {-1, 0};  // triangles lie in the second period: on a map that ends, its last column
  CHECK(red(scaled_normals(map, 1, 4, 4, *normals_on_pair(detail, lead, use)), 0, 1) == red(map, 3, 1));
  // A period of the pair must be whole periods of the map where several are in use.
  detail = lead = {};
  use = {};
  use.tiles = true;
  detail.transform.scale = {3, 2};
  CHECK(normals_on_pair(detail, lead, use));
  detail.transform.scale = {1.5, 2};
  CHECK_FALSE(normals_on_pair(detail, lead, use));
  detail.transform.scale = {3, 2};
  detail.sampler.wrap_u = Wrap::clamp;
  CHECK_FALSE(normals_on_pair(detail, lead, use));
  detail = lead;
  detail.uv_set = 1;
  CHECK_FALSE(normals_on_pair(detail, lead, use));
}
