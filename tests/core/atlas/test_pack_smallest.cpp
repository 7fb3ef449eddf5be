// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "core/base/files/file.h"
#include "core/image/texture_bytes.h"
#include "core/scene/image_roles.h"
#include "tests/core/atlas/scene_support.h"
#include "tests/core/scene/written_scene.h"

using namespace etak;
using namespace etak::test;

namespace {

// Codes, at the largest: UVs that are rewritten are floats on a page of 2,000 texels.
constexpr double uv_rounding = 0.02;

using TextureOf = std::optional<GltfTexture> GltfMaterial::*;

// What a sampler finds in a texture, as codes: grey in all three colours, and full where there is none.
std::array<double, 4> found(ReadPictures& pictures, const GltfMaterial& m, TextureOf which,
                            const std::array<float, 2>& uv) {
  const std::optional<GltfTexture>& texture = m.*which;
  if (!texture) return {255, 255, 255, 255};
  const Image8& picture = pictures(texture->image);
  const std::array<double, 4> at = lookup(picture, *texture, uv, Filter::codes);
  if (picture.channels > 2) return at;
  return {at[0], at[0], at[0], picture.channels == 2 ? at[1] : 255};
}

// Whether all texels of a texture say the same, and the packed material's factors say it: of base colour red and
// alpha are looked at, of metal and roughness both.
bool is_in_factors(ReadPictures& pictures, const GltfMaterial& m, const GltfMaterial& p, TextureOf which) {
  const Image8& picture = pictures((m.*which)->image);
  const auto channels = static_cast<std::size_t>(picture.channels);
  for (std::size_t i = channels; i < picture.values.size(); ++i)
    if (picture.values[i] != picture.values[i - channels]) return false;
  const auto texel = four_channels(picture.values.data(), channels, std::uint8_t{255});
  const auto is = [](double value, double factor, double code) {
    return value == Approx(factor * code).margin(1e-9);
  };
  if (which == &GltfMaterial::base_color_texture)
    return is(p.base_color[0], m.base_color[0], srgb_decode(texel[0] / 255.0)) &&
           is(p.base_color[3], m.base_color[3], texel[3] / 255.0);
  return is(p.roughness, m.roughness, texel[1] / 255.0) && is(p.metallic, m.metallic, texel[2] / 255.0);
}

// The largest difference of the first `channels` channels of a texture between two scenes, over corners and centres
// of triangles; from channel `first`.
double worst_texture(const GltfScene& before, const GltfScene& after, TextureOf which, std::size_t first,
                     std::size_t channels) {
  ReadPictures old_pictures(before), new_pictures(after);
  double worst = 0;
  for (std::size_t u = 0; u < before.uses.size(); ++u) {
    const GltfUse &from = before.uses[u], &to = after.uses[u];
    const GltfMaterial& m = before.materials[static_cast<std::size_t>(from.material)];
    const GltfMaterial& p = after.materials[static_cast<std::size_t>(to.material)];
    if (!(m.*which) || !(p.*which)) {
      CHECK(((m.*which).has_value() == (p.*which).has_value() || is_in_factors(old_pictures, m, p, which)));
      continue;
    }
    const auto& old_uvs = from.uv[(m.*which)->uv_set];
    const auto& new_uvs = to.uv[(p.*which)->uv_set];
    REQUIRE(old_uvs.size() == new_uvs.size());
    for (std::size_t t = 0; t < old_uvs.size(); t += std::max<std::size_t>(1, old_uvs.size() / 2000))
      for (std::size_t k = 0; k < 3; ++k) {
        const auto a = found(old_pictures, m, which, old_uvs[t][k]);
        const auto b = found(new_pictures, p, which, new_uvs[t][k]);
        for (std::size_t c = first; c < first + channels; ++c) worst = std::max(worst, std::abs(a[c] - b[c]));
      }
  }
  return worst;
}

// Bytes on a GPU with all mips of the pictures that a document names, each file once; counted here again.
std::uint64_t gpu_bytes(const GltfScene& scene) {
  std::uint64_t out = 0;
  std::set<std::string> seen;
  for (const PictureFile& image : scene.images) {
    if (!image.path.empty() && !seen.insert(image.path).second) continue;
    const Image8 picture = picture_of(image);
    const std::uint64_t texel = picture.channels < 3 ? static_cast<std::uint64_t>(picture.channels) : 4;
    for (int w = picture.width, h = picture.height;; w = std::max(1, w / 2), h = std::max(1, h / 2)) {
      out += texel * static_cast<std::uint64_t>(w) * static_cast<std::uint64_t>(h);
      if (w == 1 && h == 1) break;
    }
  }
  return out;
}

// Bytes of a document's one buffer that neither an accessor nor an image inside reads.
std::size_t dead_bytes(const nlohmann::json& document) {
  std::vector<bool> read(document["buffers"][0]["byteLength"].get<std::size_t>(), false);
  const auto mark = [&](const nlohmann::json& view, std::size_t from, std::size_t length) {
    const std::size_t begin = view.value("byteOffset", std::size_t{0}) + from;
    for (std::size_t i = begin; i < begin + length; ++i) read.at(i) = true;
  };
  const std::map<int, std::size_t> sizes{{5120, 1}, {5121, 1}, {5122, 2}, {5123, 2}, {5125, 4}, {5126, 4}};
  const std::map<std::string, std::size_t> counts{
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
  for (const auto& accessor : document["accessors"]) {
    const auto& view = document["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::size_t size = sizes.at(accessor["componentType"]) * counts.at(accessor["type"]);
    const std::size_t stride = view.value("byteStride", size);
    for (std::size_t i = 0; i < accessor["count"].get<std::size_t>(); ++i)
      mark(view, accessor.value("byteOffset", std::size_t{0}) + i * stride, size);
  }
  if (document.contains("images"))
    for (const auto& image : document["images"])
      if (image.contains("bufferView")) {
        const auto& view = document["bufferViews"][image["bufferView"].get<std::size_t>()];
        mark(view, 0, view["byteLength"]);
      }
  return static_cast<std::size_t>(std::count(read.begin(), read.end(), false));
}

}  // namespace

TEST_CASE("bytes of a texture on a GPU, by hand") {
  CHECK(texture_bytes({4, 2, 1}, false) == 8);
  CHECK(texture_bytes({4, 2, 1}, true) == 8 + 2 + 1);
  CHECK(texture_bytes({4, 4, 2}, false) == 32);
  CHECK(texture_bytes({4, 4, 3}, false) == 64);
  CHECK(texture_bytes({4, 4, 4, 16}, false) == 128);
}

TEST_CASE("the smallest form of real scenes takes less than they do, and every texture says the same") {
  if (!asset("")) return;
  double shares = 0;
  for (const std::string& name : real_models) {
    const TempFolder folder;
    PackOptions options;
    options.output.smallest_form = true;
    const PackResult report = pack_scene(*asset(name), folder.file("out"), true, options);
    const GltfScene before = read_gltf(*asset(name), {}),
                    after = read_gltf(folder.file("out/scene.gltf"), {});
    INFO(name);
    REQUIRE(report.totals);
    CHECK(PackTotals::all(report.totals->input).gpu == gpu_bytes(before));
    CHECK(report.totals->scene->gpu == gpu_bytes(after));
    const auto written = std::find_if(report.forms.begin(), report.forms.end(),
                                      [](const FormCost& form) { return form.written; });
    REQUIRE(written != report.forms.end());
    CHECK(written->exact);
    CHECK(written->gpu == gpu_bytes(after));
    for (const FormCost& form : report.forms) CHECK((!form.exact || form.gpu >= written->gpu));
    const double share = static_cast<double>(gpu_bytes(after)) / static_cast<double>(gpu_bytes(before));
    CHECK(share < 1);
    if (has_validator()) CHECK(validator_errors(folder.file("out/scene.gltf"), {folder.file("out")}).empty());
    const auto document = nlohmann::json::parse(slurp(folder.file("out/scene.gltf")));
    // What aligns the views.
    CHECK(dead_bytes(document) <= 8 * document["bufferViews"].size());
    shares += share / static_cast<double>(real_models.size());
    // Occlusion is red alone; normals and light three channels.
    CHECK(worst_texture(before, after, &GltfMaterial::occlusion_texture, 0, 1) <= uv_rounding);
    CHECK(worst_texture(before, after, &GltfMaterial::normal_texture, 0, 3) <= uv_rounding);
    CHECK(worst_texture(before, after, &GltfMaterial::emissive_texture, 0, 3) <= uv_rounding);
    if (written->form != GltfForm::metal_rough) continue;
    CHECK(worst_texture(before, after, &GltfMaterial::base_color_texture, 0, 3) <= uv_rounding);
    CHECK(worst_texture(before, after, &GltfMaterial::metallic_roughness_texture, 1, 2) <= uv_rounding);
    for (std::size_t i = 0; i < after.materials.size(); ++i) {
      const auto& m = after.materials[i];
      const auto old = std::find_if(before.materials.begin(), before.materials.end(),
                                    [&](const GltfMaterial& each) { return each.name == m.name; });
      REQUIRE(old != before.materials.end());
      if (!m.base_color_texture) continue;
      CHECK(m.base_color == old->base_color);
      CHECK(m.metallic == old->metallic);
      CHECK(m.roughness == old->roughness);
    }
  }
  CHECK(shares <= 0.8);
}

TEST_CASE("what textures weigh: bytes of one kind, or shares of the input's") {
  const TextureTotals input{4, 1000, 8000}, small{1, 100, 4000};
  CHECK(TextureWeight(PackGoal::gpu, input)(small) == 4000);
  CHECK(TextureWeight(PackGoal::disk, input)(small) == 100);
  CHECK(TextureWeight(PackGoal::both, input)(small) == Approx(0.1 + 0.5));
  CHECK(TextureWeight(PackGoal::both, {})(small) > 0);
}

TEST_CASE(
    "the goal disk leaves no more bytes of textures than were given, and says so before they are written") {
  if (!asset("")) return;
  for (const std::string& name : real_models) {
    INFO(name);
    std::map<PackGoal, TextureTotals> scene;
    TextureTotals input;
    for (const PackGoal goal : {PackGoal::gpu, PackGoal::disk, PackGoal::both}) {
      const TempFolder folder;
      PackOptions options;
      options.output.smallest_form = true;
      options.output.goal = goal;
      const PackResult report = pack_scene(*asset(name), folder.file("out"), true, options);
      REQUIRE(report.totals);
      scene[goal] = *report.totals->scene;
      input = PackTotals::all(report.totals->input);
      const auto written = std::find_if(report.forms.begin(), report.forms.end(),
                                        [](const FormCost& form) { return form.written; });
      REQUIRE(written != report.forms.end());
      CHECK(written->gpu == scene[goal].gpu);
      CHECK(written->disk.has_value() == (goal != PackGoal::gpu));
      if (written->disk) CHECK(*written->disk == scene[goal].disk);
      if (goal != PackGoal::disk) continue;
      if (has_validator())
        CHECK(validator_errors(folder.file("out/scene.gltf"), {folder.file("out")}).empty());
      const GltfScene before = read_gltf(*asset(name), {}),
                      after = read_gltf(folder.file("out/scene.gltf"), {});
      CHECK(worst_texture(before, after, &GltfMaterial::occlusion_texture, 0, 1) <= uv_rounding);
      CHECK(worst_texture(before, after, &GltfMaterial::normal_texture, 0, 3) <= uv_rounding);
      if (written->form != GltfForm::metal_rough) continue;
      CHECK(worst_texture(before, after, &GltfMaterial::base_color_texture, 0, 3) <= uv_rounding);
      CHECK(worst_texture(before, after, &GltfMaterial::metallic_roughness_texture, 1, 2) <= uv_rounding);
    }
    CHECK(scene[PackGoal::disk].disk <= input.disk);
    CHECK(scene[PackGoal::disk].disk <= scene[PackGoal::gpu].disk);
    const TextureWeight both(PackGoal::both, input);
    CHECK(both(scene[PackGoal::both]) <= both(scene[PackGoal::gpu]));
    CHECK(both(scene[PackGoal::both]) <= both(scene[PackGoal::disk]));
  }
}

TEST_CASE("where the level of PNG is weighed files are smaller and every texture says the same") {
  if (!asset("")) return;
  const std::string name = "wicker_chair/WickerChair.gltf";
  std::vector<std::uint64_t> disk;
  for (const bool weighed : {false, true}) {
    const TempFolder folder;
    PackOptions options;
    options.output.forms = {GltfForm::metal_rough};
    if (weighed) options.output.write.png_level.reset();
    const PackResult report = pack_scene(*asset(name), folder.file("out"), true, options);
    disk.push_back(PackTotals::all(report.totals->output).disk);
    // Its samplers read mips, and small islands keep one level clean.
    CHECK(report.mixed_from == 1);
    CHECK(report_text(report, false).find("keep regions apart below level 1;") != std::string::npos);
    const GltfScene before = read_gltf(*asset(name), {}),
                    after = read_gltf(folder.file("out/scene.gltf"), {});
    CHECK(PackTotals::all(report.totals->output).gpu >= report.totals->scene->gpu);
    CHECK(report.totals->scene->gpu == gpu_bytes(after));
    CHECK(worst_texture(before, after, &GltfMaterial::base_color_texture, 0, 3) <= uv_rounding);
    CHECK(worst_texture(before, after, &GltfMaterial::normal_texture, 0, 3) <= uv_rounding);
  }
  CHECK(disk[1] < disk[0]);
}

TEST_CASE("pictures of the same bytes are kept as one file") {
  if (!asset("")) return;
  const TempFolder folder;
  PackOptions options;
  options.output.smallest_form = true;
  options.output.goal = PackGoal::disk;
  // The mixer has its metal and roughness a second time as its occlusion, as JPEG.
  const PackResult report = pack_scene(*asset("mixer/Mixer.gltf"), folder.file("out"), true, options);
  const GltfScene after = read_gltf(folder.file("out/scene.gltf"), {});
  REQUIRE(after.materials[0].occlusion_texture);
  REQUIRE(after.materials[0].metallic_roughness_texture);
  CHECK(after.materials[0].occlusion_texture->image == after.materials[0].metallic_roughness_texture->image);
  CHECK(report.totals->lossy.files == 3);
  CHECK_FALSE(report.mixed_from);  // its only region has no neighbour
  CHECK(report_text(report, false).find("lost detail to compression") != std::string::npos);
}

TEST_CASE("normal maps and occlusion of every form lie where the pair lies") {
  if (!asset("")) return;
  for (const GltfForm form : {GltfForm::specular_ior, GltfForm::specular_glossiness, GltfForm::metal_rough}) {
    const TempFolder folder;
    PackOptions options;
    options.output.forms = {form};
    const std::string name = "mixer/Mixer.gltf";
    (void)pack_scene(*asset(name), folder.file("out"), true, options);
    const GltfScene before = read_gltf(*asset(name), {}),
                    after = read_gltf(folder.file("out/scene.gltf"), {});
    CHECK(worst_texture(before, after, &GltfMaterial::occlusion_texture, 0, 1) <= uv_rounding);
    CHECK(worst_texture(before, after, &GltfMaterial::normal_texture, 0, 3) <= uv_rounding);
  }
}

TEST_CASE("roles of a document's images, in the order of the specification") {
  const auto roles = image_roles(
      R"({"images": [{"uri": "a.png"}, {"uri": "b%20c.png"}, {"uri": "d.png"}],
          "textures": [{"source": 0}, {"source": 1}],
          "materials": [{"normalTexture": {"index": 0}, "occlusionTexture": {"index": 1},
                         "pbrMetallicRoughness": {"metallicRoughnessTexture": {"index": 1}},
                         "extensions": {"KHR_materials_clearcoat": {"clearcoatTexture": {"index": 0}}}}]})",
      "s.gltf");
  REQUIRE(roles.size() == 3);
  CHECK(roles[0].file == "a.png");
  CHECK(roles[0].role == "normal, clearcoatTexture");
  CHECK(!roles[0].material);
  CHECK(roles[1].file == "b c.png");
  CHECK(roles[1].role == "occlusion, metal and roughness");
  CHECK(roles[1].material);
  CHECK(roles[2].is_unused());
}
