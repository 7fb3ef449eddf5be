// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>

#include "core/base/number.h"
#include "core/brdf/models.h"
#include "tests/gl/gl_here.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr std::size_t sets = 160, directions_per_set = 160;  // 25,600 inputs per model

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

double log_uniform(Random& random, double low, double high) {
  return std::exp(uniform(random, std::log(low), std::log(high)));
}

// Numbers are rounded to float first: the same inputs for both sides. Volatile, because GCC 12 drops the two
// conversions where it makes vectors of neighbouring ones.
double as_float(double x) {
  const volatile float rounded = static_cast<float>(x);
  return double{rounded};
}

// Within the ranges for which the tolerances are stated (n in [0.1, 4], k in [0, 8]), and those of pictures.
double value_of(const Parameter& parameter, Random& random) {
  const auto within = [&](double low, double high) {
    return std::pair(std::max(parameter.min, low), std::min(parameter.max, high));
  };
  // Clear media: at the critical angle F has a vertical tangent, which small ratios n2 / n1 make steeper
  // still.
  if (parameter.name == "n1" || parameter.name == "n2") return uniform(random, 1, 2.5);
  switch (parameter.role) {
    case Role::n: {
      const auto [low, high] = within(0.1, 4);
      return log_uniform(random, low, high);
    }
    case Role::k:
      return uniform(random, 0, 8);
    case Role::alpha: {
      const auto [low, high] = within(0.01, 1);
      return log_uniform(random, low, high);
    }
    case Role::exponent: {
      const auto [low, high] = within(1, 4096);
      return log_uniform(random, low, high);
    }
    // A dip down to nothing is no metal's: there F is a difference of near equals, in any precision.
    case Role::f82:
      return uniform(random, 0.3, 1);
    default:
      break;
  }
  if (parameter.name == "a1") return log_uniform(random, 1, 1e4);
  if (parameter.name == "a2") return uniform(random, 0.5, 4);
  const auto [low, high] = within(-2, 10);
  return uniform(random, low, high);
}

struct V {
  double x, y, z;
};
V unit(V v) {
  const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return {as_float(v.x / length), as_float(v.y / length), as_float(v.z / length)};
}

V on_hemisphere(Random& random) {
  const double z = uniform(random, 0.01, 1), phi = uniform(random, 0, 2 * std::numbers::pi),
               s = std::sqrt(1 - z * z);
  return unit({s * std::cos(phi), s * std::sin(phi), z});
}

// Every other light direction near the mirror direction, where the lobes are.
std::vector<Directions> random_directions(Random& random) {
  std::vector<Directions> out;
  while (out.size() < directions_per_set) {
    const V v = on_hemisphere(random);
    V l = on_hemisphere(random);
    if (out.size() % 2 == 0) {
      const double width = log_uniform(random, 1e-3, 0.5);
      const V h = unit({width * uniform(random, -1, 1), width * uniform(random, -1, 1), 1});
      const double vh = v.x * h.x + v.y * h.y + v.z * h.z;
      l = unit({2 * vh * h.x - v.x, 2 * vh * h.y - v.y, 2 * vh * h.z - v.z});
      if (l.z < 0.01) continue;
    }
    out.push_back({l.x, l.y, l.z, v.x, v.y, v.z});
  }
  return out;
}

struct Class {
  const char* name;
  double tolerance;
};

// The least exact part of a text decides.
Class class_of(const std::string& text) {
  if (contains(text, "log2(") || contains(text, "pow(")) return {"power lobe", 5e-4};
  if (contains(text, "fresnel_exact") || contains(text, "fresnel_dielectric")) return {"exact Fresnel", 1e-4};
  if (contains(text, "exp(") || contains(text, "exp2") || contains(text, "d_ggx"))
    return {"exponential or GGX", 5e-5};
  return {"algebraic", 1e-6};
}

std::string printed(const std::vector<double>& values) {
  std::string out;
  for (const double value : values) out += number(value, 9) + " ";
  return out;
}

}  // namespace

TEST_CASE("a second runner takes nothing from the first, while it lives and after") {
  GlRunner* gl = gl_here();
  if (gl == nullptr) return;
  const std::string_view sum = "real(1.5) + real(2)";
  CHECK(gl->evaluate(sum) == 3.5f);
  {
    std::string why;
    auto other = GlRunner::open(why);
    REQUIRE(other);
    CHECK(other->evaluate(sum) == 3.5f);
    CHECK(gl->evaluate(sum) == 3.5f);
    CHECK(other->evaluate(sum) == 3.5f);
  }
  CHECK(gl->evaluate(sum) == 3.5f);
}

