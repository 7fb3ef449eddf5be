// SPDX-License-Identifier: Apache-2.0
// Material documents: planted mistakes, clean ones, and what etak exports itself.
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "core/exchange/export_input.h"
#include "core/exchange/export_values.h"
#include "core/exchange/gltf_material.h"
#include "core/exchange/material_x.h"
#include "core/exchange/surfaces/document.h"
#include "core/material/f0/f0_settings.h"
#include "tests/core/material/library_support.h"
#include "tests/core/validate/surface_documents.h"

using namespace etak;
using namespace etak::test;

namespace {

struct PlantedDocument {
  std::string rule, file, text;
};

const std::string standard_model = "standard_surface";

// Forty mistakes, each in a document of its own.
std::vector<PlantedDocument> planted_documents() {
  const auto pbr = [](const std::string& rule, const std::vector<std::string>& inputs,
                      const std::string& name = "thing") {
    return PlantedDocument{rule, "a.mtlx", material_x_of(open_pbr_model, inputs, name)};
  };
  const auto node = [](const std::string& rule, const std::string& model,
                       const std::vector<std::string>& inputs, const std::string& name = "thing") {
    return PlantedDocument{rule, "a.mtlx", material_x_of(model, inputs, name)};
  };
  const auto usd = [](const std::string& rule, const std::vector<std::string>& inputs,
                      const std::string& name = "thing") {
    return PlantedDocument{rule, "a.usda", usda_of(inputs, name)};
  };
  const auto gltf = [](const std::string& rule, const std::string& material) {
    return PlantedDocument{rule, "a.gltf", gltf_of(material)};
  };
  const auto table = [](const std::string& rule, const std::vector<std::string>& rows,
                        const std::string& name = "thing") {
    return PlantedDocument{rule, "a.csv", value_table_of(rows, name)};
  };
  const std::string metal = "base_metalness=float:1", gold = "base_color=color3:1, 0.774, 0.335";
  return {
      // Out of range.
      pbr("ETK801", {"base_color=color3:1.4, 1.2, 0.9"}),
      pbr("ETK801", {"base_color=color3:0.5, -0.1, 0.5"}),
      pbr("ETK801", {"specular_ior=float:0.04"}),
      pbr("ETK801", {"specular_roughness=float:30"}),
      node("ETK801", standard_model, {"specular_IOR=float:0.5"}),
      node("ETK801", "conductor_bsdf", {"ior=color3:0.2, 0.4, 1.5", "extinction=color3:3.9, -2.2, 1.7"}),
      usd("ETK801", {"color3f inputs:diffuseColor = (1.6, 0.9, 0.3)"}),
      usd("ETK801", {"float inputs:roughness = -0.2"}),
      table("ETK801", {"unreal,Metallic,1.5,1.5,,"}),
      table("ETK801", {"openpbr,specular_ior,0.9,0.9,,"}),
      // Unknown inputs.
      pbr("ETK802", {"base_colour=color3:0.5, 0.4, 0.3"}),
      pbr("ETK802", {"metalness=float:1"}),
      node("ETK802", standard_model, {"specular_ior=float:1.5"}),
      node("ETK802", standard_model, {"base_color=float:0.5"}),
      usd("ETK802", {"float inputs:metalness = 1"}),
      gltf("ETK802", R"("pbrMetallicRoughness": {"metalicFactor": 0})"),
      table("ETK802", {"openpbr,base_colour,\"1, 0.8, 0.3\",1,0.8,0.3"}),
      {"ETK802", "a.mtlx",
       material_x_of(open_pbr_model, {"base_color=color3:0.5, 0.4, 0.3"}, "thing", "my_space")},
      // Metals that are none.
      pbr("ETK803", {"base_color=color3:0.2, 0.05, 0.05", metal}),
      node("ETK803", standard_model, {"base_color=color3:0.04, 0.04, 0.04", "metalness=float:1"}),
      usd("ETK803", {"color3f inputs:diffuseColor = (0.1, 0.3, 0.6)", "float inputs:metallic = 1"}),
      gltf("ETK803", R"("pbrMetallicRoughness": {"baseColorFactor": [0.05, 0.3, 0.1, 1]})"),
      table("ETK803", {"unreal,Base Color,x,0.3,0.02,0.2", "unreal,Metallic,1,1,,"}),
      // Dielectrics that are none.
      pbr("ETK804", {"specular_ior=float:15"}),
      pbr("ETK804", {"specular_ior=float:1.02"}),
      node("ETK804", "gltf_pbr", {"metallic=float:0", "specular=float:0.2"}),
      usd("ETK804", {"float inputs:ior = 1.1"}),
      gltf(
          "ETK804",
          R"("pbrMetallicRoughness": {"metallicFactor": 0}, "extensions": {"KHR_materials_ior": {"ior": 4}})"),
      // Neither.
      pbr("ETK805", {"base_metalness=float:0.5"}),
      usd("ETK805", {"float inputs:metallic = 0.3"}),
      gltf("ETK805", R"("pbrMetallicRoughness": {"metallicFactor": 0.6})"),
      table("ETK805", {"blender,Metallic,0.5,0.5,,"}),
      // Edges.
      pbr("ETK806", {gold, metal, "specular_color=color3:1, 0.774, 0.335"}),
      table("ETK806", {"glsl,f0,x,0.95,0.64,0.54", "glsl,f82,x,0.3,0.2,0.9"}),
      // Encodings.
      pbr("ETK807", {"base_color=color3:1, 0.894, 0.612", metal}),
      pbr("ETK807", {"base_color=color3:255, 228, 156", metal}),
      usd("ETK807", {"color3f inputs:diffuseColor = (0.98, 0.82, 0.76)", "float inputs:metallic = 1"}),
      // Units of films.
      pbr("ETK808", {"thin_film_weight=float:1", "thin_film_thickness=float:400"}),
      node("ETK808", standard_model, {"thin_film_thickness=float:0.4"}),
      gltf(
          "ETK808",
          R"("extensions": {"KHR_materials_iridescence": {"iridescenceFactor": 1, "iridescenceThicknessMaximum": 0.4}})"),
      // Names.
      pbr("ETK809", {"base_color=color3:0.95, 0.93, 0.88", metal}, "Copper"),
      usd("ETK809", {"float inputs:ior = 1.5"}, "diamond"),
  };
}

// Documents without a mistake.
std::vector<PlantedDocument> clean_documents() {
  const std::string metal = "base_metalness=float:1";
  std::vector<PlantedDocument> out;
  for (const auto& inputs : std::vector<std::vector<std::string>>{
           {},
           {"base_color=color3:0.8, 0.1, 0.1", "specular_roughness=float:0.4"},
           {"base_color=color3:1, 0.774, 0.335", metal},
           {"base_color=color3:0.95, 0.64, 0.54", metal, "specular_color=color3:1, 0.98, 0.97"},
           {"base_color=color3:0.56, 0.57, 0.58", metal},
           {"specular_ior=float:1.33", "transmission_weight=float:1"},
           {"specular_ior=float:2.42", "transmission_weight=float:1"},
           {"thin_film_weight=float:1", "thin_film_thickness=float:0.4", "thin_film_ior=float:1.4"},
           {"coat_weight=float:1", "coat_ior=float:1.5", "geometry_thin_walled=boolean:true"}})
    out.push_back({"", "a.mtlx", material_x_of(open_pbr_model, inputs)});
  for (const auto& inputs : std::vector<std::vector<std::string>>{
           {"base=float:1", "base_color=color3:0.5, 0.4, 0.3", "specular_IOR=float:1.5"},
           {"base_color=color3:0.91, 0.92, 0.92", "metalness=float:1"},
           {"thin_film_thickness=float:400", "thin_film_IOR=float:1.4"}})
    out.push_back({"", "a.mtlx", material_x_of(standard_model, inputs)});
  out.push_back({"", "a.mtlx",
                 material_x_of("conductor_bsdf",
                               {"ior=color3:0.143, 0.375, 1.44", "extinction=color3:3.98, 2.39, 1.6"})});
  out.push_back(
      {"", "a.mtlx",
       material_x_of(open_pbr_model, {"base_color=color3:1, 0.894, 0.612", metal}, "thing", "srgb_texture")});
  for (const auto& inputs : std::vector<std::vector<std::string>>{
           {},
           {"color3f inputs:diffuseColor = (0.2, 0.3, 0.4)",
            "float inputs:roughness = 0.5 ( doc = \"rough\" )"},
           {"color3f inputs:diffuseColor = (0.97, 0.96, 0.91)", "float inputs:metallic = 1"},
           {"int inputs:useSpecularWorkflow = 1", "color3f inputs:specularColor = (0.04, 0.04, 0.04)"}})
    out.push_back({"", "a.usda", usda_of(inputs)});
  out.push_back(
      {"", "a.gltf",
       gltf_of(
           R"("pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.5}, "doubleSided": true)")});
  out.push_back(
      {"", "a.gltf",
       gltf_of(
           R"("extensions": {"KHR_materials_ior": {"ior": 1.33}}, "pbrMetallicRoughness": {"metallicFactor": 0})")});
  out.push_back(
      {"", "a.csv",
       value_table_of({"openpbr,base_metalness,1,1,,", "openpbr,base_color,x,1,0.774,0.335"}, "gold")});
  out.push_back({"", "a.csv", value_table_of({"srgb8,F0,x,56,56,56", "linear,F0,x,0.04,0.04,0.04"})});
  return out;
}

}  // namespace

TEST_CASE("forty planted mistakes are found, each by its own rule") {
  const std::vector<PlantedDocument> all = planted_documents();
  CHECK(all.size() >= 40);
  for (const PlantedDocument& each : all) {
    const CheckedFile file = checked_document(each.file, each.text);
    INFO(each.text << remarks_on(file));
    CHECK(find(file, each.rule) != nullptr);
  }
}

TEST_CASE("clean documents get no remark") {
  const std::vector<PlantedDocument> all = clean_documents();
  CHECK(all.size() >= 20);
  for (const PlantedDocument& each : all) {
    const CheckedFile file = checked_document(each.file, each.text);
    INFO(each.text);
    CHECK(remarks_on(file) == "");
  }
}

TEST_CASE(
    "numbers of a glTF material are let pass only where all of them are those of the material so named") {
  const std::string chalk = R"("pbrMetallicRoughness": {"metallicFactor": 0, "baseColorFactor": [)";
  const auto remarks = [](const std::string& name, const std::string& material) {
    const std::string mesh =
        R"(, "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,)" +
        std::string(48, 'A') +
        R"("}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0,0,0], "max": [0,0,0]}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
      "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0})";
    std::string text = gltf_of(material);
    text.replace(text.find("thing"), 5, name);
    text.pop_back();
    return remarks_on(checked_document("a.gltf", text + mesh));
  };
  const std::string dark = chalk + "0.004, 0.003, 0.003, 1]}",
                    gaas = R"("pbrMetallicRoughness": {"baseColorFactor": [0.342, 0.366, 0.451, 1]})";
  CHECK(contains(remarks("thing", gaas), "ETK101"));
  CHECK(contains(remarks("Gold", gaas), "ETK101"));
  CHECK(remarks("Gallium arsenide", gaas) == "");
  CHECK(contains(remarks("chalk", dark), "ETK202"));
  CHECK(contains(remarks("Poly(methyl methacrylate)", dark), "ETK202"));
}

