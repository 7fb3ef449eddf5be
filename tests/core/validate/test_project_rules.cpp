// SPDX-License-Identifier: Apache-2.0
// What a project asks for in its settings: texels for a unit of the scene, bits that are used, edges that continue.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>

#include "core/image/files/png.h"
#include "tests/core/judge/corpus.h"
#include "tests/core/scene/small_scene.h"
#include "tests/core/validate/checked.h"
#include "tests/core/validate/planted_sets.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr int tile_side = 96;

// Waves of whole numbers of periods, which continue over the edges; stretched, they do not.
Image8 waves(Random& random, double stretch) {
  struct Wave {
    int x, y;
    double phase, height;
  };
  std::vector<Wave> all;
  for (int i = 0; i < 6; ++i)
    all.push_back({random.below(7) - 3, random.below(7) - 3, 7 * random.unit(), 8 + 10 * random.unit()});
  all.front().x = 1 + random.below(3);  // some wave runs along each axis
  all.back().y = 1 + random.below(3);
  const int noise = random.below(6);
  Image8 out(tile_side, tile_side, 3);
  each_texel(out, [&](auto texel, int x, int y) {
    double sum = 128;
    for (const Wave& wave : all)
      sum += wave.height *
             std::sin(wave.phase + 2 * std::numbers::pi * stretch * (wave.x * x + wave.y * y) / tile_side);
    for (std::size_t c = 0; c < 3; ++c)
      texel[c] = to_byte(sum + 5 * static_cast<double>(c) + random.below(noise + 1));
  });
  return out;
}

template <class Value>
std::string png_file(const Pixels<Value>& image) {
  return png_bytes(PngRows(image), {});
}

Settings with_limit(const std::string& rule, const std::string& parameter, double value) {
  Settings out;
  out.rules[rule].parameters[parameter] = value;
  return out;
}

CheckedFile check_picture(const std::string& bytes, const Settings& settings,
                          FileRole role = FileRole::base_color) {
  CheckTarget target;
  target.files = {{role, "", "wall.png", false}};
  target.files.front().bytes = std::make_shared<const std::string>(bytes);
  return checked(target, settings);
}

bool says(const CheckedFile& file, std::string_view rule) {
  return find(file, rule) != nullptr;
}

// Rows of codes of 16 bits that follow from 8-bit ones.
std::string wide_png(const Image8& from, const std::function<int(int)>& wide) {
  Image16 out(from.width, from.height, from.channels);
  for (std::size_t i = 0; i < from.values.size(); ++i)
    out.values[i] = static_cast<std::uint16_t>(wide(from.values[i]));
  return png_file(out);
}

// A square of `size` units with UVs over `periods` of a texture of 64 x 64, as one .gltf file.
std::string scene_file(double size, double periods) {
  const auto s = static_cast<float>(size), p = static_cast<float>(periods);
  const std::string buffer = bytes_of<float>({0, 0, 0, s, 0, 0, s, s, 0, 0, s, 0}) +
                             bytes_of<float>({0, 0, p, 0, p, p, 0, p}) +
                             bytes_of<std::uint16_t>({0, 1, 2, 0, 2, 3});
  return quad_json(
      R"([{"name":"stone","pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0}}}])",
      R"("images":[{"uri":"a.png"}],"textures":[{"source":0}],)",
      "\"uri\":\"data:;base64," + base64(buffer) + "\",");
}

CheckedFile check_scene_file(const TempFolder& folder, const std::string& json, const Settings& settings) {
  spit(folder.file("s.gltf"), json);
  CheckTarget target;
  target.files = {{FileRole::scene, folder.file("s.gltf"), "s.gltf", false}};
  return checked(target, settings);
}

}  // namespace

TEST_CASE("16 bits that hold 8 are found in every picture, and in none that uses them") {
  Random random(715);
  for (int i = 0; i < 40; ++i) {
    const Image8 codes = waves(random, 1);
    const CheckedFile repeated = check_picture(wide_png(codes, [](int v) { return 257 * v; }), {}),
                      shifted = check_picture(wide_png(codes, [](int v) { return 256 * v; }), {}),
                      whole = check_picture(
                          wide_png(codes, [&](int v) { return 256 * v + random.below(256); }), {}),
                      narrow = check_picture(png_file(codes), {});
    REQUIRE(says(repeated, "ETK715"));
    CHECK(find(repeated, "ETK715")->severity == Severity::info);
    CHECK(find(repeated, "ETK715")->file == "wall.png");
    CHECK(says(shifted, "ETK715"));
    CHECK_FALSE((says(whole, "ETK715") || says(narrow, "ETK715")));
  }
  const Image8 flat(8, 8, 3, 255);
  CHECK_FALSE(says(check_picture(wide_png(flat, [](int v) { return 257 * v; }), {}), "ETK715"));
}

