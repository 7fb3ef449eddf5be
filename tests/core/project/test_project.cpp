// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "core/base/files/file.h"
#include "core/base/text/free_names.h"
#include "core/color/gamut.h"
#include "core/color/srgb.h"
#include "core/project/project.h"
#include "tests/core/material/library_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

// Every field away from its default.
Project full() {
  Project out;
  ProjectMaterial m;
  m.name = "Worn \"gold\"\n\xc3\xa9";
  m.diffuse = {0.1, 1.0 / 3, -0.02};
  m.measured = MeasuredF0{"gold", "johnson-1972", "water", {Observer::cie1964_10deg, Illuminant::a}};
  m.gloss = 0.625;
  m.alpha = 0.5;
  m.emission = {2.5, 0, 0.125};
  m.occlusion = 0.75;
  m.texture(Channel::gloss) = ImageSource{"textures/g.png", "r", "linear"};
  m.alpha_mode = AlphaMode::mask;
  m.alpha_cutoff = 0.25;
  m.specular_model = "ggx-f82";
  m.diffuse_model = "";
  m.parameters = {{"alpha", 0.3}};
  out.materials = {m, {}};
  out.materials[1].name = "plain";
  out.materials[1].specular = {1.0428, 0.5, 0.25};
  Material glass;
  glass.id = "my_glass";
  glass.name = "My glass";
  glass.material_class = "glass";
  glass.datasets.push_back({"one", etak::test::glass(1.7), Origin::measured, "", {}, "", {}, {}, "", ""});
  out.spectra.push_back(glass);
  out.view.shape = Shape::quad;
  out.view.mesh = "shader-ball";
  out.view.lights = default_lights();
  out.view.lights.hemispheres->form = HemisphereForm::wide;
  out.view.lights.lights[0].kind = LightKind::spot;
  out.view.lights.environment = "studio";
  out.view.environment_turn_deg = 30;
  out.view.exposure = 1.5;
  out.view.display = "sRGB - Display";
  out.view.tone = Tone::neutral;
  out.view.background = {0.05, 0.5, 1};
  out.view.backdrop = {true, 0.25, true};
  out.view.compare = {true, m, "ggx-f82"};
  out.view.compare.pinned->texture(Channel::gloss).reset();
  out.view.wedge = {true, "opacity", 5};
  return out;
}

}  // namespace

TEST_CASE("a project reads back as it was written") {
  const TempFolder folder;
  const std::string file = folder.file("p.json");
  Project project = full();
  // Named absolutely, as everything in memory that is not below the working folder.
  project.materials[0].texture(Channel::gloss)->path = folder.file("textures/g.png");
  const std::string text = format_project(project, file);
  CHECK(is_project(text));
  CHECK(contains(text, "\"textures/g.png\""));
  CHECK(parse_project(text, file) == project);
  CHECK(format_project(parse_project(text, file), file) == text);
  // A copy for anywhere names files absolutely.
  CHECK(contains(format_project(project, ""), folder.file("textures/g.png")));
  CHECK(parse_project(format_project(project, ""), "elsewhere/copy.json") == project);
}

TEST_CASE(
    "pictures in a folder beside the project's are named from there, so that both can be moved together") {
  const TempFolder folder;
  std::filesystem::create_directories(folder.file("scenes"));
  const std::string file = folder.file("scenes/p.json");
  Project project = full();
  project.materials[0].texture(Channel::gloss)->path = folder.file("pictures/g.png");
  const std::string text = format_project(project, file);
  CHECK(contains(text, "\"../pictures/g.png\""));
  // Read back it is the way there, which is not shortened: a folder on it may be a link.
  const Project back = parse_project(text, file);
  CHECK(std::filesystem::path(back.materials[0].texture(Channel::gloss)->path).lexically_normal() ==
        folder.file("pictures/g.png"));
  CHECK(format_project(back, file) == text);
  // Nothing but the root in common: the way there differs from computer to computer.
  project.materials[0].texture(Channel::gloss)->path = "/etak-elsewhere/g.png";
  CHECK(contains(format_project(project, file), "\"/etak-elsewhere/g.png\""));
}

