// SPDX-License-Identifier: Apache-2.0
#include "core/light/lights.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/light/rows.h"
#include "core/light/studio.h"

using namespace etak;

namespace {

std::string message(std::string_view text) {
  try {
    parse_lights(text, "l.json");
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

std::string with_lights(std::string_view lights) {
  return R"({"schema": "etak-lights/1", "lights": [)" + std::string(lights) + "]}";
}

}  // namespace

TEST_CASE("a light setup is read whole, directions brought to length one") {
  const LightSetup setup = parse_lights(R"({
    "schema": "etak-lights/1",
    "lights": [
      {"kind": "point", "position": [1, 2, 3], "intensity": 5, "color": [1, 0.5, 0]},
      {"kind": "directional", "direction": [0, 0, -2], "intensity": 3},
      {"kind": "spot", "position": [0, 3, 0], "direction": [0, -1, 0], "intensity": 7, "inner_deg": 10, "outer_deg": 10}
    ],
    "hemispheres": {"upper": [1, 1, 1], "lower": [0, 0, 0], "axis": [0, 3, 4], "form": "wide"},
    "environment": {"file": "sky.hdr", "scale": 0.5},
    "pi_scaled": true
  })",
                                        "l.json");
  REQUIRE(setup.lights.size() == 3);
  CHECK(setup.lights[0].kind == LightKind::point);
  CHECK(setup.lights[0].position == Vec3{1, 2, 3});
  CHECK(setup.lights[0].color == Vec3{1, 0.5, 0});
  CHECK(setup.lights[1].direction == Vec3{0, 0, -1});
  CHECK(setup.lights[1].intensity == 3);
  CHECK(setup.lights[2].inner_deg == 10);
  REQUIRE(setup.hemispheres);
  CHECK(setup.hemispheres->form == HemisphereForm::wide);
  CHECK(setup.hemispheres->axis == Vec3{0, 0.6, 0.8});
  CHECK(setup.environment == "sky.hdr");
  CHECK(setup.environment_scale == 0.5);
  CHECK(setup.pi_scaled);
  CHECK(parse_lights(R"({"schema": "etak-lights/1"})", "l.json") == LightSetup{});
}

TEST_CASE("bad light setups are refused with file, place and reason") {
  const std::pair<std::string, const char*> cases[] = {
      {"", "JSON"},
      {"[]", "object"},
      {R"({"lights": []})", "schema"},
      {R"({"schema": "etak-lights/2"})", "etak-lights/1"},
      {R"({"schema": "etak-lights/1", "lamps": []})", "lamps"},
      {R"({"schema": "etak-lights/1", "schema": "etak-lights/1"})", "twice"},
      {R"({"schema": "etak-lights/1", "environment": {"file": ""}})", "/environment/file"},
      {R"({"schema": "etak-lights/1", "environment": {"file": "a.hdr", "scale": -1}})", "/environment/scale"},
      {R"({"schema": "etak-lights/1", "hemispheres": {"upper": [1, 1], "lower": [0, 0, 0]}})",
       "/hemispheres/upper"},
      {R"({"schema": "etak-lights/1", "hemispheres": {"upper": [1, 1, -1], "lower": [0, 0, 0]}})",
       "/hemispheres/upper/2"},
      {R"({"schema": "etak-lights/1", "hemispheres": {"upper": [1, 1, 1], "lower": [0, 0, 0], "form": "round"}})",
       "round"},
      {R"({"schema": "etak-lights/1", "hemispheres": {"upper": [1, 1, 1], "lower": [0, 0, 0], "axis": [0, 0, 0]}})",
       "length zero"},
      {R"({"schema": "etak-lights/1", "pi_scaled": 1})", "true or false"},
      {with_lights(R"({"kind": "area"})"), "/lights/0/kind"},
      {with_lights(R"({"kind": "point", "intensity": 1})"), "position"},
      {with_lights(R"({"kind": "point", "position": [0, 0, 2], "intensity": -1})"), "/lights/0/intensity"},
      {with_lights(R"({"kind": "point", "position": [0, 0, "2"], "intensity": 1})"), "/lights/0/position/2"},
      {with_lights(R"({"kind": "point", "position": [0, 0, 2], "intensity": 1, "direction": [0, 0, 1]})"),
       "direction"},
      {with_lights(R"({"kind": "directional", "direction": [0, 0, 0], "intensity": 1})"), "length zero"},
      {with_lights(R"({"kind": "directional", "direction": [0, 0, 1], "intensity": 1e999})"), "l.json"},
      {with_lights(
           R"({"kind": "spot", "position": [0, 0, 2], "direction": [0, 0, -1], "intensity": 1, "inner_deg": 30, "outer_deg": 20})"),
       "/lights/0/inner_deg"},
      {with_lights(
           R"({"kind": "spot", "position": [0, 0, 2], "direction": [0, 0, -1], "intensity": 1, "inner_deg": 30, "outer_deg": 120})"),
       "/lights/0/outer_deg"},
      {with_lights(
           R"({"kind": "disc", "position": [0, 0, 3], "direction": [0, 0, -1], "intensity": 1, "width": 0, "height": 1})"),
       "/lights/0/width"},
      {with_lights(
           R"({"kind": "rectangle", "position": [0, 0, 3], "direction": [0, 0, -1], "intensity": 1, "width": 1})"),
       "height"},
      {with_lights(
           R"({"kind": "rectangle", "position": [0, 0, 3], "direction": [0, 0, -1], "intensity": 1, "width": 1, "height": 1, "up": [0, 0, 0]})"),
       "length zero"},
      {R"({"schema": "etak-lights/1", "ground": {"albedo": [0.2, 0.2, 1.5]}})", "/ground/albedo/2"},
      {std::string(100, '['), "nesting"}};
  for (const auto& [text, part] : cases) {
    INFO(text);
    const std::string what = message(text);
    CHECK(what.find("l.json") == 0);
    CHECK(what.find(part) != std::string::npos);
    CHECK(what.find('\n') == std::string::npos);
  }
}

