// SPDX-License-Identifier: Apache-2.0
#include "core/project/project_import.h"

#include <catch2/catch.hpp>

#include "tests/core/validate/surface_documents.h"

using namespace etak;
using namespace etak::test;

namespace {

struct Imported {
  std::vector<ProjectMaterial> materials;
  std::vector<std::string> remarks;
};

Imported imported(const std::string& name, const std::string& text) {
  const TempFolder folder;
  spit(folder.file(name), text);
  Imported out;
  out.materials = imported_materials(folder.file(name), out.remarks);
  return out;
}

}  // namespace

TEST_CASE("a metal of MaterialX is imported as its F0 over black") {
  const Imported gold =
      imported("a.mtlx", material_x_of("open_pbr_surface",
                                       {"base_color=color3:1, 0.774, 0.335", "base_metalness=float:1",
                                        "specular_roughness=float:0.3"},
                                       "Gold"));
  REQUIRE(gold.materials.size() == 1);
  CHECK(gold.materials[0].name == "Gold");
  CHECK(gold.materials[0].specular == LinearRgb{1, 0.774, 0.335});
  CHECK(gold.materials[0].diffuse == LinearRgb{0, 0, 0});
  CHECK(gold.materials[0].gloss.roughness() == Approx(0.3));
  CHECK(gold.remarks.empty());
}

TEST_CASE(
    "a dielectric of glTF is imported with the F0 of its index, and its diffuse colour less what is reflected") {
  const Imported plastic = imported(
      "a.gltf",
      gltf_of(R"("pbrMetallicRoughness": {"metallicFactor": 0, "baseColorFactor": [0.5, 0.2, 0.1, 1]},
                           "extensions": {"KHR_materials_ior": {"ior": 1.5}})"));
  REQUIRE(plastic.materials.size() == 1);
  CHECK(plastic.materials[0].specular.r == Approx(0.04));
  CHECK(plastic.materials[0].diffuse.r == Approx(0.5 * 0.96));
  CHECK(plastic.materials[0].diffuse.b == Approx(0.1 * 0.96));
}

TEST_CASE("what is not imported is told, and a broken document is refused") {
  const Imported filmed =
      imported("a.mtlx", material_x_of("standard_surface", {"thin_film_thickness=float:400"}));
  REQUIRE(filmed.remarks.size() == 1);
  CHECK(contains(filmed.remarks[0], "film"));
  CHECK(contains(error_of([] { (void)imported("a.mtlx", "<materialx version=\"1.39\"/>"); }), "no material"));
  CHECK(contains(error_of([] { (void)imported("a.usda", "PXR-USDC"); }), "binary form"));
  CHECK(holds_surfaces("a.MTLX"));
  CHECK(!holds_surfaces("a.csv"));
}
