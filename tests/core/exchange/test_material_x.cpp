// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "core/exchange/material_x.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

ExportSurface surface_named(const char* id) {
  ExportSurface s;
  s.id = id;
  s.name = id;
  return s;
}

std::string written_material_x(const std::vector<ExportSurface>& surfaces) {
  std::vector<Changes> changes;
  return material_x(surfaces, Fit::clamp, changes);
}

}  // namespace

TEST_CASE("a metal is F0 and the tint of F82 in an OpenPBR surface") {
  ExportSurface gold = surface_named("gold");
  gold.kind = SurfaceKind::metal;
  gold.f0 = {1.0428, 0.7738, 0.3347};
  gold.f82 = LinearRgb{0.9921, 0.8862, 0.6311};
  std::vector<Changes> changes;
  const std::string text = material_x(std::vector{gold}, Fit::clamp, changes);
  CHECK(contains(text, "<materialx version=\"1.39\" colorspace=\"lin_rec709\">"));
  CHECK(contains(
      text,
      R"(<input name="base_color" type="color3" value="1, 0.7738, 0.3347" colorspace="lin_rec709" />)"));
  CHECK(contains(text, R"(<input name="base_metalness" type="float" value="1" />)"));
  // 0.9921 / 1; 0.8862 / (0.7738 + 0.2262 (6/7)^5) = 1.0088, which ends at 1; 0.6311 / (0.3347 + 0.6653
  // (6/7)^5)
  CHECK(contains(
      text,
      R"(<input name="specular_color" type="color3" value="0.9921, 1, 0.9822406" colorspace="lin_rec709" />)"));
  CHECK(!contains(text, "specular_ior"));
  CHECK(contains(text, R"(<input name="surfaceshader" type="surfaceshader" nodename="gold_surface" />)"));
  REQUIRE(changes.size() == 1);
  REQUIRE(!changes[0].empty());
  CHECK(changes[0][0].field == "base_color");
  // What was changed stands in the file too.
  CHECK(contains(text, "<!-- base_color 1.043 0.7738 0.3347 -&gt; 1 0.7738 0.3347 (clamp, 0.0428)"));
}

TEST_CASE("surfaces of different spaces each state their own; one of a space without a name is refused") {
  ExportSurface wide = surface_named("wide"), other = surface_named("other");
  wide.space = RgbSpace::acescg;
  other.space = RgbSpace::rec2020;
  const std::string text = written_material_x({surface_named("plain"), wide});
  CHECK(contains(text, "<materialx version=\"1.39\" colorspace=\"lin_rec709\">"));
  const auto second = text.find("name=\"wide_surface\"");
  REQUIRE(second != text.npos);
  const std::string of_plain = text.substr(0, second), of_wide = text.substr(second);
  CHECK(contains(of_plain, "type=\"color3\""));
  CHECK(!contains(of_plain, "acescg"));
  CHECK(contains(of_wide, "colorspace=\"acescg\""));
  CHECK(!contains(of_wide, "lin_rec709"));
  CHECK(contains(error_of([&] { (void)written_material_x({surface_named("plain"), other}); }), "rec2020"));
}

TEST_CASE("a dielectric has an index and no F82") {
  const std::string text = written_material_x({surface_named("plastic")});
  CHECK(contains(text, R"(<input name="specular_ior" type="float" value="1.5" />)"));
  CHECK(contains(text, R"(<input name="base_metalness" type="float" value="0" />)"));
  CHECK(!contains(text, "geometry_opacity"));
}

TEST_CASE("names are valid, unique and never collide with a shader's") {
  const std::string text =
      written_material_x({surface_named("2nd glass"), surface_named("2nd-glass"), surface_named("a"),
                          surface_named("a_surface"), surface_named("a"), surface_named("")});
  for (const char* name : {"m2nd_glass", "m2nd_glass_2", "a", "a_surface_2", "a_2", "m"})
    CHECK(contains(text, "<surfacematerial name=\"" + std::string(name) + "\""));
}