TEST_CASE("a document tells the measured material nearest to each surface") {
  const CheckedFile file = checked_document(
      "a.mtlx",
      material_x_of(open_pbr_model, {"base_color=color3:1, 0.774, 0.335", "base_metalness=float:1"}));
  REQUIRE(file.surfaces.size() == 1);
  CHECK(file.surfaces[0].name == "thing");
  CHECK(file.surfaces[0].model == open_pbr_model);
  REQUIRE(file.surfaces[0].nearest);
  CHECK(file.surfaces[0].nearest->id == "gold");
  CHECK(file.surfaces[0].nearest->delta_e < 1);
  const CheckedFile copper = checked_document(
      "a.mtlx", material_x_of(open_pbr_model,
                              {"base_color=color3:0.95, 0.93, 0.88", "base_metalness=float:1"}, "Copper"));
  REQUIRE(find(copper, "ETK809") != nullptr);
  CHECK(contains(find(copper, "ETK809")->message, "nearest: silver"));
  REQUIRE(!find(copper, "ETK809")->nearest.empty());
  CHECK(find(copper, "ETK809")->nearest[0].delta_e < 5);
}

TEST_CASE("inputs are followed to constants, and what pictures give is not judged") {
  const std::string text = in_material_x(
      R"(<constant name="c" type="color3"><input name="value" type="color3" value="0.2, 0.05, 0.05"/></constant>
<image name="i" type="color3"><input name="file" type="filename" value="a.png"/></image>
<open_pbr_surface name="s" type="surfaceshader"><input name="base_color" type="color3" nodename="NODE"/>
<input name="base_metalness" type="float" value="1"/></open_pbr_surface>)");
  const auto with = [&](const char* node) {
    std::string out = text;
    out.replace(out.find("NODE"), 4, node);
    return checked_document("a.mtlx", out);
  };
  CHECK(find(with("c"), "ETK803") != nullptr);
  CHECK(remarks_on(with("i")) == "");
}