TEST_CASE("an emission of which nothing is said is black, but white under a texture") {
  const TempFolder folder;
  const std::string file = folder.file("p.json");
  Project project;
  project.materials.resize(1);
  ProjectMaterial& m = project.materials[0];
  m.name = "lamp";
  for (const Channel channel : {Channel::emission, Channel::occlusion})
    set_texture(m, channel, ImageSource{folder.file("glow.exr"), "", ""});
  CHECK(m.emission == LinearRgb{1, 1, 1});
  const std::string text = format_project(project, file);
  CHECK(contains(text, "\"emission\": {\"image\": \"glow.exr\"}, \"occlusion\": {"));
  CHECK(!contains(text, "\"emission\": ["));
  CHECK(parse_project(text, file) == project);
  // Nothing is sent out where the texture is not seen.
  CHECK(surface_of(m, MaterialLibrary::builtin()).emission == Vec3{});
  m.emission = {2, 0, 0};
  CHECK(parse_project(format_project(project, file), file) == project);
  set_texture(m, Channel::emission, std::nullopt);
  CHECK(m.emission == LinearRgb{2, 0, 0});
  m.emission = {};
  CHECK(parse_project(format_project(project, file), file) == project);
  std::vector<std::string> remarks;
  (void)manifest_of(project, MaterialLibrary::builtin(), remarks);
  CHECK(remarks == std::vector<std::string>{"lamp: its occlusion is in none of the textures"});
}

TEST_CASE("what is wrong in a project is refused with its place") {
  const auto refused = [](const std::string& text) {
    return error_of([&] { (void)parse_project(text, "p.json"); });
  };
  const std::string head = R"({"schema": "etak-project/1", "materials": [)";
  CHECK(contains(refused("{"), "p.json"));
  CHECK(contains(refused(R"({"schema": "etak-project/2", "materials": []})"), "p.json#/schema"));
  CHECK(contains(refused(head + R"({"name": "a"}, {"name": "a"}]})"), "a second material"));
  CHECK(contains(refused(head + R"({"name": "a", "gloss": 2}]})"), "p.json#/materials/0/gloss"));
  CHECK(contains(refused(head + R"({"name": "a", "emission": [0, -1, 0]}]})"),
                 "p.json#/materials/0/emission/1"));
  CHECK(contains(refused(head + R"({"name": "a", "occlusion": 1.5}]})"), "p.json#/materials/0/occlusion"));
  CHECK(contains(refused(head + R"({"name": "a", "colour": 2}]})"), "unknown key \"colour\""));
  CHECK(contains(refused(head + R"({"name": "a", "model": "lambert"}]})"), "a specular model"));
  CHECK(contains(refused(head + R"({"name": "a", "diffuse": [1, 2]}]})"), "[r, g, b]"));
  CHECK(contains(refused(head + R"({"name": "a", "measured": {"material": "gold", "illuminant": "F"}}]})"),
                 "illuminant"));
  CHECK(contains(refused(head + R"(], "spectra": [{"schema": "etak-material/1"}]})"),
                 "p.json#/spectra/0: no \"id\""));
  CHECK(contains(refused(head + R"(], "view": {"lights": {"schema": "etak-lights/1", "lights": [{}]}}})"),
                 "p.json#/view/lights"));
  const auto view = [&](const std::string& members) {
    return refused(head + R"(], "view": {)" + members + "}}");
  };
  CHECK(contains(view(R"("compare": {"pinned": {"gloss": 1}})"), "p.json#/view/compare/pinned"));
  CHECK(contains(view(R"("compare": {"model": "lambert"})"), "p.json#/view/compare/model"));
  CHECK(contains(view(R"("compare": {"on": 1})"), "p.json#/view/compare/on"));
  CHECK(contains(view(R"("wedge": {"steps": 17})"), "p.json#/view/wedge/steps"));
  CHECK(contains(view(R"("backdrop": {"blur": 1.5})"), "p.json#/view/backdrop/blur"));
  CHECK(contains(view(R"("backdrop": {"color": [0, -1, 0]})"), "p.json#/view/backdrop/color"));
  CHECK(contains(view(R"("backdrop": {"sky": true})"), "p.json#/view/backdrop"));
  CHECK(contains(view(R"("wedge": {"steps": 2.5})"), "a whole number"));
}

TEST_CASE("a file of one material leaves behind what the project compares with") {
  const Project project = full();
  const Project one = single(project, project.materials[0]);
  CHECK(one.view.compare == Comparison{});
  CHECK(one.view.wedge == project.view.wedge);
  CHECK(one.materials.size() == 1);
}

TEST_CASE("a pinned side is brought up to date with the library as the materials are") {
  Project project;
  project.view.compare.pinned = ProjectMaterial{};
  project.view.compare.pinned->name = "gold";
  project.view.compare.pinned->measured = MeasuredF0{"gold", "", "", {}};
  CHECK(resolve(project, test::library()).empty());
  CHECK(hex(srgb_u8(project.view.compare.pinned->specular)) == "#ffe49c");
  project.view.compare.pinned->measured = MeasuredF0{"unobtainium", "", "", {}};
  REQUIRE(resolve(project, test::library()).size() == 1);
  CHECK_FALSE(project.view.compare.pinned->measured);
}

