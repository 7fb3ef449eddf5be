// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/math/functions.h"
#include "core/math/mat3.h"

namespace etak {
namespace {
namespace formulas {
#include "core/math/real_f64.h"

#include "core/fresnel/texts.h"

#include "core/light/texts.h"
}  // namespace formulas

using formulas::vec3;

vec3 unit(double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

// Snell's law for vectors: `d` meets a surface with normal `n` that faces it; `ratio` is n before over n behind.
vec3 refracted(const vec3& d, const vec3& n, double ratio) {
  const double c = -formulas::dot(d, n), under = 1 - ratio * ratio * (1 - c * c);
  return d * ratio + n * (ratio * c - std::sqrt(under));
}

// The direction behind a ball of radius 1, traced from surface to surface.
vec3 traced(const vec3& n, const vec3& v, double eta) {
  const vec3 inside = refracted(v * -1.0, n, 1 / eta);
  const double way = -2 * formulas::dot(inside, n);
  const vec3 out = n + inside * way;
  return refracted(inside, out * -1.0, eta);
}

double apart(const vec3& a, const vec3& b) {
  const vec3 d = a - b;
  return std::sqrt(formulas::dot(d, d));
}

}  // namespace

TEST_CASE("a ray goes through a clear ball as it does from surface to surface") {
  const vec3 v = unit(0.1, -0.2, 1);
  for (const double eta : {1.0, 1.0003, 1.333, 1.5, 2.417})
    for (const vec3& n : {v, unit(0.3, 0.2, 1), unit(-0.9, 0.1, 0.5), unit(0.1, 0.99, 0.3)}) {
      CAPTURE(eta, n.x, n.y);
      const vec3 found = formulas::beyond_ball(n, v, eta);
      CHECK(apart(found, traced(n, v, eta)) < 1e-9);
      CHECK(formulas::dot(found, found) == Approx(1));
    }
  // Through the middle, and through a ball of nothing, it goes straight on.
  CHECK(apart(formulas::beyond_ball(v, v, 1.7), v * -1.0) < 1e-12);
}

TEST_CASE("of the light behind a clear ball comes what both surfaces and the way inside leave") {
  const vec3 all(1, 1, 1);
  CHECK(formulas::through_ball(1, 1.5, all).x == Approx(0.96 * 0.96));
  CHECK(formulas::through_ball(0.3, 1, all).y == Approx(1));
  CHECK(formulas::through_ball(0, 1.5, all).z == Approx(0).margin(1e-12));
  const vec3 half = formulas::through_ball(1, 1, {0.5, 0.25, 1});
  CHECK(half.x == Approx(0.5));
  CHECK(half.y == Approx(0.25));
  // At the edge of a ball of n = 2 the way inside is the chord of 30 degrees: cos 30 of a diameter.
  CHECK(formulas::cosine_in_ball(0, 2) == Approx(std::sqrt(3.0) / 2));
  // Light that would be reflected wholly does not come, and gives no NaN.
  CHECK(formulas::through_ball(0.1, 0.6, all).x == 0);
  CHECK(std::isfinite(formulas::beyond_ball(unit(0.99, 0, 0.1), {0, 0, 1}, 0.6).x));
}

TEST_CASE("a ball's shadow on the ground is the share of an even sky's irradiance that it hides") {
  CHECK(formulas::contact_shadow(0) == 1);
  for (const double r : {0.3, 1.0, 2.5}) {
    // The share of the ground's half sphere, by cosine, of directions that meet the ball at (-r, 1, 0).
    constexpr int side = 600;
    double hidden = 0, sum = 0;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const double x = (2 * i + 1.0) / side - 1, z = (2 * j + 1.0) / side - 1, y2 = 1 - x * x - z * z;
        if (y2 <= 0) continue;
        ++sum;
        const double along = -r * x + std::sqrt(y2);
        if (along > 0 && r * r + 1 - along * along < 1) ++hidden;
      }
    CHECK(formulas::contact_shadow(r * r) == Approx(hidden / sum).epsilon(0.01));
  }
  // Seen from the front, the ground begins below the eye, and is darkest where the ball lies.
  const vec3 eye(0, 0, 4);
  CHECK(formulas::ground_light(eye, unit(0, 0.1, -1)) == 1);
  CHECK(formulas::ground_light(eye, unit(0, -1, -4)) == Approx(0).margin(1e-12));
  CHECK(formulas::ground_light(eye, unit(0.5, -1, -4)) > 0.1);
  CHECK(formulas::ground_light({0, -2, 4}, unit(0, -1, -1)) == 1);  // from below there is no ground
}

TEST_CASE("false colours tell bands of stops about 18 % grey") {
  const auto at = [](double stops) { return formulas::tone_false_color(vec3(0.18 * std::exp2(stops))); };
  const auto same = [](const vec3& a, const vec3& b) { return apart(a, b) == 0; };
  CHECK(same(at(-0.4), at(0.4)));
  CHECK(at(0).y > at(0).x);  // green
  double edges[] = {-6, -4, -2, -0.5, 0.5, 1.5, std::log2(1 / 0.18)};
  for (const double edge : edges) {
    CAPTURE(edge);
    CHECK(!same(at(edge - 0.01), at(edge + 0.01)));
  }
  CHECK(same(at(-20), at(-6.1)));
  CHECK(same(formulas::tone_false_color(vec3(0, 0, 0)), at(-20)));
  CHECK(same(at(2.5), at(9)));
  CHECK(at(2.5).x > 10 * at(2.5).y);  // what clips is red
}

}  // namespace etak