TEST_CASE("exports of coats and of stacks that the library does not have get no remark") {
  const LibraryWhenAsked of_tests = []() -> const MaterialLibrary& { return library(); };
  std::vector<ExportSurface> surfaces;
  for (const char* const name :
       {"gold", "titanium", "silicon", "bismuth", "pmma", "diamond", "acetic_acid"}) {
    InputNames names;
    names.names = {name};
    ExportWishes wishes;
    wishes.coat = coat_setting("1.5", of_tests);
    surfaces.push_back(
        export_answer(find_inputs(names, of_tests, 1).at(0), {}, F0Solver({}), wishes).surface.value());
  }
  for (const char* const stack : {"anatase:40nm/titanium", "magnesium_fluoride:100nm/glass_bk7"}) {
    InputNames names;
    names.names = {stack};
    surfaces.push_back(
        export_answer(find_inputs(names, of_tests, 1).at(0), {}, F0Solver({}), {}).surface.value());
  }
  std::vector<Changes> changes;
  CHECK(remarks_on(checked_document("a.mtlx", material_x(surfaces, Fit::clamp, changes))) == "");
  CHECK(remarks_on(checked_document("a.gltf", gltf_document(surfaces, GltfMaterialForm::metal_rough,
                                                            GltfContainer::gltf, Fit::clamp, changes))) ==
        "");
}

