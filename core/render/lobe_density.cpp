// SPDX-License-Identifier: Apache-2.0
#include "core/render/lobe_density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/math/functions.h"

namespace etak {
namespace {

using std::numbers::pi;
constexpr std::size_t node_count = 257;
constexpr double first_node = 1e-5, spread_share = 0.01;
const double growth = math::log(pi / 2 / first_node) / (node_count - 2);

// Polar angles from 0 to pi / 2, each but the first two a factor above the one before: lobes are from 1e-4 to 1 wide.
double node(std::size_t i) {
  static const auto nodes = [] {
    std::array<double, node_count> out{};
    for (std::size_t j = 1; j < node_count; ++j) out[j] = first_node * math::exp(growth * double(j - 1));
    out.back() = pi / 2;
    return out;
  }();
  return nodes[i];
}

// For each node, the light that is reflected to the viewer v by half vectors of that polar angle.
std::vector<double> reflected_by_polar_angle(const Model& model, const std::vector<double>& values,
                                             const std::array<double, 3>& v) {
  constexpr std::size_t around = 16, count = node_count * around;
  std::array<std::vector<float>, 9> rows;
  for (auto& each : rows) each.resize(count);
  std::vector<double> weight(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double theta = node(i / around), phi = 2 * pi * (double(i % around) + 0.5) / around;
    const double h[3] = {math::sin(theta) * math::cos(phi), math::sin(theta) * math::sin(phi),
                         math::cos(theta)};
    const double vh = v[0] * h[0] + v[1] * h[1] + v[2] * h[2];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      rows[axis][i] = static_cast<float>(2 * vh * h[axis] - v[axis]);
      rows[3 + axis][i] = static_cast<float>(v[axis]);
    }
    weight[i] = std::max(0.0, 2 * vh * h[2] - v[2]) * std::max(0.0, vh) * math::sin(theta);
  }
  const float* const directions[6] = {rows[0].data(), rows[1].data(), rows[2].data(),
                                      rows[3].data(), rows[4].data(), rows[5].data()};
  float* const rgb[3] = {rows[6].data(), rows[7].data(), rows[8].data()};
  model.f32_batch(count, directions, values.data(), rgb);
  std::vector<double> out(node_count);
  for (std::size_t i = 0; i < count; ++i) {
    const double all = double{rgb[0][i]} + double{rgb[1][i]} + double{rgb[2][i]};
    if (weight[i] > 0 && std::isfinite(all)) out[i / around] += weight[i] * all;
  }
  return out;
}

// The integral from one node to the next, up to `to`.
double piece(const std::vector<double>& density, std::size_t i, double to) {
  const double from = node(i), width = node(i + 1) - from, x = to - from;
  return x * (density[i] + (density[i + 1] - density[i]) * x / (2 * width));
}

double integral(const std::vector<double>& density) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < node_count; ++i) sum += piece(density, i, node(i + 1));
  return sum;
}

}  // namespace

LobeDensity::LobeDensity(const Model& model, const std::vector<double>& values) : density_(node_count) {
  for (const double nv : {0.95, 0.7, 0.45, 0.2})
    for (const bool along : {true, false}) {
      const double sine = std::sqrt(1 - nv * nv);
      const std::vector<double> seen =
          reflected_by_polar_angle(model, values, {along ? sine : 0, along ? 0 : sine, nv});
      if (const double all = integral(seen); all > 0)
        for (std::size_t i = 0; i < node_count; ++i) density_[i] += seen[i] / all;
    }
  const double lobe = integral(density_);
  for (std::size_t i = 0; i < node_count; ++i)
    density_[i] = (lobe > 0 ? (1 - spread_share) / lobe * density_[i] : 0) +
                  (lobe > 0 ? spread_share : 1) * math::sin(2 * node(i));
  sum_.push_back(0);
  for (std::size_t i = 0; i + 1 < node_count; ++i)
    sum_.push_back(sum_.back() + piece(density_, i, node(i + 1)));
  for (std::vector<double>* each : {&density_, &sum_})
    for (double& value : *each) value /= sum_.back();
}

double LobeDensity::polar(double u) const {
  const auto above = std::upper_bound(sum_.begin() + 1, sum_.end() - 1, u) - sum_.begin();
  const auto i = static_cast<std::size_t>(above - 1);
  // a + s x / 2 = rest / x, with the density a at the node before and its slope s.
  const double a = density_[i], from = node(i), slope = (density_[i + 1] - a) / (node(i + 1) - from);
  const double rest = std::max(0.0, u - sum_[i]);
  const double root = a + std::sqrt(std::max(0.0, a * a + 2 * slope * rest));
  return std::min(from + (root > 0 ? 2 * rest / root : 0), node(i + 1));
}

double LobeDensity::pdf(double polar) const {
  const double at = polar < first_node ? 0 : 1 + math::log(polar / first_node) / growth;
  const auto i = std::min(static_cast<std::size_t>(at), node_count - 2);
  const double from = node(i), share = std::clamp((polar - from) / (node(i + 1) - from), 0.0, 1.0);
  // Both the density over the angle and the ring of directions vanish at the normal.
  if (i == 0) return density_[1] / (2 * pi * node(1));
  return (density_[i] + (density_[i + 1] - density_[i]) * share) / (2 * pi * math::sin(polar));
}

std::vector<double> without_body(const Model& model, std::vector<double> values) {
  std::size_t at = 0;
  for (const Parameter& parameter : model.parameters) {
    const std::size_t count = parameter.color ? 3 : 1;
    if (parameter.role == Role::diffuse)
      std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(at), count, 0);
    at += count;
  }
  return values;
}

}  // namespace etak
