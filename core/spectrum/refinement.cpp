// SPDX-License-Identifier: Apache-2.0
#include "core/spectrum/refinement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace etak {
namespace {

constexpr std::array<Method, 4> ladder{Method::nm20, Method::nm10, Method::nm5, Method::nm1};
// Between two places a spectrum bends more than the places show. Over all published data, with n and k by
// pchip, the real error is up to 1.74 times the one that the places give.
constexpr double safety = 2;
constexpr double place_first_nm = grid_first_nm + 2.5, place_step_nm = 5;

}  // namespace

Refinement::Refinement(Viewing viewing) : exact_(grid_size) {
  const auto cmf = matching_functions(viewing.observer);
  const auto power = relative_power(viewing.illuminant);
  for (std::size_t i = grid_size - 1; i-- > 0;)
    for (std::size_t c = 0; c < 3; ++c) {
      const double dp = power[i + 1] - power[i], dc = cmf[i + 1][c] - cmf[i][c];
      const double w0 = power[i] * cmf[i][c], w1 = power[i] * dc + cmf[i][c] * dp, w2 = dp * dc;
      const double next = exact_[i + 1].weight[c];
      exact_[i].weight[c] = next + w0 + w1 / 2 + w2 / 3;
      exact_[i].moment[c] = exact_[i + 1].moment[c] + next + w0 / 2 + w1 / 3 + w2 / 4;
      exact_[i].bend[c] = {w0 / 2, w1 / 6, w2 / 12};
    }
  const double scale = 1 / exact_[0].weight[1];
  for (Above& above : exact_)
    for (std::size_t c = 0; c < 3; ++c) {
      above.weight[c] *= scale;
      above.moment[c] *= scale;
      for (double& bend : above.bend[c]) bend *= scale;
    }
  for (const Method method : ladder) {
    Quadrature rule = make_quadrature(method, viewing);
    const auto white = rule.white();
    for (std::size_t c = 0; c < 3; ++c)
      for (double& w : rule.weight[c]) w *= exact_[0].weight[c] / white[c];
    const std::size_t count = rule.wavelength_nm.size();
    std::vector<Above> sums(count);
    for (std::size_t i = count - 1; i-- > 0;) {
      const double gap = rule.wavelength_nm[i + 1] - rule.wavelength_nm[i];
      for (std::size_t c = 0; c < 3; ++c) {
        sums[i].weight[c] = sums[i + 1].weight[c] + rule.weight[c][i + 1];
        sums[i].moment[c] = sums[i + 1].moment[c] + gap * sums[i].weight[c];
      }
    }
    steps_.push_back({method, std::move(rule)});
    sums_.push_back(std::move(sums));
  }
}

// Within the nanometre that holds the hinge the weights are not constant: `bend` has their moments.
std::array<double, 3> Refinement::exact_hinge(double nm) const {
  const auto cell = std::min(static_cast<std::size_t>(nm - grid_first_nm), grid_size - 2);
  const double t = nm - grid_first_nm - static_cast<double>(cell);
  const Above& above = exact_[cell];
  std::array<double, 3> out;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& bend = above.bend[c];
    out[c] = above.moment[c] + t * (t * (bend[0] + t * (bend[1] + t * bend[2])) - above.weight[c]);
  }
  return out;
}

std::array<double, 3> Refinement::summed_hinge(std::size_t step, double nm) const {
  const auto& at = steps_[step].rule.wavelength_nm;
  const auto below = static_cast<std::size_t>((nm - at[0]) / (at[1] - at[0]));
  std::array<double, 3> out{};
  if (below + 1 >= at.size()) return out;
  const Above& above = sums_[step][below];
  // The moment about the hinge, from the moment about the point below it.
  for (std::size_t c = 0; c < 3; ++c) out[c] = above.moment[c] - (nm - at[below]) * above.weight[c];
  return out;
}

std::vector<double> Refinement::places(std::span<const double> knots_nm) {
  std::vector<double> own{grid_first_nm};
  for (double nm = place_first_nm; nm < grid_last_nm; nm += place_step_nm) own.push_back(nm);
  own.push_back(grid_last_nm);
  const auto first = std::upper_bound(knots_nm.begin(), knots_nm.end(), double{grid_first_nm});
  const auto last = std::lower_bound(first, knots_nm.end(), double{grid_last_nm});
  std::vector<double> out(own.size() + static_cast<std::size_t>(last - first));
  std::merge(own.begin(), own.end(), first, last, out.begin());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::vector<double> Refinement::estimate(std::span<const double> places_nm,
                                         std::span<const double> reflectance) const {
  std::vector<std::array<double, 3>> sums(steps_.size());
  double slope = 0;
  for (std::size_t i = 0; i + 1 < places_nm.size(); ++i) {
    const double next = (reflectance[i + 1] - reflectance[i]) / (places_nm[i + 1] - places_nm[i]);
    const double bend = std::abs(next - slope);
    slope = next;
    if (bend == 0) continue;
    const auto exact = exact_hinge(places_nm[i]);
    for (std::size_t s = 0; s < steps_.size(); ++s) {
      const auto summed = summed_hinge(s, places_nm[i]);
      for (std::size_t c = 0; c < 3; ++c) sums[s][c] += bend * std::abs(summed[c] - exact[c]);
    }
  }
  std::vector<double> out;
  for (const auto& xyz : sums) out.push_back(safety * std::max({xyz[0], xyz[1], xyz[2]}));
  return out;
}

double finest_spacing_nm(std::span<const double> knots_nm) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < knots_nm.size(); ++i)
    if (knots_nm[i] > grid_first_nm && knots_nm[i - 1] < grid_last_nm)
      least = std::min(least, knots_nm[i] - knots_nm[i - 1]);
  return least;
}

}  // namespace etak
