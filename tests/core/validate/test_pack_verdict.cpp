// SPDX-License-Identifier: Apache-2.0
// One verdict: what is said of a scene while it is packed is what is said of the scene itself.
#include <catch2/catch.hpp>
#include <filesystem>

#include "core/atlas/texels/page_pixels.h"
#include "core/pack/pack.h"
#include "tests/core/atlas/altered_models.h"
#include "tests/core/atlas/scene_support.h"
#include "tests/core/image/png_of.h"
#include "tests/core/judge/corpus.h"
#include "tests/core/scene/small_scene.h"
#include "tests/core/validate/scene_verdicts.h"

using namespace etak;
using namespace etak::test;

namespace {

PackOptions with_form(GltfForm form, bool islands) {
  PackOptions out;
  out.leave_out.islands = islands;
  out.output.forms = {form};
  return out;
}

constexpr GltfForm all_forms[] = {GltfForm::specular_ior, GltfForm::specular_glossiness,
                                  GltfForm::metal_rough};

// A square of the plane for each box of UVs: left, top, right, bottom.
std::vector<float> quads(const std::vector<std::array<float, 4>>& boxes) {
  std::vector<float> out;
  for (const auto& [left, top, right, bottom] : boxes)
    out.insert(out.end(), {left, top, right, top, right, bottom, left, top, right, bottom, left, bottom});
  return out;
}

// Steel plates of one texture, on two parts of it, each with a square of F0 in the forbidden zone, of 20 and
// 40 texels, and between them a larger one that nothing reads; a metal that is too dark all over; and a metal
// of numbers alone, in the zone too.
std::string write_defects(const TempFolder& folder) {
  Random random(1);
  Image8 color(256, 256, 3, 225), metal_rough(256, 256, 3, 255), dark(64, 64, 3, 90);
  for (std::size_t i = 1; i < metal_rough.values.size(); i += 3)
    metal_rough.values[i] = static_cast<std::uint8_t>(90 + random.below(60));
  const auto square = [&](int left, int top, int side) {
    for (int y = top; y < top + side; ++y)
      for (int x = left; x < left + side; ++x) std::ranges::fill(color.at(x, y), std::uint8_t{150});
  };
  square(10, 10, 20);
  square(190, 190, 40);
  square(90, 90, 60);
  spit(folder.file("color.png"), png_of(color));
  spit(folder.file("mr.png"), png_of(metal_rough));
  spit(folder.file("dark.png"), png_of(dark));
  const std::vector<float> plate = quads({{0.02f, 0.02f, 0.2f, 0.2f}, {0.7f, 0.7f, 0.95f, 0.95f}}),
                           whole = quads({{0, 0, 1, 1}});
  std::vector<float> positions;
  for (std::size_t i = 0; i < plate.size() / 2; ++i) {
    const float x = static_cast<float>(i % 2 + i / 6), y = static_cast<float>(i / 2 % 2);
    positions.insert(positions.end(), {x, y, 0});
  }
  const std::string buffer = bytes_of(positions) + bytes_of(plate) + bytes_of(whole);
  const std::size_t plate_at = bytes_of(positions).size(), whole_at = plate_at + bytes_of(plate).size();
  const auto view = [](std::size_t at, std::size_t length) {
    return R"({"buffer": 0, "byteOffset": )" + std::to_string(at) + R"(, "byteLength": )" +
           std::to_string(length) + "}";
  };
  const auto primitive = [](int position, int uv, int material) {
    return R"({"attributes": {"POSITION": )" + std::to_string(position) + R"(, "TEXCOORD_0": )" +
           std::to_string(uv) + R"(}, "material": )" + std::to_string(material) + "}";
  };
  const std::string path = folder.file("scene.gltf");
  spit(path,
       R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [)" +
           primitive(0, 2, 0) + ", " + primitive(1, 3, 1) + ", " + primitive(1, 3, 2) + R"(]}],
    "materials": [
      {"name": "plate", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 1}}},
      {"name": "dark", "pbrMetallicRoughness": {"baseColorTexture": {"index": 2}, "roughnessFactor": 0.4}},
      {"name": "number", "pbrMetallicRoughness": {"baseColorFactor": [0.3, 0.3, 0.3, 1], "roughnessFactor": 0.4}}],
    "textures": [{"source": 0}, {"source": 1}, {"source": 2}],
    "images": [{"uri": "color.png"}, {"uri": "mr.png"}, {"uri": "dark.png"}],
    "buffers": [{"byteLength": )" +
           std::to_string(buffer.size()) + R"(, "uri": "data:application/octet-stream;base64,)" +
           base64(buffer) + R"("}],
    "bufferViews": [)" +
           view(0, plate_at) + ", " + view(plate_at, whole_at - plate_at) + ", " +
           view(whole_at, buffer.size() - whole_at) + R"(],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 12, "type": "VEC3", "min": [0, 0, 0], "max": [2, 1, 0]},
      {"bufferView": 0, "componentType": 5126, "count": 6, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
      {"bufferView": 1, "componentType": 5126, "count": 12, "type": "VEC2"},
      {"bufferView": 2, "componentType": 5126, "count": 6, "type": "VEC2"}]})");
  return path;
}

