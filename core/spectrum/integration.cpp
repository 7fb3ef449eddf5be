// SPDX-License-Identifier: Apache-2.0
// Based on:
//   CIE 015:2018, "Colorimetry": tristimulus values as sums at 1 nm
//   ASTM E2022, "Standard Practice for Calculation of Weighting Factors for Tristimulus Integration"
//   Hoffman, "Physically Based Shading"; Schueler 2009, table 2.5.1: the three-sample readings
#include "core/spectrum/integration.h"

#include <algorithm>
#include <cmath>

namespace etak {
namespace {

constexpr std::array<std::string_view, 10> method_names{
    "1nm", "exact", "5nm", "10nm", "20nm", "e308-10nm", "e308-20nm", "point-650-550-450", "point-643-562-396",
    "auto"};

// Illuminant x observer at grid point i.
std::array<double, 3> weight_at(Viewing viewing, std::size_t i) {
  const double power = relative_power(viewing.illuminant)[i];
  const auto& cmf = matching_functions(viewing.observer)[i];
  return {power * cmf[0], power * cmf[1], power * cmf[2]};
}

Quadrature empty_quadrature(std::size_t samples) {
  Quadrature q;
  q.wavelength_nm.reserve(samples);
  for (auto& w : q.weight) w.reserve(samples);
  return q;
}

void add(Quadrature& q, double nm, const std::array<double, 3>& weight) {
  q.wavelength_nm.push_back(nm);
  for (std::size_t c = 0; c < 3; ++c) q.weight[c].push_back(weight[c]);
}

// Scales all weights so that R = 1 gives Y = 1.
void normalise(Quadrature& q) {
  const double scale = 1 / q.white()[1];
  for (auto& weights : q.weight)
    for (double& w : weights) w *= scale;
}

Quadrature sampled(Viewing viewing, std::size_t step) {
  Quadrature q = empty_quadrature(grid_size / step + 1);
  for (std::size_t i = 0; i < grid_size; i += step)
    add(q, grid_first_nm + static_cast<double>(i), weight_at(viewing, i));
  normalise(q);
  return q;
}

// Every 1 nm weight is shared out to the samples from which Lagrange's polynomial would interpolate the
// reflectance there: four neighbours inside, three in the first and last interval, the last sample alone
// beyond it.
Quadrature folded(Viewing viewing, std::size_t step) {
  const std::size_t count = (grid_size - 1) / step + 1;
  Quadrature q = empty_quadrature(count);
  for (std::size_t i = 0; i < count; ++i) add(q, grid_first_nm + static_cast<double>(i * step), {});
  for (std::size_t i = 0; i < grid_size; ++i) {
    const auto weight = weight_at(viewing, i);
    const std::size_t interval = i / step;
    std::size_t first = interval, points = 1;
    if (interval + 1 < count) {
      first = interval == 0 ? 0 : interval - 1;
      points = std::min<std::size_t>(count, interval + 3) - first;
    } else {
      first = count - 1;
    }
    const double x = static_cast<double>(i) / static_cast<double>(step);
    for (std::size_t j = first; j < first + points; ++j) {
      double lagrange = 1;
      for (std::size_t m = first; m < first + points; ++m)
        if (m != j)
          lagrange *= (x - static_cast<double>(m)) / (static_cast<double>(j) - static_cast<double>(m));
      for (std::size_t c = 0; c < 3; ++c) q.weight[c][j] += lagrange * weight[c];
    }
  }
  normalise(q);
  return q;
}

// R at three wavelengths, red first.
Quadrature three_samples(double red, double green, double blue) {
  Quadrature q = empty_quadrature(3);
  add(q, blue, {0, 0, 1});
  add(q, green, {0, 1, 0});
  add(q, red, {1, 0, 0});
  return q;
}

// Nodes and weights of the five-point Gauss-Legendre rule on [-1, 1]; exact for polynomials up to degree 9.
constexpr std::array<double, 5> gauss_node{-0.90617984593866399, -0.53846931010568309, 0.0,
                                           0.53846931010568309, 0.90617984593866399};
constexpr std::array<double, 5> gauss_weight{0.23692688505618909, 0.47862867049936647, 0.56888888888888889,
                                             0.47862867049936647, 0.23692688505618909};

}  // namespace

std::string_view name(Method method) {
  return method_names[static_cast<std::size_t>(method)];
}

std::optional<Method> method_named(std::string_view text) {
  for (const Method m : all_methods)
    if (text == name(m)) return m;
  if (text == name(Method::automatic)) return Method::automatic;
  return std::nullopt;
}

bool samples_rgb(Method method) {
  return method == Method::legacy_point || method == Method::legacy_schueler;
}

int step_nm(Method method) {
  switch (method) {
    case Method::nm1:
      return 1;
    case Method::nm5:
      return 5;
    case Method::nm10:
    case Method::e308_10:
      return 10;
    case Method::nm20:
    case Method::e308_20:
      return 20;
    default:
      return 0;
  }
}

std::array<double, 3> Quadrature::integrate(std::span<const double> reflectance) const {
  const std::size_t n = wavelength_nm.size(), whole = n / 4 * 4;
  std::array<double, 3> out{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double* w = weight[c].data();
    std::array<double, 4> part{};
    for (std::size_t i = 0; i < whole; i += 4)
      for (std::size_t lane = 0; lane < 4; ++lane) part[lane] += w[i + lane] * reflectance[i + lane];
    for (std::size_t i = whole; i < n; ++i) part[i - whole] += w[i] * reflectance[i];
    out[c] = (part[0] + part[1]) + (part[2] + part[3]);
  }
  return out;
}

std::array<double, 3> Quadrature::white() const {
  const std::vector<double> ones(wavelength_nm.size(), 1.0);
  return integrate(ones);
}

Quadrature make_quadrature(Method method, Viewing viewing) {
  switch (method) {
    case Method::nm5:
      return sampled(viewing, 5);
    case Method::nm10:
      return sampled(viewing, 10);
    case Method::nm20:
      return sampled(viewing, 20);
    case Method::e308_10:
      return folded(viewing, 10);
    case Method::e308_20:
      return folded(viewing, 20);
    case Method::legacy_point:
      return three_samples(650, 550, 450);
    case Method::legacy_schueler:
      return three_samples(643, 562, 396);
    case Method::exact:
    case Method::automatic:
      return make_exact_quadrature(viewing, {});
    case Method::nm1:
      break;
  }
  return sampled(viewing, 1);
}

Quadrature make_exact_quadrature(Viewing viewing, std::span<const double> knots_nm) {
  std::vector<double> knots(grid_size);
  for (std::size_t i = 0; i < grid_size; ++i) knots[i] = grid_first_nm + static_cast<double>(i);
  const auto inside = [](double nm) { return nm > grid_first_nm && nm < grid_last_nm; };
  std::copy_if(knots_nm.begin(), knots_nm.end(), std::back_inserter(knots), inside);
  std::sort(knots.begin(), knots.end());
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());

