// SPDX-License-Identifier: Apache-2.0
// etak pack FOLDER by the conventions of names that etak validate knows.
#include <catch2/catch.hpp>
#include <filesystem>

#include "core/image/files/png.h"
#include "core/pack/pack.h"
#include "core/pack/source.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

void put(const TempFolder& folder, std::initializer_list<const char*> names, int channels = 3) {
  for (const char* name : names) spit(folder.file(name), png_bytes(Image8(4, 4, channels, 128), {}));
}

AtlasManifest manifest(const TempFolder& folder, std::vector<std::string>* remarks = nullptr) {
  std::vector<std::string> skipped, told;
  AtlasManifest out = manifest_of_names(folder.path(), PictureDoor{}, skipped, told);
  if (remarks != nullptr) *remarks = told;
  return out;
}

// The file's name behind the folder, with the channels that are taken.
std::string said(const std::optional<TextureSource>& source) {
  if (!source) return "none";
  const auto& image = std::get<ImageSource>(*source);
  return image.path.substr(image.path.rfind('/') + 1) + (image.channels.empty() ? "" : ":" + image.channels);
}

}  // namespace

TEST_CASE("single maps, packed maps and tiles of a folder become materials by their names") {
  const TempFolder folder;
  put(folder, {"crate_BaseColor.png", "crate_Roughness.png", "crate_Metallic.png", "crate_Normal.png",
               "T_Wall_D.png", "T_Wall_ORM.png", "T_Wall_N.png", "floor_albedo.1001.png",
               "floor_orm.1001.png", "floor_albedo.1002.png", "floor_orm.1002.png", "notes_preview.png"});
  put(folder, {"Door_AlbedoTransparency.png", "Door_MetallicSmoothness.png"}, 4);
  const AtlasManifest m = manifest(folder);
  std::vector<std::string> names;
  for (const ManifestMaterial& each : m.materials) names.push_back(each.name);
  REQUIRE(names == std::vector<std::string>{"Door", "T_Wall", "crate", "floor.1001", "floor.1002"});
  CHECK(said(m.materials[0].base_color) == "Door_AlbedoTransparency.png");
  CHECK(said(m.materials[0].alpha) == "Door_AlbedoTransparency.png:a");
  CHECK(said(m.materials[0].metallic) == "Door_MetallicSmoothness.png:r");
  CHECK(said(m.materials[0].gloss) == "Door_MetallicSmoothness.png:a");
  CHECK(m.gloss == GlossForm::one_minus_roughness);
  CHECK(said(m.materials[1].roughness) == "T_Wall_ORM.png:g");
  CHECK(said(m.materials[1].metallic) == "T_Wall_ORM.png:b");
  CHECK(m.materials[1].normal == folder.file("T_Wall_N.png"));
  CHECK(said(m.materials[2].roughness) == "crate_Roughness.png");
  CHECK(said(m.materials[2].metallic) == "crate_Metallic.png");
  CHECK(said(m.materials[4].base_color) == "floor_albedo.1002.png");
}

TEST_CASE("the newest version of a part is packed, and a folder may be named by the role") {
  const TempFolder folder;
  std::filesystem::create_directories(folder.file("basecolor"));
  std::filesystem::create_directories(folder.file("roughness"));
  put(folder, {"basecolor/oak.png", "roughness/oak.png", "fir_basecolor_v002.png", "fir_basecolor_v010.png",
               "fir_roughness.png"});
  const AtlasManifest m = manifest(folder);
  REQUIRE(m.materials.size() == 2);
  CHECK(said(m.materials[0].base_color) == "fir_basecolor_v010.png");
  CHECK(m.materials[1].name == "oak");
  CHECK(m.materials[1].base_color);
}

TEST_CASE("a set that is not whole is left out and told, and a folder without a whole one is an error") {
  const TempFolder folder;
  put(folder, {"a_basecolor.png"});
  CHECK(contains(error_of([&] { (void)manifest(folder); }), "a base colour without roughness and metallic"));
  put(folder, {"b_basecolor.png", "b_orm.png"});
  std::vector<std::string> remarks;
  CHECK(manifest(folder, &remarks).materials.size() == 1);
  REQUIRE(remarks.size() == 1);
  CHECK(contains(remarks[0], "a_basecolor.png: a base colour without roughness and metallic"));
}

TEST_CASE("a folder whose known names follow the packer's own pattern keeps Schueler's gloss") {
  const TempFolder folder;
  put(folder, {"wood_diffuse.png", "wood_specular.png", "wood_gloss.png", "wood_preview.png"});
  std::vector<std::string> remarks;
  std::string pattern;
  PackOptions options;
  CHECK(manifest_in_folder(folder.path(), options, remarks, pattern).gloss == GlossForm::schueler);
  CHECK(pattern == default_pattern);
  put(folder, {"crate_BaseColor.png", "crate_Roughness.png", "crate_Metallic.png"});
  CHECK(manifest_in_folder(folder.path(), options, remarks, pattern).gloss == GlossForm::one_minus_roughness);
  CHECK(pattern.empty());
}
