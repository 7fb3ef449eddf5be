// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "core/project/project_pack.h"
#include "tests/core/atlas/pack_support.h"

using namespace etak;
using namespace etak::test;

namespace {

Project two_materials() {
  Project out;
  out.materials.resize(2);
  out.materials[0].name = "plain";
  out.materials[1].name = "bright";
  out.materials[1].specular = {1.5, 0.5, 0.25};
  return out;
}

}  // namespace

TEST_CASE("a project file and the same project in memory are packed into the same atlas") {
  const TempFolder folder;
  const Project project = two_materials();
  const std::string file = folder.file("p.json"), out = folder.file("out");
  spit(file, format_project(project, file));
  PackOptions options;
  options.output.update = true;
  options.input.other_manifest = project_reader(built_in_library());
  const PackResult first = pack(file, out, options, built_in_library());
  CHECK(first.materials == 2);
  REQUIRE(!first.remarks.empty());
  CHECK(first.remarks.front().find("bright") != std::string::npos);  // its red was brought to 1
  CHECK(!first.up_to_date);
  const PackManifest same = packed_manifest(project, built_in_library());
  CHECK(pack(same, "in memory", out, options, built_in_library()).up_to_date);
}

TEST_CASE("how a project is looked at does not change its atlas") {
  const Project project = two_materials();
  Project turned = project;
  turned.view.environment_turn_deg = 30;
  const MaterialLibrary& library = built_in_library();
  CHECK(packed_manifest(turned, library).settings == packed_manifest(project, library).settings);
}

TEST_CASE("the packer takes no project by itself") {
  const TempFolder folder;
  const std::string file = folder.file("p.json");
  spit(file, format_project(two_materials(), file));
  CHECK(!error_of([&] { (void)pack(file, folder.file("out"), {}, built_in_library()); }).empty());
}
