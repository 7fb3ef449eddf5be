// SPDX-License-Identifier: Apache-2.0
// Pictures that stay beside the pages are written as what their texels need.
#include "core/pack/scene/kept_pictures.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "core/base/files/steady_file.h"
#include "core/image/files/png_keep.h"
#include "core/scene/gltf.h"
#include "tests/core/atlas/pack_support.h"
#include "tests/core/atlas/scene_support.h"
#include "tests/core/atlas/shaded_scenes.h"
#include "tests/core/scene/small_scene.h"
#include "tests/core/scene/written_scene.h"

using namespace etak;
using namespace etak::test;

namespace {

Image8 of_colour(int side, const std::vector<std::uint8_t>& texel) {
  Image8 out(side, side, static_cast<int>(texel.size()));
  for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] = texel[i % texel.size()];
  return out;
}

std::optional<OneTexel> texel_of(const Image8& image) {
  return one_texel_of(*rows_of(image));
}

// Two squares with base colours that vary; their normal maps and what one of them emits are of one colour.
std::string write_plain_scene(const TempFolder& folder) {
  save_png(folder.file("a.png"), noise(64, 64, 3, 1));
  save_png(folder.file("b.png"), noise(64, 64, 3, 2));
  save_png(folder.file("flat.png"), of_colour(64, {127, 127, 255}));
  save_png(folder.file("tilted.png"), of_colour(64, {150, 127, 250}));
  save_png(folder.file("light.png"), of_colour(64, {20, 30, 40}));
  const auto base = [](int texture) {
    return R"("pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0.4,"baseColorTexture":{"index":)" +
           std::to_string(texture) + "}}";
  };
  const std::string materials =
      R"([{"name":"flat",)" + base(0) + R"(,"normalTexture":{"index":2}},{"name":"tilted",)" + base(1) +
      R"(,"normalTexture":{"index":3},"emissiveTexture":{"index":4},"emissiveFactor":[1,1,1]}])";
  const std::string images =
      R"("images":[{"uri":"a.png"},{"uri":"b.png"},{"uri":"flat.png"},{"uri":"tilted.png"},{"uri":"light.png"}],)"
      R"("textures":[{"source":0},{"source":1},{"source":2},{"source":3},{"source":4}],)";
  const std::string one = R"({"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":0})";
  spit(folder.file("quad.bin"), unit_quad());
  spit(folder.file("scene.gltf"), replaced(quad_json(materials, images), one,
                                           one + "," + replaced(one, R"("material":0)", R"("material":1)")));
  return folder.file("scene.gltf");
}

}  // namespace

TEST_CASE("one texel stands for a picture of one colour, in its channels") {
  for (const std::vector<std::uint8_t>& texel :
       {std::vector<std::uint8_t>{9}, {9, 200}, {1, 2, 3}, {1, 2, 3, 4}}) {
    const Image8 image = of_colour(16, texel);
    const auto found = texel_of(image);
    REQUIRE(found);
    CHECK(found->header.channels == image.channels);
    CHECK(read_png8(found->file, "texel") == of_colour(1, texel));
    Image8 other = image;
    other.values.back() ^= 1;
    CHECK_FALSE(texel_of(other));
  }
  CHECK(texel_of(of_colour(16, {1, 2, 3}))->name != texel_of(of_colour(16, {1, 2, 4}))->name);
  CHECK_FALSE(texel_of(of_colour(1, {1, 2, 3})));  // it is one already
}

TEST_CASE("scene.gltf reads one texel of pictures of one colour, and looks the same") {
  for (const bool keep : {false, true}) {
    CAPTURE(keep);
    const TempFolder folder;
    const std::string scene = write_plain_scene(folder);
    PackOptions options;
    options.output.smallest_form = true;
    if (keep) options.leave_out.keep.insert("files");
    const PackResult report = pack_scene(scene, folder.file("out"), false, options);
    const GltfScene packed = read_gltf(folder.file("out/scene.gltf"), {});
    ReadPictures pictures(packed);
    REQUIRE(packed.materials.size() == 2);
    const GltfMaterial &flat = packed.materials[0], &tilted = packed.materials[1];
    REQUIRE(flat.normal_texture);
    REQUIRE(tilted.normal_texture);
    REQUIRE(tilted.emissive_texture);
    const bool told = std::any_of(report.remarks.begin(), report.remarks.end(), [](const std::string& line) {
      return contains(line, "flat.png: is of one colour");
    });
    CHECK(told == !keep);
    if (!keep) {
      CHECK(pictures(flat.normal_texture->image) == of_colour(1, {127, 127, 255}));
      CHECK(pictures(tilted.normal_texture->image) == of_colour(1, {150, 127, 250}));
      CHECK(pictures(tilted.emissive_texture->image) == of_colour(1, {20, 30, 40}));
      for (const char* name : {"flat.png", "tilted.png", "light.png"})
        CHECK_FALSE(std::filesystem::exists(folder.file("out/" + std::string(name))));
    }
    const ShadedDifference found = shaded_difference(scene, folder.file("out/scene.gltf"), 2000);
    CHECK(found.nearest <= 1);
    CHECK(found.bilinear <= 1);
    if (has_validator()) CHECK(validator_errors(folder.file("out/scene.gltf"), {folder.file("out")}).empty());
  }
}

TEST_CASE(
    "without its flat normal map a polished surface would not look the same: the map stays as one texel") {
  // Half a code of tilt, which no map of 8 bits can avoid, moves highlights by a quarter of a degree.
  const TempFolder folder;
  const std::string scene = write_plain_scene(folder);
  spit(folder.file("without.gltf"), replaced(slurp(scene), R"(,"normalTexture":{"index":2})", ""));
  CHECK(shaded_difference(scene, folder.file("without.gltf"), 2000).nearest > 1);
}

TEST_CASE("what kept PNG files say beside their texels is left out, and is weighed so") {
  if (!asset("")) return;
  const std::string model = *asset("flight_helmet/FlightHelmet.gltf");
  for (const bool keep : {false, true}) {
    CAPTURE(keep);
    const TempFolder folder;
    PackOptions options;
    options.output.forms = {GltfForm::metal_rough};
    options.output.goal = PackGoal::disk;
    if (keep) options.leave_out.keep.insert("files");
    const PackResult report = pack_scene(model, folder.file("out"), false, options);
    const auto written = std::find_if(report.forms.begin(), report.forms.end(),
                                      [](const FormCost& each) { return each.written; });
    REQUIRE(written != report.forms.end());
    CHECK(written->disk == report.totals->scene->disk);
    const double share = static_cast<double>(report.totals->scene->disk) /
                         static_cast<double>(PackTotals::all(report.totals->input).disk);
    CHECK((keep ? share <= 1 : share < 0.96));
    const GltfScene packed = read_gltf(folder.file("out/scene.gltf"), {});
    for (const PictureFile& image : packed.images) {
      const std::string file = slurp(image.path);
      BytesInMemory bytes(file);
      if (!keep) CHECK(texels_alone(bytes) == file);
      const std::string original = std::filesystem::path(model)
                                       .replace_filename(std::filesystem::path(image.path).filename())
                                       .string();
      if (std::filesystem::exists(original)) CHECK(load_png(image.path) == load_png(original));
    }
  }
}
