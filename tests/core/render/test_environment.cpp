// SPDX-License-Identifier: Apache-2.0
#include "core/render/environment.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/color/luminance.h"
#include "core/color/srgb.h"
#include "core/render/cpu_renderer.h"
#include "core/render/reference.h"
#include "tests/support.h"

namespace etak {
namespace {

Vec3 unit(double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

}  // namespace

TEST_CASE("a white environment gives radiance 1, irradiance std::numbers::pi, and 1 through every lobe") {
  const Environment white(Image(64, 32, 3, 1.0f), 1, "white", 1);
  for (const Vec3& d : {unit(0, 0, 1), unit(1, 0, 0), unit(0, 1, 0), unit(-0.3, -0.9, 0.2)}) {
    CHECK(white.radiance(d)[0] == Approx(1));
    CHECK(white.irradiance(d)[1] == Approx(std::numbers::pi).epsilon(2e-3));
    for (const double gloss : {0.0, 0.31, 0.5, 1.0})
      CHECK(white.specular(d, gloss)[2] == Approx(1).epsilon(1e-5));
  }
}

TEST_CASE("every lobe sees light in maps that are coarser than it") {
  for (const int width : {2, 4, 8, 16}) {
    const Environment white(Image(width, width / 2 + 1, 3, 1.0f), 1, "white", 1);
    for (const Vec3& d : {unit(0, 0, 1), unit(0.2, 1, 0), unit(-0.3, -0.9, 0.2), unit(0.7, 0.1, 0.4)})
      for (const double gloss : {0.0, 0.5, 0.9, 1.0})
        CHECK(white.specular(d, gloss)[1] == Approx(1).epsilon(1e-5));
  }
}

TEST_CASE("the middle of the map is -z, a quarter right of it +x, the top +y") {
  Image map(8, 4, 3, 0.0f);
  map.at(4, 1)[0] = 1;
  map.at(6, 1)[1] = 1;
  map.at(2, 0)[2] = 1;
  const Environment environment(map, 2, "map", 1);
  CHECK(environment.radiance(unit(std::sin(std::numbers::pi / 8), std::tan(std::numbers::pi / 8),
                                  -std::cos(std::numbers::pi / 8)))[0] > 1.5);
  CHECK(environment.radiance(unit(1, 0.4, 0.4))[1] > 1);
  CHECK(environment.radiance(unit(-0.05, 1, -0.05))[2] >= 0);
}

TEST_CASE("the irradiance under a sky of one hemisphere is the closed form") {
  Image map(256, 128, 3, 0.0f);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 256; ++x)
      for (std::size_t c = 0; c < 3; ++c) map.at(x, y)[c] = 1;
  const Environment sky(map, 1, "sky", 2);
  // The irradiance is pi (1 + n.y) / 2.
  for (const double y : {-0.9, -0.5, 0.0, 0.4, 0.95}) {
    const Vec3 n{std::sqrt(1 - y * y), y, 0};
    CHECK(sky.irradiance(n)[0] == Approx(std::numbers::pi * (1 + y) / 2).epsilon(0.01).margin(0.01));
  }
}

TEST_CASE("sampling by luminance: the density integrates to 1 and its samples estimate the integral") {
  const Environment studio(environment_picture(*find_studio("studio"), 128), 1, "studio", 2);
  double mass = 0, flux = 0, estimate = 0;
  const int rows = 256, columns = 512;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const double theta = std::numbers::pi * (y + 0.5) / rows,
                   phi = 2 * std::numbers::pi * (x + 0.5) / columns;
      const Vec3 d{std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
      const double omega = std::sin(theta) * (std::numbers::pi / rows) * (2 * std::numbers::pi / columns);
      mass += studio.pdf(d) * omega;
      flux += studio.radiance(d)[1] * omega;
    }
  CHECK(mass == Approx(1).epsilon(1e-3));
  const int side = 64;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const Vec3 d = studio.sample((i + 0.5) / side, (j + 0.5) / side);
      CHECK(d[0] * d[0] + d[1] * d[1] + d[2] * d[2] == Approx(1));
      estimate += studio.radiance(d)[1] / studio.pdf(d) / (side * side);
    }
  CHECK(estimate == Approx(flux).epsilon(0.03));
}

