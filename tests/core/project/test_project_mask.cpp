// SPDX-License-Identifier: Apache-2.0
#include "core/project/project_mask.h"

#include <catch2/catch.hpp>

#include "core/project/project_pack.h"
#include "core/project/project_pictures.h"
#include "tests/core/atlas/pack_support.h"

using namespace etak;
using namespace etak::test;

namespace {

// Iron and red paint, and a mask of three patches whose edges are two texels wide.
Project paint_and_iron() {
  Project out;
  ProjectMaterial paint, iron;
  paint.name = "Red paint";
  paint.diffuse = {0.3, 0.02, 0.015};
  paint.specular = {0.05, 0.05, 0.05};
  paint.gloss = Gloss::of_roughness(0.35);
  paint.alpha_mode = AlphaMode::opaque;
  iron.name = "Iron";
  iron.measured = MeasuredF0{"iron", {}, {}, {}};
  iron.diffuse = {0, 0, 0};
  iron.gloss = 0.7;
  out.materials = {paint, iron};
  resolve(out, built_in_library());
  return out;
}

MaskedMaterial worn_steel(const TempFolder& folder) {
  Image8 mask(64, 64, 1, 0);
  for (int y = 20; y < 44; ++y)
    for (int x = 20; x < 44; ++x) mask.at(x, y)[0] = x == 20 || y == 20 || x == 43 || y == 43 ? 140 : 255;
  save_png(folder.file("wear.png"), mask);
  return {
      "Worn steel", folder.file("wear.png"), false, {{{0, 0, 0}, "Red paint"}, {{255, 255, 255}, "Iron"}}};
}

}  // namespace

TEST_CASE("what the project writes of a mask is what etak pack writes by its manifest, byte for byte") {
  const TempFolder folder;
  const Project project = paint_and_iron();
  std::vector<std::string> remarks;
  const ProjectMaterial made =
      write_masked(worn_steel(folder), project, built_in_library(), {}, folder.path(), false, remarks);
  CHECK(masked_files_in(folder.path(), worn_steel(folder)).size() == 7);
  const std::string text = slurp(folder.file("worn_steel.mask.json"));
  CHECK(contains(text, "\"material\": \"iron\""));
  (void)pack(folder.file("worn_steel.mask.json"), folder.file("out"), {}, built_in_library());
  for (const std::string_view ending : mask_file_endings)
    CHECK(slurp(folder.file("worn_steel" + std::string(ending))) ==
          slurp(folder.file("out/worn_steel" + std::string(ending))));

  // The material of the project, which reads these files, packs to the same pages.
  Project with;
  with.materials = {made};
  (void)pack(packed_manifest(with, built_in_library()), "p.json", folder.file("other"), {},
             built_in_library());
  for (const char* page : {"page0_diffuse_alpha.png", "page0_specular_gloss.png"})
    CHECK(slurp(folder.file("out/" + std::string(page))) == slurp(folder.file("other/" + std::string(page))));
  CHECK(masked_pair(manifest_of(worn_steel(folder), project, built_in_library()), built_in_library(), {})
            .specular_gloss == pictures_of(made, built_in_library(), {}).specular_gloss);
}

TEST_CASE("files that are there are replaced only where that is wanted") {
  const TempFolder folder;
  const Project project = paint_and_iron();
  std::vector<std::string> remarks;
  spit(folder.file("worn_steel_gloss.png"), "mine");
  const auto write = [&](bool overwrite) {
    (void)write_masked(worn_steel(folder), project, built_in_library(), {}, folder.path(), overwrite,
                       remarks);
  };
  CHECK(contains(error_of([&] { write(false); }), "worn_steel_gloss.png: exists already"));
  CHECK(slurp(folder.file("worn_steel_gloss.png")) == "mine");
  CHECK(masked_files_in(folder.path(), worn_steel(folder)).size() == 1);
  write(true);
  CHECK(slurp(folder.file("worn_steel_gloss.png")) != "mine");
}

TEST_CASE("a survey of a mask proposes its flat colours") {
  const TempFolder folder;
  (void)worn_steel(folder);
  const MaskSurvey two = survey_mask(folder.file("wear.png"), {});
  CHECK(!two.colors);
  CHECK(two.codes == std::vector<MaskCode>{{0, 0, 0}, {255, 255, 255}});
  Image8 ids(30, 10, 3);
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 30; ++x) ids.at(x, y)[x < 15 ? 0 : x < 25 ? 1 : 2] = 200;
  save_png(folder.file("ids.png"), ids);
  const MaskSurvey three = survey_mask(folder.file("ids.png"), {});
  CHECK(three.colors);
  CHECK(three.codes == std::vector<MaskCode>{{200, 0, 0}, {0, 200, 0}, {0, 0, 200}});
}

TEST_CASE("materials that a mask cannot take are told") {
  const TempFolder folder;
  Project project = paint_and_iron();
  const auto fault = [&](const MaskedMaterial& masked) {
    return error_of([&] { (void)manifest_of(masked, project, built_in_library()); });
  };
  MaskedMaterial wanted = worn_steel(folder);
  wanted.parts[1].material = "gone";
  CHECK(contains(fault(wanted), "no material \"gone\""));
  wanted = worn_steel(folder);
  wanted.parts.pop_back();
  CHECK(contains(fault(wanted), "1 materials; expected two to four"));
  set_texture(project.materials[0], Channel::gloss, ImageSource{"g.png", {}, {}});
  CHECK(contains(fault(worn_steel(folder)), "Red paint: has textures"));
}
