// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "core/atlas/manifest.h"
#include "core/color/srgb.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

std::string fault(const std::string& text) {
  return error_of([&] { (void)parse_manifest(text, "m.json"); });
}

std::string one(const std::string& members) {
  return R"({"materials": [{"name": "a", )" + members + "}]}";
}

}  // namespace

TEST_CASE("a source is a file, a library material, a number, a colour, or an object that says more") {
  const AtlasManifest m = parse_manifest(
      R"({"gloss": "roughness", "materials": [{"name": "a", "diffuse": "#0a141e", "specular": "gold", "gloss": 0.5,
      "alpha": {"image": "x/y.png", "channels": "a"}, "width": 8, "height": 4}]})",
      "folder/m.json");
  REQUIRE(m.gloss == GlossForm::roughness);
  const ManifestMaterial& a = m.materials.at(0);
  CHECK(std::get<ConstantSource>(*a.diffuse).codes == Srgb8{10, 20, 30});
  CHECK(std::get<LibrarySource>(*a.specular).material == "gold");
  CHECK(std::get<ConstantSource>(*a.gloss).linear == LinearRgb{0.5, 0.5, 0.5});
  CHECK(std::get<ImageSource>(*a.alpha) == ImageSource{"folder/x/y.png", "a", ""});
  CHECK(a.width == 8);
}

TEST_CASE("materials come in the order of their names, however the file lists them") {
  const AtlasManifest m = parse_manifest(
      R"({"materials": [{"name": "b", "specular": 0.04, "gloss": 1}, {"name": "a", "specular": 0.04, "gloss": 1}]})",
      "m.json");
  CHECK(m.materials[0].name == "a");
  CHECK(m.materials[1].name == "b");
}

TEST_CASE("a manifest that is wrong is told where") {
  CHECK(contains(fault("{"), "m.json"));
  CHECK(fault(R"({"materials": []})") == "m.json#/materials: no material; expected at least one");
  CHECK(contains(fault(one(R"("gloss": 1)")), "m.json#/materials/0: no \"specular\""));
  CHECK(contains(fault(one(R"("specular": 0.04)")), "no \"gloss\""));
  CHECK(contains(fault(one(R"("specular": 2.5, "gloss": 1)")),
                 "#/materials/0/specular: 2.5; expected a number from 0 to 2"));
  CHECK(contains(fault(one(R"("specular": 0.04, "diffuse": 1.5, "gloss": 1)")),
                 "#/materials/0/diffuse: 1.5; expected a number from 0 to 1"));
  CHECK(contains(fault(one(R"("specular": [1, 0], "gloss": 1)")), "expected [r, g, b]"));
  CHECK(contains(fault(one(R"("specular": "#12", "gloss": 1)")), "#rrggbb"));
  CHECK(contains(fault(one(R"("specular": 0.04, "gloss": "gold")")), "no file name"));
  CHECK(contains(fault(one(R"("specular": 0.04, "gloss": 1, "roughness": 1)")), "one of the two"));
  CHECK(contains(fault(one(R"("specular": 0.04, "gloss": 1, "basecolor": 1)")), "one way of the two"));
  CHECK(contains(fault(one(R"("specular": 0.04, "gloss": 1, "width": 0)")), "/width"));
  CHECK(contains(fault(one(R"("specular": {"image": "a.png", "channels": "rg"}, "gloss": 1)")),
                 "three of the letters"));
  CHECK(contains(fault(one(R"("specular": 0.04, "gloss": 1, "shine": 1)")), "unknown key"));
  CHECK(contains(
      fault(
          R"({"materials": [{"name": "a", "specular": 0, "gloss": 1}, {"name": "a", "specular": 0, "gloss": 1}]})"),
      "#/materials/1: a second material \"a\""));
}

TEST_CASE("the files of a folder that follow the pattern make up its materials") {
  const TempFolder folder;
  for (const char* name :
       {"brick_wall_diffuse.png", "brick_wall_specular.png", "brick_wall_gloss.png", "brick_wall_normal.png",
        "iron_basecolor.png", "iron_metallic.png", "iron_roughness.png", "notes.txt", "iron_preview.png"})
    spit(folder.file(name), "");
  const AtlasManifest m = manifest_of_folder(folder.path(), "{name}_{role}.png");
  REQUIRE(m.materials.size() == 2);
  CHECK(m.materials[0].name == "brick_wall");
  CHECK(m.materials[0].diffuse);
  CHECK(m.materials[0].normal == folder.file("brick_wall_normal.png"));
  CHECK(m.materials[1].name == "iron");
  CHECK(m.materials[1].metallic);
  CHECK(contains(error_of([&] { (void)manifest_of_folder(folder.path(), "{name}.png"); }),
                 "pattern: {name}.png; expected"));
  CHECK(contains(error_of([&] { (void)manifest_of_folder(folder.path(), "{role}-{name}.exr"); }),
                 "no file follows"));
  spit(folder.file("half_diffuse.png"), "");
  CHECK(contains(error_of([&] { (void)manifest_of_folder(folder.path(), "{name}_{role}.png"); }),
                 "half: no picture of the role specular or basecolor"));
}
