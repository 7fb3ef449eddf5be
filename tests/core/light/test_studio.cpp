// SPDX-License-Identifier: Apache-2.0
#include "core/light/studio.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "core/color/luminance.h"

namespace etak {
namespace {

Vec3 along(double x, double y, double z) {
  return normalised_direction({x, y, z});
}

}  // namespace

TEST_CASE("a studio is its wall, its floor, and its lamps before them") {
  Studio studio;
  studio.floor = {0.1, 0.2, 0.3};
  studio.horizon = {1, 1, 1};
  studio.top = {0, 0, 0};
  studio.fall = 2;
  CHECK(radiance(studio, {0, -1, 0}) == Vec3{0.1, 0.2, 0.3});
  CHECK(radiance(studio, {0, 1, 0})[1] == Approx(0).margin(1e-12));
  CHECK(radiance(studio, along(std::sqrt(3.0), 1, 0))[0] == Approx(0.25));  // half way up: (1 - 1/2)^2
  CHECK(radiance(studio, along(1, 0, 0))[0] == Approx((0.1 + 1) / 2));      // the middle of the skirting

  Lamp lamp;  // 45 degrees to each side of +z
  lamp.half_width = 1;
  lamp.half_height = 1;
  lamp.edge = 0.2;
  lamp.radiance = {7, 5, 3};
  studio.lamps.push_back(lamp);
  CHECK(radiance(studio, {0, 0, 1}) == lamp.radiance);
  CHECK(radiance(studio, along(0.7, 0.7, 1)) == lamp.radiance);  // a corner of what is whole
  CHECK(radiance(studio, along(0.9, 0.5, 1))[0] < 7);            // half way out of the edge
  CHECK(radiance(studio, along(0.9, 0.5, 1))[0] > 1);
  const Vec3 beside = radiance(studio, along(1.01, 0.5, 1));
  CHECK(beside[0] < 1);
  CHECK(radiance(studio, {0, 0, -1})[0] < 1);  // not from behind
  studio.lamps[0].round = true;
  CHECK(radiance(studio, along(0.8, 0.8, 1))[0] < 1);
}

TEST_CASE("the irradiance before the camera is the closed form where there is one") {
  Studio even;
  even.floor = even.horizon = even.top = {2, 1, 0.5};
  const Vec3 all = irradiance_before_camera(even);
  CHECK(all[0] == Approx(2 * std::numbers::pi).epsilon(1e-9));
  CHECK(all[2] == Approx(0.5 * std::numbers::pi).epsilon(1e-9));
  Studio half;  // of an even sky, a vertical plane sees half
  half.horizon = half.top = {1, 1, 1};
  half.skirting = 1e-3;
  CHECK(irradiance_before_camera(half)[0] == Approx(std::numbers::pi / 2).epsilon(1e-3));
  Studio round;  // a cap of half angle a around +z: pi sin^2 a
  Lamp lamp;
  lamp.round = true;
  lamp.edge = 1e-3;
  lamp.half_width = lamp.half_height = std::tan(0.5);
  round.lamps = {lamp};
  CHECK(irradiance_before_camera(round)[1] ==
        Approx(std::numbers::pi * std::sin(0.5) * std::sin(0.5)).epsilon(0.01));
}

TEST_CASE("etak's studios are five, found by name, and exposed for a grey card that faces the camera") {
  std::set<std::string_view> names;
  for (const NamedStudio& each : named_studios()) {
    CAPTURE(std::string(each.name));
    names.insert(each.name);
    REQUIRE(find_studio(each.name) != nullptr);
    CHECK(*find_studio(each.name) == each.studio);
    CHECK(luminance_of(irradiance_before_camera(each.studio)) == Approx(std::numbers::pi).epsilon(1e-9));
    for (const Vec3* color : {&each.studio.floor, &each.studio.horizon, &each.studio.top})
      for (const double value : *color) CHECK(value >= 0);
    for (const Lamp& lamp : each.studio.lamps) {
      CHECK(dot(lamp.towards, lamp.towards) == Approx(1));
      CHECK(dot(lamp.right, lamp.right) == Approx(1));
      CHECK(dot(lamp.towards, lamp.right) == Approx(0).margin(1e-12));
      CHECK(dot(lamp.towards, lamp.up) == Approx(0).margin(1e-12));
      CHECK(dot(lamp.right, lamp.up) == Approx(0).margin(1e-12));
    }
  }
  CHECK(names == std::set<std::string_view>{"studio", "rim", "overcast", "sunset", "night"});
  CHECK(find_studio("studio.hdr") == nullptr);
  CHECK(find_studio("") == nullptr);
}

TEST_CASE("the overcast sky is the one of the CIE") {
  const Studio& sky = *find_studio("overcast");
  const double zenith = radiance(sky, {0, 1, 0})[1];
  for (const double y : {0.1, 0.5, 0.9})
    CHECK(radiance(sky, along(std::sqrt(1 - y * y), y, 0))[1] == Approx(zenith * (1 + 2 * y) / 3));
}

TEST_CASE("the standard light is the studio and two flashes, and gives a plane before the camera pi") {
  const LightSetup setup = studio_lights();
  CHECK_NOTHROW(validate(setup, "standard"));
  CHECK(!setup.hemispheres);
  CHECK(find_studio(setup.environment) != nullptr);
  double facing = setup.environment_scale * std::numbers::pi;
  for (const Light& light : setup.lights) facing += light.intensity * std::max(0.0, -light.direction[2]);
  CHECK(facing == Approx(std::numbers::pi).epsilon(1e-9));
  CHECK(setup.lights.size() == 2);
}

}  // namespace etak