  Quadrature q = empty_quadrature((knots.size() - 1) * gauss_node.size());
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double middle = (knots[i] + knots[i + 1]) / 2, half = (knots[i + 1] - knots[i]) / 2;
    const auto cell = std::min(static_cast<std::size_t>(knots[i] - grid_first_nm), grid_size - 2);
    const auto& cmf0 = matching_functions(viewing.observer)[cell];
    const auto& cmf1 = matching_functions(viewing.observer)[cell + 1];
    const double power0 = relative_power(viewing.illuminant)[cell];
    const double power1 = relative_power(viewing.illuminant)[cell + 1];
    for (std::size_t g = 0; g < gauss_node.size(); ++g) {
      const double nm = middle + half * gauss_node[g];
      const double t = nm - grid_first_nm - static_cast<double>(cell);
      const double power = half * gauss_weight[g] * (power0 + t * (power1 - power0));
      std::array<double, 3> weight;
      for (std::size_t c = 0; c < 3; ++c) weight[c] = power * (cmf0[c] + t * (cmf1[c] - cmf0[c]));
      add(q, nm, weight);
    }
  }
  normalise(q);
  return q;
}

double exact_method_error(const Quadrature& exact, std::span<const double> reflectance) {
  // The rule of degree 3 on the outer and the middle node.
  const double outer = 1 / (3 * gauss_node[4] * gauss_node[4]);
  const std::array<double, 5> three{outer, 0, 2 - 2 * outer, 0, outer};
  double worst = 0;
  for (const auto& weight : exact.weight) {
    double sum = 0;
    for (std::size_t i = 0; i < weight.size(); i += gauss_node.size()) {
      double change = 0;
      for (std::size_t g = 0; g < gauss_node.size(); ++g)
        change += (three[g] / gauss_weight[g] - 1) * weight[i + g] * reflectance[i + g];
      sum += std::abs(change);
    }
    worst = std::max(worst, sum);
  }
  return worst;
}

std::array<double, 3> weight_inside(Viewing viewing, double first_nm, double last_nm) {
  std::array<double, 3> inside{}, all{};
  for (std::size_t i = 0; i < grid_size; ++i) {
    const double nm = grid_first_nm + static_cast<double>(i);
    const auto weight = weight_at(viewing, i);
    for (std::size_t c = 0; c < 3; ++c) {
      all[c] += weight[c];
      if (nm >= first_nm - 0.5 && nm <= last_nm + 0.5) inside[c] += weight[c];
    }
  }
  for (std::size_t c = 0; c < 3; ++c) inside[c] /= all[c];
  return inside;
}

}  // namespace etak
