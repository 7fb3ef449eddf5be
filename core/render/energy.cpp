// SPDX-License-Identifier: Apache-2.0
#include "core/render/energy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/functions.h"

namespace etak {
namespace {

constexpr int polar_steps = 96, around_steps = 64;
using std::numbers::pi;

// Directions of light and viewer, in the arrays that Model::f32_batch() takes.
struct Rows {
  std::vector<float> lx, ly, lz, vx, vy, vz, red, green, blue;
  std::vector<double> weight;  // nl times the solid angle

  void clear() {
    for (auto* each : {&lx, &ly, &lz, &vx, &vy, &vz, &red, &green, &blue}) each->clear();
    weight.clear();
  }
  void add(const Vec3& l, const Vec3& v, double w) {
    const auto put = [](std::vector<float>& to, double value) { to.push_back(static_cast<float>(value)); };
    put(lx, l[0]), put(ly, l[1]), put(lz, l[2]);
    put(vx, v[0]), put(vy, v[1]), put(vz, v[2]);
    weight.push_back(w);
  }
  Vec3 sum(const Model& model, const std::vector<double>& values) {
    for (auto* each : {&red, &green, &blue}) each->assign(weight.size(), 0);
    const float* const directions[6] = {lx.data(), ly.data(), lz.data(), vx.data(), vy.data(), vz.data()};
    float* const rgb[3] = {red.data(), green.data(), blue.data()};
    model.f32_batch(weight.size(), directions, values.data(), rgb);
    Vec3 out{};
    for (std::size_t i = 0; i < weight.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) out[c] += double{rgb[c][i]} * weight[i];
    return out;
  }
};

}  // namespace

std::vector<float> quick_albedo(const Scene& scene, int steps) {
  std::vector<float> out;
  const std::vector<double> seen = seen_specular_values(scene);
  Rows rows;
  for (int step = 0; step < steps; ++step) {
    const double nv = std::max(double(step) / (steps - 1), 0.01), sine = std::sqrt(1 - nv * nv);
    const Vec3 v{sine, 0, nv};
    rows.clear();
    // The integral is taken over half vectors, because lobes are functions of these. The cube puts most
    // points close to the normal, where narrow lobes are.
    for (int i = 0; i < polar_steps; ++i) {
      const double t = (i + 0.5) / polar_steps, theta = pi / 2 * t * t * t;
      const double d_theta = pi / 2 * 3 * t * t / polar_steps;
      const double st = math::sin(theta), ct = math::cos(theta);
      for (int j = 0; j < around_steps; ++j) {
        const double phi = 2 * pi * (j + 0.5) / around_steps;
        const Vec3 h{st * math::cos(phi), st * math::sin(phi), ct};
        const double vh = h[0] * v[0] + h[2] * v[2];
        if (vh <= 0) continue;
        const Vec3 l{2 * vh * h[0] - v[0], 2 * vh * h[1], 2 * vh * h[2] - v[2]};
        if (l[2] <= 0) continue;
        rows.add(l, v, l[2] * 4 * vh * st * d_theta * 2 * pi / around_steps);
      }
    }
    Vec3 all{};
    if (!rows.weight.empty()) {
      if (scene.specular != nullptr) all = rows.sum(*scene.specular, seen);
      if (scene.diffuse != nullptr) {
        const Vec3 body = rows.sum(*scene.diffuse, scene.diffuse_values);
        for (std::size_t c = 0; c < 3; ++c) all[c] += scene.surface.opacity * body[c];
      }
    }
    out.push_back(static_cast<float>(std::max({all[0], all[1], all[2]})));
  }
  return out;
}

}  // namespace etak
