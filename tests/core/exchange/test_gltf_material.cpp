// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>

#include "core/exchange/gltf_material.h"
#include "core/material/library.h"
#include "core/scene/gltf.h"
#include "core/scene/material_texels.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

std::vector<ExportSurface> samples() {
  ExportSurface gold, red, thin, diamond;
  gold.id = gold.name = "gold";
  gold.kind = SurfaceKind::metal;
  gold.f0 = {1.0428, 0.7738, 0.3347};
  gold.f82 = LinearRgb{0.9921, 0.8862, 0.6311};
  gold.source = "\"quoted\" \xff source";
  red.id = red.name = "red";
  red.f0 = {0.2, 0.05, 0.05};
  red.diffuse = {0.3, 0.2, 0.1};
  red.gloss = 0;
  thin.id = "thin";
  thin.opacity = 0.25;
  thin.gloss = 1;
  diamond.id = diamond.name = "diamond";
  diamond.f0 = {0.17, 0.172, 0.176};
  return {gold, red, thin, diamond};
}

std::string written_gltf(const std::vector<ExportSurface>& surfaces, GltfMaterialForm form,
                         GltfContainer container) {
  std::vector<Changes> changes;
  std::string out = gltf_document(surfaces, form, container, Fit::clamp, changes);
  REQUIRE(changes.size() == surfaces.size());
  return out;
}

// The Khronos validator's errors and warnings, one a line; none when there is no node with it.
std::string validator_messages(const std::vector<std::string>& files) {
  static const bool has = std::system("node -e \"require('gltf-validator')\" >/dev/null 2>&1") == 0;
  if (!has) {
    WARN("no node with gltf-validator (NODE_PATH): what is written is not validated");
    return "";
  }
  const TempFolder temp;
  spit(temp.file("check.js"), R"(const v=require('gltf-validator'),fs=require('fs');(async()=>{
for(const f of process.argv.slice(2)){const r=await v.validateBytes(new Uint8Array(fs.readFileSync(f)),{maxIssues:0});
for(const m of r.issues.messages)if(m.severity<2)console.log(f+' '+m.code+' '+m.message+' '+m.pointer);}
console.log('checked '+(process.argv.length-2));})())");
  std::string command = "node " + temp.file("check.js");
  for (const std::string& file : files) command += " " + file;
  const std::string out = temp.file("out");
  const int status = std::system((command + " >" + out + " 2>&1").c_str());
  const std::string text = slurp(out);
  return status == 0 && text == "checked " + std::to_string(files.size()) + "\n" ? "" : text;
}

}  // namespace

TEST_CASE("the Khronos validator finds neither error nor warning in either form and container") {
  const TempFolder temp;
  std::vector<std::string> files;
  for (const auto form : {GltfMaterialForm::metal_rough, GltfMaterialForm::specular_glossiness})
    for (const auto container : {GltfContainer::gltf, GltfContainer::glb}) {
      const std::string ending = container == GltfContainer::gltf ? ".gltf" : ".glb";
      files.push_back(temp.file(std::to_string(files.size()) + ending));
      spit(files.back(), written_gltf(samples(), form, container));
    }
  CHECK(validator_messages(files).empty());
}

TEST_CASE("the whole library in one document passes the validator, in both forms") {
  const MaterialLibrary library = MaterialLibrary::builtin();
  const F0Options options;
  const F0Solver solver(options);
  std::vector<ExportSurface> surfaces;
  for (std::size_t i = 0; i < library.ids().size(); ++i) {
    const Material material = library.at(i);
    const Dataset& dataset = material.preferred_dataset();
    const F0Result result = solver.solve(dataset.optics, dataset.flags);
    if (!result.refused())
      surfaces.push_back(export_surface(material, dataset, options, result, {0.2, 0.2, 0.2}, 0.5));
  }
  REQUIRE(surfaces.size() >= 170);
  const TempFolder temp;
  const std::vector<std::string> files{temp.file("a.gltf"), temp.file("b.glb")};
  spit(files[0], written_gltf(surfaces, GltfMaterialForm::metal_rough, GltfContainer::gltf));
  spit(files[1], written_gltf(surfaces, GltfMaterialForm::specular_glossiness, GltfContainer::glb));
  CHECK(validator_messages(files).empty());
}

TEST_CASE("etak's own reader finds the materials again") {
  const TempFolder temp;
  for (const auto container : {GltfContainer::gltf, GltfContainer::glb}) {
    const std::string file = temp.file(container == GltfContainer::gltf ? "a.gltf" : "a.glb");
    const std::vector<ExportSurface> surfaces = samples();
    spit(file, written_gltf(surfaces, GltfMaterialForm::metal_rough, container));
    const GltfScene scene = read_gltf(file, {});
    REQUIRE(scene.materials.size() == surfaces.size());
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      const GltfMaterial& m = scene.materials[i];
      const ExportSurface& s = surfaces[i];
      CHECK(m.roughness == Approx(roughness_of_gloss(s.gloss)).epsilon(1e-12));
      CHECK(gloss_of_roughness(m.roughness) == Approx(s.gloss).margin(1e-9));
      const Vec3 base{m.base_color[0], m.base_color[1], m.base_color[2]};
      const DiffuseSpecular there = diffuse_specular(
          base, m.metallic,
          dielectric_f0(m.ior, m.specular, {m.specular_color[0], m.specular_color[1], m.specular_color[2]}));
      const DiffuseSpecular back =
          converted(there, DiffuseConvention::reduced_when_shading, DiffuseConvention::as_it_is);
      for (std::size_t c = 0; c < 3; ++c) {
        CHECK(back.f0[c] == Approx(std::min(1.0, vec(s.f0)[c])).epsilon(1e-9));
        if (s.kind == SurfaceKind::dielectric)
          CHECK(back.diffuse[c] == Approx(vec(s.diffuse)[c]).margin(1e-12));
      }
      CHECK(m.base_color[3] == s.opacity);
    }
    CHECK(scene.materials[2].alpha_mode == AlphaMode::blend);
  }
}

TEST_CASE("specular-glossiness alone stands in its documents") {
  const std::string text =
      written_gltf(samples(), GltfMaterialForm::specular_glossiness, GltfContainer::gltf);
  CHECK(contains(text, "\"extensionsUsed\": [\"KHR_materials_pbrSpecularGlossiness\"]"));
  CHECK(!contains(text, "pbrMetallicRoughness"));
}

TEST_CASE("a metal alone needs no extension") {
  const std::string text = written_gltf({samples()[0]}, GltfMaterialForm::metal_rough, GltfContainer::gltf);
  CHECK(!contains(text, "extensions"));
  CHECK(contains(text, "\"baseColorFactor\": [1, 0.7738, 0.3347, 1]"));
  CHECK(contains(text, "(clamp, 0.0428)"));
}

TEST_CASE("no surface, or one of another space, is refused") {
  std::vector<Changes> changes;
  const auto write = [&](const std::vector<ExportSurface>& surfaces) {
    return error_of([&] {
      (void)gltf_document(surfaces, GltfMaterialForm::metal_rough, GltfContainer::gltf, Fit::clamp, changes);
    });
  };
  CHECK(contains(write({}), "no material"));
  ExportSurface s = samples()[0];
  s.space = RgbSpace::acescg;
  CHECK(contains(write({s}), "acescg"));
}
