// SPDX-License-Identifier: Apache-2.0
#include "core/project/command_line.h"

#include <catch2/catch.hpp>

namespace etak {

TEST_CASE("a measured material is drawn by its name, and numbers by themselves") {
  Project project;
  ProjectMaterial gold;
  gold.measured = MeasuredF0{};
  gold.measured->material = "gold";
  gold.measured->dataset = "johnson-1972";
  gold.gloss = 0.5;
  gold.specular_model = "ggx-exact";
  CHECK(render_command(project, gold, {}).text ==
        "etak render gold/johnson-1972 --diffuse 0,0,0 --gloss 0.5 --opacity 1 --model ggx-exact "
        "--diffuse-model lambert --background 0.18,0.18,0.18 -o picture.png");
  CHECK(render_command(project, gold, {}).left_out.empty());
  ProjectMaterial paint;
  paint.diffuse = {0.5, 0.1, 0};
  paint.gloss = Gloss::of_roughness(0.3);
  View camera;
  camera.turn_deg = 30;
  CHECK(render_command(project, paint, camera, "gltf").text ==
        "etak render f0=0.04,0.04,0.04 diffuse=0.5,0.1,0 --roughness 0.3 --opacity 1 --as gltf --background "
        "0.18,0.18,0.18 --orbit 30 -o picture.png");
}

TEST_CASE("what no option says is told, and words of a file's name are quoted") {
  Project project;
  project.view.backdrop.ground = true;
  project.view.lights = {};
  project.view.lights.environment = "my room's.hdr";
  const CommandLine line = render_command(project, {}, {});
  CHECK(line.text.find(" --env 'my room'\\''s.hdr' ") != std::string::npos);
  CHECK(line.left_out == std::vector<std::string>{"the backdrop"});
}

}  // namespace etak