TEST_CASE("maps are the same for any number of threads") {
  const Image map = environment_picture(*find_studio("studio"), 128);
  const Environment one(map, 1, "studio", 1), three(map, 1, "studio", 3);
  CHECK(one.irradiance_map() == three.irradiance_map());
  REQUIRE(one.levels().size() == three.levels().size());
  for (std::size_t i = 0; i < one.levels().size(); ++i) CHECK(one.levels()[i].map == three.levels()[i].map);
  CHECK(one.levels().front().gloss == 1);
  CHECK(one.levels().back().gloss == 0);
}

// The sums that a prefiltered pixel is made of, over every pixel of the map one by one.
struct DirectSums {
  double light = 0, weight = 0;
};
template <class Weight>
DirectSums direct_sums(const Image& map, const Vec3& around, Weight weight) {
  using std::numbers::pi;
  DirectSums out;
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const double phi = 2 * pi * ((x + 0.5) / map.width - 0.5), theta = pi * (y + 0.5) / map.height;
      const Vec3 d{std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
      const double c = d[0] * around[0] + d[1] * around[1] + d[2] * around[2];
      if (c <= 0) continue;
      const double omega =
          2 * pi / map.width * (std::cos(pi * y / map.height) - std::cos(pi * (y + 1) / map.height));
      out.light += weight(c) * omega * double{map.at(x, y)[1]};
      out.weight += weight(c) * omega;
    }
  return out;
}