TEST_CASE("foreign text cannot break the document") {
  ExportSurface s = surface_named("x");
  s.name = "<a> --> & \"b\" ---";
  s.source = "\xff -- end-";
  const std::string text = written_material_x({s});
  const auto begin = text.find("<!-- "), end = text.find(" -->", begin);
  REQUIRE(end != text.npos);
  const std::string inside = text.substr(begin + 4, end - begin - 4);
  CHECK(inside.find("--") == inside.npos);
  CHECK(inside.find('<') == inside.npos);
}

TEST_CASE("ACEScg and Display P3 are named, other spaces refused") {
  ExportSurface s = surface_named("x");
  s.space = RgbSpace::acescg;
  CHECK(contains(written_material_x({s}), "colorspace=\"acescg\""));
  s.space = RgbSpace::display_p3;
  CHECK(contains(written_material_x({s}), "colorspace=\"lin_displayp3\""));
  s.space = RgbSpace::rec2020;
  CHECK(contains(error_of([&] { (void)written_material_x({s}); }), "rec2020"));
}

TEST_CASE("pictures that repeat are tiled, and a normal map goes through the node of its space") {
  std::vector<Changes> changes;
  const std::vector<ExportSurface> surfaces{surface_named("wood")};
  MaterialXPictures pictures;
  pictures.geometry_normal = "n.png";
  pictures.scale = {3, 2.5};
  const std::string text = material_x(surfaces, Fit::clamp, changes, std::array{pictures});
  CHECK(contains(text, R"(  <tiledimage name="wood_geometry_normal" type="vector3">
    <input name="file" type="filename" value="n.png" />
    <input name="uvtiling" type="vector2" value="3, 2.5" />
    <input name="uvoffset" type="vector2" value="0, 0.5" />
  </tiledimage>
  <normalmap name="wood_geometry_normal_space" type="vector3">
    <input name="in" type="vector3" nodename="wood_geometry_normal" />
  </normalmap>
)"));
  CHECK(contains(text,
                 R"(<input name="geometry_normal" type="vector3" nodename="wood_geometry_normal_space" />)"));
}

TEST_CASE("pictures are image nodes before their surface, in place of its numbers") {
  std::vector<Changes> changes;
  const std::vector<ExportSurface> surfaces{surface_named("wood"), surface_named("plain")};
  const std::vector<MaterialXPictures> pictures{
      {"wood & oak.png", "", "wood_specular_roughness.png", "wood_geometry_opacity.png"}, {}};
  const std::string text = material_x(surfaces, Fit::clamp, changes, pictures);
  CHECK(contains(text, R"(  <image name="wood_base_color" type="color3">
    <input name="file" type="filename" value="wood &amp; oak.png" colorspace="srgb_texture" />
  </image>
)"));
  CHECK(contains(text, R"(  <image name="wood_specular_roughness" type="float">
    <input name="file" type="filename" value="wood_specular_roughness.png" />
  </image>
)"));
  const std::string of_wood = text.substr(0, text.find("</open_pbr_surface>"));
  CHECK(contains(of_wood, R"(<input name="base_color" type="color3" nodename="wood_base_color" />)"));
  CHECK(contains(of_wood,
                 R"(<input name="specular_roughness" type="float" nodename="wood_specular_roughness" />)"));
  CHECK(contains(of_wood,
                 R"(<input name="geometry_opacity" type="float" nodename="wood_geometry_opacity" />)"));
  CHECK(!contains(of_wood, R"(<input name="base_color" type="color3" value=)"));
  CHECK(contains(of_wood, R"(<input name="base_metalness" type="float" value="0" />)"));
  CHECK(of_wood.find("<image") < of_wood.find("<open_pbr_surface"));
  CHECK(!contains(text.substr(of_wood.size()), "<image"));
}