TEST_CASE("area lights and the ground read back as they were written") {
  LightSetup setup;
  setup.lights.resize(2);
  for (std::size_t i = 0; i < 2; ++i) {
    Light& light = setup.lights[i];
    light.kind = i == 0 ? LightKind::rectangle : LightKind::disc;
    light.position = {1.5, 2, 3};
    light.direction = normalised_direction({-1, -2, -3});
    light.up = normalised_direction({1, 1, 0.25});
    light.width = 0.7;
    light.height = 1.3;
  }
  setup.ground = Vec3{0.3, 0.2, 0.1};
  CHECK(parse_lights(format_lights(setup), "l.json") == setup);
}

TEST_CASE("setups made by hand are held to the same") {
  LightSetup setup = default_lights();
  CHECK_NOTHROW(validate(setup, "default"));
  CHECK(setup.lights.size() == 3);
  CHECK(setup.hemispheres.has_value());
  for (const Light& light : setup.lights)
    CHECK(std::hypot(light.direction[0], light.direction[1], light.direction[2]) == Approx(1).epsilon(1e-12));
  setup.lights[1].intensity = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(validate(setup, "x"), Error);
  setup = default_lights();
  setup.lights[0].direction = {0, 0, 0};
  CHECK_THROWS_AS(validate(setup, "x"), Error);
  setup = default_lights();
  setup.hemispheres->upper[1] = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(validate(setup, "x"), Error);
}

TEST_CASE("an environment takes the place of the hemispheres, none brings none back") {
  LightSetup setup = default_lights();
  choose_environment(setup, "sky.hdr");
  CHECK(setup.environment == "sky.hdr");
  CHECK(!setup.hemispheres);
  CHECK(setup.lights == default_lights().lights);
  choose_environment(setup, "");
  CHECK(setup.environment.empty());
  CHECK(!setup.hemispheres);
  setup = default_lights();
  choose_environment(setup, "");
  CHECK(setup == default_lights());
}

TEST_CASE("another environment takes the studio's flashes away, and the studio brings them back") {
  LightSetup setup = studio_lights();
  const std::size_t flashes = setup.lights.size();
  REQUIRE(flashes == 2);
  for (const NamedStudio& each : named_studios()) {
    if (each.name == setup.environment) continue;
    choose_environment(setup, std::string(each.name));
    CHECK(setup.lights.empty());
    CHECK(setup.environment_scale == 1);
  }
  choose_environment(setup, "studio");
  CHECK(setup == studio_lights());
  // Lights of one's own stay, a moved flash among them, and so does a scale of one's own.
  setup.lights[0].intensity *= 2;
  setup.environment_scale = 0.5;
  choose_environment(setup, "sky.hdr");
  REQUIRE(setup.lights.size() == 1);
  CHECK(setup.lights[0].intensity == 2 * studio_lights().lights[0].intensity);
  CHECK(setup.environment_scale == 0.5);
  // Without an environment the flashes are all the light there is.
  setup = studio_lights();
  choose_environment(setup, "");
  CHECK(setup.lights == studio_lights().lights);
  // The same environment again changes nothing, so that flashes that were taken out stay out.
  setup = studio_lights();
  setup.lights.clear();
  choose_environment(setup, "studio");
  CHECK(setup.lights.empty());
}

TEST_CASE("names of kinds and forms come back") {
  for (const LightKind kind : light_kinds) CHECK(light_kind_named(name(kind)) == kind);
  for (const HemisphereForm form : {HemisphereForm::corrected, HemisphereForm::wide, HemisphereForm::printed})
    CHECK(hemisphere_form_named(name(form)) == form);
  CHECK(!light_kind_named("area"));
  CHECK(!hemisphere_form_named(""));
  CHECK(light_rows().size() == 23);
}