const Finding* finding_about(const ValidationReport& report, std::string_view rule,
                             std::string_view material) {
  for (const CheckedFile& file : report.files)
    for (const Finding& f : file.findings)
      if (f.rule == rule && f.material == material) return &f;
  return nullptr;
}

}  // namespace

TEST_CASE(
    "a scene has one verdict: of its files, and while it is packed, in every form, with and without islands") {
  const TempFolder folder;
  const std::string scene = write_defects(folder);
  const ValidationReport input = said_of(scene);
  INFO("input\n" << text_of(told(input)));
  CHECK(finding_about(input, "ETK101", "plate") != nullptr);
  CHECK(finding_about(input, "ETK114", "dark") != nullptr);
  CHECK(finding_about(input, "ETK101", "number") != nullptr);
  for (const GltfForm form : all_forms)
    for (const bool islands : {false, true}) {
      const ValidationReport packed = said_while_packing(scene, folder.file("out"), with_form(form, islands));
      INFO("packed\n" << text_of(told(packed)));
      CHECK(told(packed) == told(input));
      CHECK(packed.passed == input.passed);
      std::filesystem::remove_all(folder.file("out"));
    }
}

TEST_CASE("a finding has its place on the page, of every island, and in UVs of the material's own textures") {
  const TempFolder folder;
  const std::string scene = write_defects(folder);
  const ValidationReport input = said_of(scene);
  for (const bool islands : {false, true})
    for (const bool rotate : {false, true}) {
      CAPTURE(islands, rotate);
      PackOptions options = with_form(GltfForm::specular_ior, islands);
      options.layout.rotate = rotate;
      Image8 page;
      const auto keep = [&](const AtlasLayout& layout, int p, const PagePixels& pixels) {
        if (p != 0 || layout.pages.empty()) return true;
        const PixelsView8 view = pixels.view(Texture::specular_gloss);
        page = Image8(view.width, view.height, 4);
        for (int y = 0; y < view.height; ++y) std::copy_n(view.row(y), 4 * view.width, page.at(0, y).data());
        return true;
      };
      const ValidationReport packed = said_while_packing(scene, folder.file("out"), options, keep);
      std::filesystem::remove_all(folder.file("out"));
      const Finding* found = finding_about(packed, "ETK101", "plate");
      REQUIRE(found != nullptr);
      CHECK(found->tile == "plate");
      CHECK(found->area_px == finding_about(input, "ETK101", "plate")->area_px);
      REQUIRE(found->box);
      REQUIRE(found->uv);
      CHECK(found->islands.size() == (islands ? 2 : 0));
      // Two texels around a region may be lost to its edge.
      const auto is_square = [&](const PixelBox& box, const UvBox& uv, int left, int side) {
        CHECK(box.width >= side - 4);
        CHECK(box.width <= side);
        CHECK(uv[0] * 256 >= left);
        CHECK(uv[2] * 256 <= left + side);
        for (int y = box.y; y < box.y + box.height; ++y)
          for (int x = box.x; x < box.x + box.width; ++x) REQUIRE(page.at(x, y)[0] == 150);
      };
      if (!islands) continue;
      is_square(*found->islands[0].box, *found->islands[0].uv, 10, 20);
      is_square(*found->islands[1].box, *found->islands[1].uv, 190, 40);
      CHECK(found->box == found->islands[1].box);
      CHECK(contains(place_of(*found), ":tile \"plate\" ["));
      CHECK(contains(place_of(*found), "(UV 0.7"));
      CHECK(contains(place_of(*found), "and 1 more island"));
      // Numbers have no place.
      const Finding* number = finding_about(packed, "ETK101", "number");
      REQUIRE(number != nullptr);
      CHECK(!number->box);
    }
}

