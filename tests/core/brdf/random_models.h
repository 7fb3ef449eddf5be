// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "core/brdf/integrals/albedo.h"
#include "core/brdf/models.h"

/// Random parameters and directions for tests over the whole registry.
namespace etak::test {

using Random = std::mt19937_64;

inline double uniform(Random& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}
inline double log_uniform(Random& random, double low, double high) {
  return std::exp(uniform(random, std::log(low), std::log(high)));
}

/// A random value in the range that is common for parameters of this kind.
inline double random_value(Random& random, const Parameter& p) {
  // Total reflection is avoided, because next to the critical angle the slope is infinite and float loses all
  // digits.
  if (p.name == "n1") return uniform(random, 1, 1.3);
  if (p.name == "n2") return uniform(random, 1.3, 3);
  switch (p.role) {
    case Role::n:
      return log_uniform(random, 0.1, 5);
    case Role::k:
      return uniform(random, 0, 8);
    case Role::alpha:
      return log_uniform(random, 0.02, 1);
    case Role::f82:  // far below this the curve dips to 0, where float has no digits left
      return uniform(random, 0.5, 1);
    case Role::exponent:
      return log_uniform(random, 1, 4096);
    default:
      break;
  }
  if (p.name == "a1") return log_uniform(random, 1, 1e4);
  if (p.name == "a2") return uniform(random, 0.5, 4);
  if (p.name == "p") return uniform(random, 0.2, 4);
  if (p.name == "fit_a") return uniform(random, 0, 0.5);
  if (p.name == "fit_alpha") return uniform(random, 1, 8);
  return uniform(random, p.min, p.max);
}

inline std::vector<double> random_values(Random& random, const Model& model) {
  std::vector<double> out;
  for (const Parameter& p : model.parameters)
    for (int i = 0; i < (p.color ? 3 : 1); ++i) out.push_back(random_value(random, p));
  return out;
}

inline void set_role(const Model& model, Role role, double value, std::vector<double>& values) {
  std::size_t at = 0;
  for (const Parameter& p : model.parameters)
    for (int i = 0; i < (p.color ? 3 : 1); ++i, ++at)
      if (p.role == role) values[at] = value;
}
inline bool has_role(const Model& model, Role role) {
  return std::any_of(model.parameters.begin(), model.parameters.end(),
                     [&](const Parameter& p) { return p.role == role; });
}

/// A random pair of directions above the surface, uniform in the cosine from `least` up. Every fourth pair is
/// near the mirror configuration, where lobes are.
inline Directions random_directions(Random& random, double least = 0.02) {
  const auto one = [&](double& x, double& y, double& z) {
    z = uniform(random, least, 1);
    const double s = std::sqrt(1 - z * z), phi = uniform(random, 0, 2 * 3.14159265358979323846);
    x = s * std::cos(phi);
    y = s * std::sin(phi);
  };
  Directions d{};
  one(d.lx, d.ly, d.lz);
  one(d.vx, d.vy, d.vz);
  if (random() % 4 == 0) {
    const double spread = log_uniform(random, 1e-3, 0.3);
    double x = -d.lx + spread * uniform(random, -1, 1), y = -d.ly + spread * uniform(random, -1, 1);
    double z = std::max(d.lz + spread * uniform(random, -1, 1), least);
    const double length = std::sqrt(x * x + y * y + z * z);
    d.vx = x / length;
    d.vy = y / length;
    d.vz = z / length;
  }
  return d;
}

inline Directions directions_deg(double theta_l, double theta_v, double phi_v) {
  const Vec3 l = direction_deg(theta_l, 0), v = direction_deg(theta_v, phi_v);
  return {l[0], l[1], l[2], v[0], v[1], v[2]};
}

inline float rounded(double x) {
  return static_cast<float>(x);
}

/// One pair of directions through the vector loop, and through the one for far lights.
inline std::array<float, 3> by_loop(const Model& model, const Directions& d,
                                    const std::vector<double>& values) {
  const float in[6] = {rounded(d.lx), rounded(d.ly), rounded(d.lz),
                       rounded(d.vx), rounded(d.vy), rounded(d.vz)};
  const float* arrays[6] = {in, in + 1, in + 2, in + 3, in + 4, in + 5};
  std::array<float, 3> out{-1, -1, -1};
  float* results[3] = {&out[0], &out[1], &out[2]};
  model.f32_batch(1, arrays, values.data(), results);
  return out;
}
inline std::array<float, 3> by_far_loop(const Model& model, const Directions& d,
                                        const std::vector<double>& values) {
  const double x = d.lx + d.vx, y = d.ly + d.vy, z = d.lz + d.vz;
  const double length = std::max(std::sqrt(x * x + y * y + z * z), 1e-30);
  const float in[5] = {rounded(d.lz), rounded(d.vz), rounded(x / length), rounded(y / length),
                       rounded(z / length)};
  const float* arrays[5] = {in, in + 1, in + 2, in + 3, in + 4};
  std::array<float, 3> out{-1, -1, -1};
  float* results[3] = {&out[0], &out[1], &out[2]};
  model.f32_batch_far(1, length / 2, arrays, values.data(), results);
  return out;
}

inline double albedo(const Model& model, const std::vector<double>& values, double theta_v, double lobe_width,
                     double error = 1e-5, bool isotropic = true) {
  AlbedoOptions options;
  options.lobe_width = lobe_width;
  options.error = error;
  options.isotropic = isotropic;
  return directional_albedo(
      [&](const Directions& d) {
        double rgb[3];
        model.f64(d, values.data(), rgb);
        return rgb[0];
      },
      theta_v, options);
}

}  // namespace etak::test
