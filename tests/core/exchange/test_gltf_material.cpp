// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>

#include "core/exchange/gltf_material.h"
#include "core/image/files/png.h"
#include "core/material/library.h"
#include "core/scene/gltf.h"
#include "core/scene/material_texels.h"
#include "tests/gltf_judge.h"
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

std::string validator_messages(const std::vector<std::string>& files) {
  const TempFolder temp;
  const auto messages = gltf_messages(temp.path(), files);
  if (!messages) WARN("no node with gltf-validator (NODE_PATH): what is written is not validated");
  return messages.value_or("");
}

// A PNG of 2 x 2 texels of one colour.
std::string small_png(std::vector<std::uint8_t> texel) {
  Image8 out(2, 2, static_cast<int>(texel.size()));
  for (int i = 0; i < 4; ++i) std::copy(texel.begin(), texel.end(), out.at(i % 2, i / 2).begin());
  return png_bytes(out, {});
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
    if (!result.refused() && !std::holds_alternative<Stack>(dataset.optics))
      surfaces.push_back(export_surface(material, dataset, options, result, {0.2, 0.2, 0.2}, 0.5));
  }
  REQUIRE(surfaces.size() >= 215);
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

TEST_CASE("a document holds the pictures of its materials, in both containers") {
  const TempFolder temp;
  const std::string base = small_png({200, 100, 50, 128}), rough = small_png({255, 90, 255}),
                    f0 = small_png({60, 56, 52}), white = small_png({255, 255, 255, 40});
  std::vector<ExportSurface> surfaces = samples();
  surfaces[1].diffuse = {0, 0, 0};
  std::vector<GltfPictures> pictures(surfaces.size());
  pictures[0].metallic_roughness = rough;
  pictures[1] = {base, "", f0, false, "MASK", 0.25};
  pictures[2] = {white, "", "", true, "BLEND", 0.5};
  std::vector<std::string> files;
  for (const auto container : {GltfContainer::gltf, GltfContainer::glb}) {
    files.push_back(temp.file(container == GltfContainer::gltf ? "a.gltf" : "a.glb"));
    std::vector<Changes> changes;
    spit(files.back(),
         gltf_document(surfaces, GltfMaterialForm::metal_rough, container, Fit::clamp, changes, pictures));
    const GltfScene scene = read_gltf(files.back(), {});
    const auto bytes = [&](const std::optional<GltfTexture>& texture) {
      return texture ? scene.images.at(static_cast<std::size_t>(texture->image)).bytes : std::string();
    };
    REQUIRE(scene.images.size() == 4);
    CHECK(bytes(scene.materials[0].metallic_roughness_texture) == rough);
    CHECK(scene.materials[0].metallic == 1);
    CHECK(scene.materials[0].roughness == 1);
    CHECK(scene.materials[0].base_color[1] == Approx(0.7738));
    CHECK(bytes(scene.materials[1].base_color_texture) == base);
    CHECK(bytes(scene.materials[1].specular_color_texture) == f0);
    CHECK(scene.materials[1].base_color == std::array<double, 4>{1, 1, 1, 1});
    CHECK(scene.materials[1].metallic == 0);
    CHECK(scene.materials[1].ior == 0);
    CHECK(scene.materials[1].alpha_mode == AlphaMode::mask);
    CHECK(scene.materials[1].alpha_cutoff == 0.25);
    CHECK(bytes(scene.materials[2].base_color_texture) == white);
    CHECK(scene.materials[2].base_color[3] == 1);
    CHECK(scene.materials[2].alpha_mode == AlphaMode::blend);
    CHECK(!scene.materials[3].base_color_texture);
  }
  CHECK(validator_messages(files).empty());
  std::vector<Changes> changes;
  CHECK(contains(error_of([&] {
                   (void)gltf_document(surfaces, GltfMaterialForm::specular_glossiness, GltfContainer::gltf,
                                       Fit::clamp, changes, pictures);
                 }),
                 "pictures in the form specular-glossiness"));
}