TEST_CASE("what etak exports itself gets no remark") {
  const LibraryWhenAsked of_tests = []() -> const MaterialLibrary& { return library(); };
  InputNames names;
  names.all = true;
  std::vector<ExportSurface> surfaces;
  std::vector<std::string> datasets;
  std::set<std::string> ids;
  for (const MaterialInput& input : find_inputs(names, of_tests, 1)) {
    ExportAnswer answer = export_answer(input, {}, F0Solver({}), {});
    if (!answer.surface || !ids.insert(answer.surface->id).second) continue;
    surfaces.push_back(*answer.surface);
    datasets.push_back(answer.dataset);
  }
  REQUIRE(surfaces.size() > 200);
  std::vector<Changes> changes;
  CHECK(remarks_on(checked_document("a.mtlx", material_x(surfaces, Fit::clamp, changes))) == "");
  CHECK(remarks_on(checked_document("a.gltf", gltf_document(surfaces, GltfMaterialForm::metal_rough,
                                                            GltfContainer::gltf, Fit::clamp, changes))) ==
        "");
  for (const auto& [target, file] : {std::pair("standard-surface", "a.mtlx"), std::pair("gltf-pbr", "a.mtlx"),
                                     std::pair("usd", "a.usda")}) {
    const EngineTarget& of = *engine_target(target);
    std::string text(of.opens);
    for (const ExportedValues& each : exported_values(surfaces, datasets, {&of}, Fit::clamp, 1))
      text += body_text(each.targets[0]);
    text += of.closes;
    CHECK(remarks_on(checked_document(file, text)) == "");
  }
  std::vector<ExportSurface> some;
  std::vector<std::string> some_datasets;
  for (std::size_t i = 0; i < surfaces.size(); i += 5) {
    some.push_back(surfaces[i]);
    some_datasets.push_back(datasets[i]);
  }
  std::vector<const EngineTarget*> targets = engine_targets_named({});
  CHECK(remarks_on(checked_document(
            "a.csv", export_csv(exported_values(some, some_datasets, targets, Fit::clamp, 1)))) == "");
}