TEST_CASE("seams are found where a project says that its textures tile, and nowhere else") {
  const Settings asked = with_limit("ETK716", "times", 1.5);
  Random random(716);
  int found_of_cut = 0, found_of_whole = 0;
  constexpr int count = 60;
  for (int i = 0; i < count; ++i) {
    const std::string whole = png_file(waves(random, 1)),
                      cut = png_file(waves(random, 0.55 + 0.3 * random.unit()));
    found_of_whole += says(check_picture(whole, asked), "ETK716");
    const CheckedFile of_cut = check_picture(cut, asked);
    found_of_cut += says(of_cut, "ETK716");
    CHECK_FALSE(says(check_picture(cut, {}), "ETK716"));
    if (const Finding* finding = find(of_cut, "ETK716")) CHECK(finding->severity == Severity::warning);
  }
  CHECK(found_of_whole == 0);
  CHECK(100 * found_of_cut >= 95 * count);
  CHECK(says(check_picture(png_file(waves(random, 0.7)), asked, FileRole::normal), "ETK716"));
}

TEST_CASE("of a scene, seams are judged of pictures that its UVs repeat") {
  const TempFolder folder;
  Random random(3);
  spit(folder.file("a.png"), png_file(waves(random, 0.6)));
  const Settings asked = with_limit("ETK716", "times", 1.5);
  CHECK(says(check_scene_file(folder, scene_file(1, 3), asked), "ETK716"));
  CHECK_FALSE(says(check_scene_file(folder, scene_file(1, 1), asked), "ETK716"));
  const std::string clamped =
      replaced(replaced(scene_file(1, 3), R"({"source":0})", R"({"source":0,"sampler":0})"), R"("images")",
               R"("samplers":[{"wrapS":33071,"wrapT":33648}],"images")");
  CHECK_FALSE(says(check_scene_file(folder, clamped, asked), "ETK716"));
}

TEST_CASE(
    "texels for a unit of the scene are those of the picture over the size that its triangles have there") {
  const TempFolder folder;
  Random random(16);
  spit(folder.file("a.png"), png_file(waves(random, 1)));  // 96 x 96
  for (int i = 0; i < 30; ++i) {
    const double size = random.between(0.2, 6), periods = random.between(0.3, 4),
                 texels = 96 * periods / size;
    const double wanted = random.between(8, 600);
    const CheckedFile file =
        check_scene_file(folder, scene_file(size, periods), with_limit("ETK016", "colour_texels", wanted));
    CAPTURE(size, periods, texels, wanted);
    CHECK(says(file, "ETK016") == (texels > 2 * wanted || texels < wanted / 2));
    if (const Finding* finding = find(file, "ETK016")) {
      CHECK((finding->file == "a.png" && finding->material == "stone"));
      CHECK(std::stod(finding->value) == Approx(texels).epsilon(6e-3));
    }
    CHECK_FALSE(says(check_scene_file(folder, scene_file(size, periods), {}), "ETK016"));
  }
}

TEST_CASE("the spread is of the finest over the coarsest material of a scene") {
  const TempFolder folder;
  Random random(17);
  spit(folder.file("a.png"), png_file(waves(random, 1)));
  std::string two = replaced(
      scene_file(1, 1), R"([{"name":"stone",)",
      R"([{"name":"wood","pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0}}},{"name":"stone",)");
  two = replaced(
      two, R"("material":0}]}])",
      R"("material":0}]},{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":1}]}])");
  two = replaced(two, R"("nodes":[0])", R"("nodes":[0,1])");
  two = replaced(two, R"("nodes":[{"mesh":0}])", R"("nodes":[{"mesh":0},{"mesh":1,"scale":[5,5,5]}])");
  CHECK(says(check_scene_file(folder, two, with_limit("ETK016", "spread", 4.9)), "ETK016"));
  CHECK_FALSE(says(check_scene_file(folder, two, with_limit("ETK016", "spread", 5.1)), "ETK016"));
}

TEST_CASE("sides are powers of two, or multiples of what a project asks for") {
  const std::string odd = png_file(Image8(96, 60, 3, 90)), pot = png_file(Image8(64, 32, 3, 90)),
                    loose = png_file(Image8(30, 64, 3, 90));
  const Settings fours = with_limit("ETK009", "multiple", 4);
  CHECK((says(check_picture(odd, {}), "ETK009") && !says(check_picture(odd, fours), "ETK009")));
  CHECK((!says(check_picture(pot, {}), "ETK009") && !says(check_picture(pot, fours), "ETK009")));
  CHECK(says(check_picture(loose, fours), "ETK009"));
}

TEST_CASE("right sets have nothing to tell of bits, and no project's rule without its limit") {
  for (const PlantedSet& set : right_sets(60, 12)) {
    const TempFolder folder;
    ValidationRequest request;
    for (const auto& [name, bytes] : set.files) spit(folder.file(name), bytes);
    request.inputs.paths = {folder.path()};
    request.run.door = picture_door();
    for (const CheckedFile& file : validate(std::move(request)).files)
      for (const Finding& finding : file.findings)
        CHECK((finding.rule != "ETK016" && finding.rule != "ETK715" && finding.rule != "ETK716"));
  }
}