TEST_CASE("what is judged of a packed scene is what its pages hold") {
  const TempFolder folder;
  const std::string scene = write_defects(folder);
  const auto spoil = [](const AtlasLayout& layout, int p, const PagePixels& pixels) {
    for (const AtlasRect& rect : layout.rects) {
      if (rect.page != p || rect.name != "dark") continue;
      const PixelsView8 view = pixels.view(Texture::specular_gloss);
      if (view.data == nullptr) continue;
      for (int y = rect.y; y < rect.y + rect.height; ++y)
        for (int x = rect.x; x < rect.x + rect.width; ++x) std::fill_n(view.at(x, y), 3, std::uint8_t{160});
    }
    return true;
  };
  PackOptions options;
  options.leave_out.keep = {"constant"};
  CHECK(finding_about(said_of(scene), "ETK101", "dark") == nullptr);
  CHECK(finding_about(said_while_packing(scene, folder.file("a"), options), "ETK101", "dark") == nullptr);
  CHECK(finding_about(said_while_packing(scene, folder.file("b"), options, spoil), "ETK101", "dark") !=
        nullptr);
}

TEST_CASE("the folder of a packed scene gets no remark on sides, alpha and mips, which its packer chose") {
  const TempFolder folder;
  const std::string scene = write_defects(folder);
  for (const GltfForm form : all_forms) {
    (void)said_while_packing(scene, folder.file("out"), with_form(form, true));
    const ValidationReport again = said_of(folder.file("out"));
    INFO(text_of(told(again)));
    CHECK(!again.incomplete);
    CHECK(finding_about(again, "ETK101", "plate") != nullptr);
    for (const auto& [rule, severity, material] : told(again)) {
      CHECK(rule != "ETK009");
      CHECK(rule != "ETK503");
      CHECK(rule != "ETK504");
    }
    std::filesystem::remove_all(folder.file("out"));
  }
}

TEST_CASE("real scenes have one verdict: of their files, and while they are packed") {
  if (!asset("")) return;
  for (const std::string& model : real_models) {
    const ValidationReport input = said_of(*asset(model));
    for (const bool islands : {false, true}) {
      const TempFolder folder;
      PackOptions options = with_form(GltfForm::specular_ior, islands);
      options.output.dry_run = true;
      const ValidationReport packed = said_while_packing(*asset(model), folder.file("out"), options);
      INFO(model << (islands ? " in islands" : "") << "\ninput\n"
                 << text_of(told(input)) << "packed\n"
                 << text_of(told(packed)));
      CHECK(told(packed) == told(input));
      CHECK(packed.passed == input.passed);
    }
  }
}

TEST_CASE("altered copies of real scenes have one verdict too") {
  if (!asset("")) return;
  for (std::size_t m = 0; m < real_models.size(); ++m)
    for (const Alteration& alteration : alterations_of(m)) {
      const std::string& model = real_models[m];
      const TempFolder folder;
      const std::string scene = altered_copy(*asset(model), alteration, PngLevel::fast, folder.path());
      const ValidationReport input = said_of(scene);
      PackOptions options = with_form(GltfForm::specular_ior, true);
      options.output.dry_run = true;
      const ValidationReport packed = said_while_packing(scene, folder.file("out"), options);
      INFO(model << ", " << alteration.name << "\ninput\n"
                 << text_of(told(input)) << "packed\n"
                 << text_of(told(packed)));
      CHECK(told(packed) == told(input));
      CHECK(packed.passed == input.passed);
    }
}
