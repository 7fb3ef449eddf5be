// SPDX-License-Identifier: Apache-2.0
// Based on:
//   Fritsch and Carlson 1980, "Monotone Piecewise Cubic Interpolation", SIAM J. Numer. Anal. 17(2)
//   Fritsch and Butland 1984, "A Method for Constructing Local Monotone Piecewise Cubic Interpolants",
//     SIAM J. Sci. Stat. Comput. 5(2)
#include "core/spectrum/interpolate.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace etak {
namespace {

// Slope at an end from the nearest two intervals; kept on the sign of the nearest one and within three times
// it.
double end_slope(double h0, double h1, double d0, double d1) {
  const double slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0) return 0;
  if (d0 * d1 <= 0 && std::abs(slope) > 3 * std::abs(d0)) return 3 * d0;
  return slope;
}

std::vector<double> pchip_slopes(const Spectrum& s) {
  const std::size_t n = s.size();
  std::vector<double> slope(n, 0.0);
  if (n < 2) return slope;
  const auto step = [&](std::size_t i) { return s.wavelength_nm[i + 1] - s.wavelength_nm[i]; };
  const auto secant = [&](std::size_t i) { return (s.value[i + 1] - s.value[i]) / step(i); };
  if (n == 2) {
    slope[0] = slope[1] = secant(0);
    return slope;
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double d0 = secant(i - 1), d1 = secant(i);
    if (d0 * d1 <= 0) continue;
    const double w0 = 2 * step(i) + step(i - 1), w1 = step(i) + 2 * step(i - 1);
    slope[i] = (w0 + w1) / (w0 / d0 + w1 / d1);
  }
  slope[0] = end_slope(step(0), step(1), secant(0), secant(1));
  slope[n - 1] = end_slope(step(n - 2), step(n - 3), secant(n - 2), secant(n - 3));
  return slope;
}

// Walks both ascending lists once; between(j, w) gives the value at w in the interval that starts at sample
// j.
template <class Between>
void merge(const Spectrum& s, std::span<const double> at_nm, std::span<double> out, Between between) {
  const auto& w = s.wavelength_nm;
  std::size_t j = 0;
  for (std::size_t i = 0; i < at_nm.size(); ++i) {
    const double x = at_nm[i];
    if (x <= w.front())
      out[i] = s.value.front();
    else if (x >= w.back())
      out[i] = s.value.back();
    else {
      while (w[j + 1] <= x) ++j;
      out[i] = between(j, x);
    }
  }
}

double on_line(const Spectrum& s, std::size_t j, double x) {
  const double t = (x - s.wavelength_nm[j]) / (s.wavelength_nm[j + 1] - s.wavelength_nm[j]);
  return s.value[j] + t * (s.value[j + 1] - s.value[j]);
}

}  // namespace

std::string_view name(Interpolation interpolation) {
  return interpolation == Interpolation::linear ? "linear" : "pchip";
}

std::optional<Interpolation> interpolation_named(std::string_view text) {
  if (text == "linear") return Interpolation::linear;
  if (text == "pchip") return Interpolation::pchip;
  return std::nullopt;
}

void resample(const Spectrum& spectrum, Interpolation interpolation, std::span<const double> at_nm,
              std::span<double> out) {
  if (interpolation == Interpolation::linear) {
    merge(spectrum, at_nm, out, [&](std::size_t j, double x) { return on_line(spectrum, j, x); });
    return;
  }
  const std::vector<double> slope = pchip_slopes(spectrum);
  merge(spectrum, at_nm, out, [&](std::size_t j, double x) {
    const double h = spectrum.wavelength_nm[j + 1] - spectrum.wavelength_nm[j];
    const double t = (x - spectrum.wavelength_nm[j]) / h, u = 1 - t;
    return spectrum.value[j] * u * u * (1 + 2 * t) + spectrum.value[j + 1] * t * t * (1 + 2 * u) +
           h * t * u * (slope[j] * u - slope[j + 1] * t);
  });
}

void resample_to_grid(const Spectrum& s, std::span<double, grid_size> out) {
  const auto& w = s.wavelength_nm;
  // Grid points below the table, then interval by interval, then above it: no search and no test per point.
  const auto clamped = [](double nm) {
    return static_cast<std::size_t>(std::clamp(std::ceil(nm) - grid_first_nm, 0.0, double{grid_size}));
  };
  std::size_t i = clamped(w.front());
  std::fill_n(out.begin(), i, s.value.front());
  for (auto j =
           static_cast<std::size_t>(std::upper_bound(w.begin(), w.end(), double{grid_first_nm}) - w.begin());
       j < w.size() && i < grid_size; ++j) {
    if (j == 0) continue;
    const std::size_t end = std::min(grid_size, clamped(w[j]));
    const double span = w[j] - w[j - 1], rise = s.value[j] - s.value[j - 1];
    for (; i < end; ++i) {
      const double t = (static_cast<double>(grid_first_nm + static_cast<int>(i)) - w[j - 1]) / span;
      out[i] = s.value[j - 1] + t * rise;
    }
  }
  std::fill(out.begin() + static_cast<std::ptrdiff_t>(i), out.end(), s.value.back());
}

}  // namespace etak