TEST_CASE("measured colours are those of the library, and what is gone keeps its colour") {
  Project project;
  project.materials.resize(3);
  project.materials[0].name = "gold";
  project.materials[0].measured = MeasuredF0{"gold", "", "", {}};
  project.materials[1].name = "gone";
  project.materials[1].measured = MeasuredF0{"unobtainium", "", "", {}};
  project.materials[1].specular = {0.5, 0.4, 0.3};
  project.materials[2].name = "wet gold";
  project.materials[2].measured = MeasuredF0{"gold", "", "water", {}};
  const auto problems = resolve(project, test::library());
  REQUIRE(problems.size() == 1);
  CHECK(contains(problems[0], "gone: unobtainium"));
  CHECK_FALSE(project.materials[1].measured);
  CHECK(project.materials[1].specular == LinearRgb{0.5, 0.4, 0.3});
  CHECK(hex(srgb_u8(project.materials[0].specular)) == "#ffe49c");
  CHECK(gamut_text(project.materials[0].specular).starts_with("r +0.04"));
  // Water takes from the reflectance of what lies in it.
  CHECK(project.materials[2].specular.g < project.materials[0].specular.g);
}

TEST_CASE("the surface of a measured material is the library's, that of a typed one its own colour's") {
  ProjectMaterial m;
  m.measured = MeasuredF0{"gold", "", "", {}};
  m.gloss = 0.6;
  const auto gold = test::library().find("gold");
  SurfaceValues expected = surface_of(*gold, gold->preferred_dataset(), {0, 0, 0}, 0.6);
  const SurfaceValues found = surface_of(m, test::library());
  CHECK(found.f0 == expected.f0);
  CHECK(found.f82 == expected.f82);
  CHECK(found.n == expected.n);
  m.measured.reset();
  m.specular = {0.04, 0.04, 0.04};
  m.diffuse = {0.5, 0.25, 0.125};
  const SurfaceValues typed = surface_of(m, test::library());
  CHECK(typed.n[0] == Approx(1.5).epsilon(1e-6));
  CHECK(typed.k[0] == Approx(0).margin(1e-6));
  CHECK(typed.diffuse == Vec3{0.5, 0.25, 0.125});
}

TEST_CASE("what is packed of a project is a manifest of its colours and pictures") {
  Project project = full();
  project.materials[0].measured = MeasuredF0{"gold", "", "", {}};
  std::vector<std::string> remarks;
  const AtlasManifest manifest = manifest_of(project, test::library(), remarks);
  REQUIRE(manifest.materials.size() == 2);
  // By name: the quote comes before the letters? 'W' does.
  const ManifestMaterial& gold = manifest.materials[0];
  CHECK(gold.name == project.materials[0].name);
  CHECK(std::holds_alternative<ImageSource>(*gold.gloss));
  CHECK(std::get<ConstantSource>(*gold.specular).linear.r == 1);
  CHECK(gold.alpha_mode == AlphaMode::mask);
  // Gold's red, the negative blue of the diffuse colour, the emission, and the typed red above 1.
  CHECK(remarks.size() == 4);
  CHECK(std::ranges::any_of(remarks,
                            [](const auto& each) { return contains(each, "its emission is in none"); }));
}

TEST_CASE("a single material takes the spectra along that it uses") {
  Project project = full();
  project.materials[1].measured = MeasuredF0{"my_glass", "", "", {}};
  CHECK(single(project, project.materials[0]).spectra.empty());
  const Project one = single(project, project.materials[1]);
  REQUIRE(one.spectra.size() == 1);
  const MaterialLibrary all = library_of(one, test::library());
  CHECK(find_f0(*one.materials[0].measured, all).result.luminance == Approx(0.0672).epsilon(1e-3));
  CHECK(free_name(project, "plain") == "plain 2");
}

TEST_CASE("names given out together are free of each other, as if each had been looked for by itself") {
  Project project;
  const std::string longest(1000, 'x');
  for (const char* each : {"a", "a 3", "b"}) project.materials.emplace_back().name = each;
  FreeNames names = names_of(project);
  for (const std::string& wanted :
       {std::string("a"), std::string("a"), std::string("a 2"), std::string("c"), std::string("c"),
        std::string("a"), longest, longest, longest + "y", std::string("b 2"), std::string("b")}) {
    const std::string alone = free_name(project, wanted);
    CHECK(free_name(names, wanted) == alone);
    CHECK(alone.size() <= 1000);
    project.materials.emplace_back().name = alone;
  }
  CHECK(project.materials[3].name == "a 2");
  CHECK(project.materials[4].name == "a 4");
  CHECK(project.materials[5].name == "a 2 2");
}