TEST_CASE("a prefiltered pixel is the weighted sum over all pixels of the map, whatever its width") {
  using std::numbers::pi;
  for (const int width : {37, 48, 50, 64, 128}) {
    Image map(width, width / 2 + 3, 3);
    for (std::size_t i = 0; i < map.values.size(); ++i)
      map.values[i] = static_cast<float>((i * 7919) % 101) / 50;
    const Environment environment(map, 1, "map", 2);
    const auto direction_in = [&](const Image& of, int x, int y) {
      const double phi = 2 * pi * ((x + 0.5) / of.width - 0.5), theta = pi * (y + 0.5) / of.height;
      return Vec3{std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
    };
    const auto places = [](const Image& of) {
      return std::array<std::array<int, 2>, 5>{{{0, 0},
                                                {of.width - 1, of.height - 1},
                                                {of.width / 3, of.height / 4},
                                                {of.width / 2 + 1, of.height / 2},
                                                {of.width - 2, of.height - 3}}};
    };
    const Image& irradiance = environment.irradiance_map();
    for (const auto& [x, y] : places(irradiance)) {
      INFO("width " << width << ", irradiance at " << x << ", " << y);
      const DirectSums sums = direct_sums(map, direction_in(irradiance, x, y), [](double c) { return c; });
      CHECK(irradiance.at(x, y)[1] == Approx(sums.light).epsilon(1e-5));
    }
    for (const Environment::Level& level : environment.levels()) {
      // Sharper lobes see a few pixels of such a map, of which a table's steps would decide; and larger maps are
      // made smaller first.
      if (level.gloss > 0.5 || width > 64) continue;
      const double e = std::exp2(12 * level.gloss);
      for (const auto& [x, y] : places(level.map)) {
        INFO("width " << width << ", gloss " << level.gloss << " at " << x << ", " << y);
        const DirectSums sums = direct_sums(map, direction_in(level.map, x, y),
                                            [&](double c) { return std::pow((1 + c) / 2, e / 2 - 1) * c; });
        CHECK(level.map.at(x, y)[1] == Approx(sums.light / sums.weight).epsilon(3e-3));
      }
    }
  }
}

TEST_CASE("sides that are no powers of two are taken") {
  const Environment odd(Image(701, 333, 3, 0.5f), 2, "odd", 2);
  CHECK(odd.irradiance(unit(0.3, 0.5, -0.2))[0] == Approx(std::numbers::pi).epsilon(2e-3));
  CHECK(odd.specular(unit(0, 0, 1), 0.9)[0] == Approx(1).epsilon(1e-5));
}

TEST_CASE("broken environments are refused by name") {
  const auto message = [](Image map, double scale = 1) {
    return test::error_of([&] { (void)Environment(map, scale, "sky.exr", 1); });
  };
  CHECK(test::contains(message(Image(8, 4, 1, 1.0f)), "sky.exr"));
  Image map(8, 4, 3, 1.0f);
  CHECK(test::contains(message(map, -1), "scale"));
  CHECK(test::contains(message(map, std::nan("")), "scale"));
  map.at(3, 2)[1] = -1;
  CHECK(test::contains(message(map), "column 3, row 2"));
  map.at(3, 2)[1] = std::numeric_limits<float>::infinity();
  CHECK(test::contains(message(map), "radiance"));
}

TEST_CASE("a flat patch of 18 % that faces the camera shows 118 in every studio and in the standard light") {
  Scene scene;
  scene.shape = Shape::quad;
  scene.width = scene.height = 16;
  scene.diffuse = find_model("lambert");
  scene.surface.diffuse = {0.18, 0.18, 0.18};
  scene.diffuse_values = model_values(*scene.diffuse, scene.surface, {});
  const auto patch = [&](const Environment& environment) {
    Image picture;
    render_cpu(scene, &environment, 1, Precision::f32, picture);
    const float* const at = picture.at(8, 8).data();
    return std::array<double, 4>{double{at[0]}, double{at[1]}, double{at[2]},
                                 luminance_of<double>(at[0], at[1], at[2])};
  };
  const auto code = [](double linear) { return 255 * srgb_encode(linear); };
  for (const NamedStudio& each : named_studios()) {
    const std::array<double, 4> seen =
        patch(Environment(environment_picture(each.studio, 512, 2), 1, std::string(each.name), 2));
    CAPTURE(std::string(each.name), seen[0], seen[1], seen[2]);
    CHECK(code(seen[3]) == Approx(118).margin(3));
    // The sunset alone has a colour.
    if (each.name == "sunset") continue;
    for (std::size_t c = 0; c < 3; ++c) CHECK(code(seen[c]) == Approx(118).margin(3));
  }
  scene.lights = studio_lights();
  const auto standard = studio_environment(scene.lights.environment, scene.lights.environment_scale, 2);
  for (std::size_t c = 0; c < 3; ++c) CHECK(code(patch(*standard)[c]) == Approx(118).margin(3));
}

TEST_CASE("a studio's environment is made once, and one of another name is refused") {
  const LightSetup standard = studio_lights();
  const auto one = studio_environment(standard.environment, standard.environment_scale, 2);
  CHECK(one == studio_environment(standard.environment, standard.environment_scale, 1));
  CHECK(one->map().width == 1024);
  CHECK(test::contains(test::error_of([] { (void)studio_environment("sky.hdr", 1, 1); }), "overcast"));
}

TEST_CASE("the prefiltered light is near the sampled one, nearer for sharper lobes") {
  const Environment studio(environment_picture(*find_studio("studio"), 256), 1, "studio", 2);
  Scene scene;
  scene.width = scene.height = 40;
  scene.surface.f0 = {0.9, 0.9, 0.9};
  scene.specular = find_model("phong-kelemen");
  struct Bound {
    double gloss, mean;
  };
  for (const Bound& bound : {Bound{0.5, 0.25}, Bound{0.75, 0.15}, Bound{1.0, 0.15}}) {
    scene.surface.gloss = bound.gloss;
    scene.specular_values = model_values(*scene.specular, scene.surface, {});
    const AmbientError error = ambient_error(scene, &studio, {2, 64, 2});
    CAPTURE(bound.gloss, error.mean, error.bias, error.worst, error.standard_error);
    CHECK(error.mean < bound.mean);
    CHECK(std::abs(error.bias) < bound.mean);
  }
  // A matte body has no lobe that is split off, so only the interpolation of the map causes an error.
  scene.specular = nullptr;
  scene.diffuse = find_model("lambert");
  scene.surface.diffuse = {0.8, 0.8, 0.8};
  scene.diffuse_values = model_values(*scene.diffuse, scene.surface, {});
  const AmbientError matte = ambient_error(scene, &studio, {2, 256, 2});
  CAPTURE(matte.mean, matte.bias, matte.standard_error);
  CHECK(std::abs(matte.bias) < 0.01);
  CHECK(matte.mean < 0.05);
}

}  // namespace etak