TEST_CASE("OpenGL agrees with double precision on 25,600 random inputs of every model") {
  GlRunner* gl = gl_here();
  if (gl == nullptr) return;
  std::printf("%s, OpenGL %s%s\n", gl->info().renderer.c_str(), gl->info().version.c_str(),
              gl->info().software ? ": a software rasteriser" : "");
  const bool verbose = std::getenv("ETAK_GL_ERRORS") != nullptr;
  std::vector<Model> all(models().begin(), models().end());
  all.push_back(*find_model("microfacet:ggx,curve,smith-ggx-height"));  // that of stacks of layers
  for (const Model& model : all) {
    Random random(7);
    Class kind{};
    double worst = 0, worst_f32 = 0;
    std::string where;
    for (std::size_t set = 0; set < sets; ++set) {
      std::vector<double> values;
      for (const Parameter& parameter : model.parameters)
        for (int c = 0; c < (parameter.color ? 3 : 1); ++c)
          values.push_back(as_float(value_of(parameter, random)));
      if (set == 0) kind = class_of(glsl_evaluation_text(model, values).fragment);
      const std::vector<Directions> directions = random_directions(random);
      std::vector<std::array<double, 3>> expected(directions.size());
      double peak = 0;
      for (std::size_t i = 0; i < directions.size(); ++i) {
        model.f64(directions[i], values.data(), expected[i].data());
        for (const double value : expected[i]) peak = std::max(peak, std::abs(value));
      }
      const auto found = gl->evaluate(model, values, directions);
      for (std::size_t i = 0; i < directions.size(); ++i) {
        float single[3];
        model.f32(directions[i], values.data(), single);
        for (std::size_t c = 0; c < 3; ++c)
          worst_f32 = std::max(worst_f32, std::abs(double{single[c]} - expected[i][c]) /
                                              std::max(std::abs(expected[i][c]), 1e-4 * peak));
        for (std::size_t c = 0; c < 3; ++c) {
          const double scale = std::max(std::abs(expected[i][c]), 1e-4 * peak);
          const double error = scale > 0 ? std::abs(double{found[i][c]} - expected[i][c]) / scale
                                         : std::abs(double{found[i][c]});
          if (!(error <= worst)) {
            worst = std::isnan(error) ? 1e30 : error;
            const Directions& d = directions[i];
            char text[400];
            std::snprintf(text, sizeof text, "l %.9g %.9g %.9g v %.9g %.9g %.9g: GL %.9g, f64 %.9g; ", d.lx,
                          d.ly, d.lz, d.vx, d.vy, d.vz, double{found[i][c]}, expected[i][c]);
            where = text + printed(values);
          }
        }
      }
    }
    if (verbose)
      std::printf("%-30s %-20s %9.2e of %.0e, f32 %9.2e%s\n", std::string(model.id).c_str(), kind.name, worst,
                  kind.tolerance, worst_f32, worst > kind.tolerance ? ("  MISSED " + where).c_str() : "");
    INFO(model.id << " (" << kind.name << "): " << where);
    CHECK(worst <= kind.tolerance);
  }
}

TEST_CASE("both directions must be above the surface, and l = -v gives 0") {
  GlRunner* gl = gl_here();
  if (gl == nullptr) return;
  const double s = as_float(std::sqrt(0.5));
  const std::vector<Directions> directions{
      {s, 0, -s, 0, 0, 1}, {0, 0, 1, s, 0, -s}, {s, 0, 0, -s, 0, 0}, {1, 0, 0, 1, 0, 0}};
  for (const Model& model : models()) {
    INFO(model.id);
    std::vector<double> values;
    for (const Parameter& parameter : model.parameters)
      for (int c = 0; c < (parameter.color ? 3 : 1); ++c) values.push_back(parameter.initial);
    for (const auto& rgb : gl->evaluate(model, values, directions))
      CHECK(rgb == std::array<float, 3>{0, 0, 0});
  }
}

TEST_CASE("a broken text is refused with the line that the driver names") {
  GlRunner* gl = gl_here();
  if (gl == nullptr) return;
  const GlslText text = glsl_text([] {
    Scene scene;
    scene.specular = find_model("schueler-ksk");
    scene.specular_values = model_values(*scene.specular, scene.surface, {});
    return scene;
  }());
  CHECK_FALSE(gl->compile_error(text.vertex, text.fragment));
  const auto error =
      gl->compile_error(text.vertex, text.fragment + "\nvoid broken() { no_such_name = 1.0; }\n");
  REQUIRE(error);
  CHECK(contains(*error, "void broken() { no_such_name = 1.0; }"));
}
