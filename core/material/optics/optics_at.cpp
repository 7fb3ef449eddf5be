// SPDX-License-Identifier: Apache-2.0
#include "core/material/optics/optics_at.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/material/dispersion.h"

namespace etak {
namespace {

void check_range(std::span<const double> at_nm, double first_nm, double last_nm, std::string_view what,
                 bool extrapolate) {
  for (const double nm : at_nm) {
    if (!std::isfinite(nm) || nm <= 0)
      throw Error::at(what, "wavelength " + number(nm, 9) + " nm", "a positive number");
    if (!extrapolate && (nm < first_nm || nm > last_nm))
      throw Error::at(what, number(nm, 9) + " nm is outside of the data",
                      number(first_nm, 6) + "-" + number(last_nm, 6) + " nm, or " + setting("extrapolate"));
  }
}

}  // namespace

std::vector<double> values_at(const Spectrum& table, std::span<const double> at_nm, std::string_view what,
                              const ReadOptions& options) {
  check_range(at_nm, table.first_nm(), table.last_nm(), what, options.extrapolate);
  std::vector<double> out(at_nm.size());
  if (std::is_sorted(at_nm.begin(), at_nm.end())) {
    resample(table, options.interpolation, at_nm, out);
    return out;
  }
  // resample() takes ascending wavelengths.
  std::vector<std::size_t> order(at_nm.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return at_nm[a] < at_nm[b]; });
  std::vector<double> ascending, values(at_nm.size());
  ascending.reserve(at_nm.size());
  for (const std::size_t i : order) ascending.push_back(at_nm[i]);
  resample(table, options.interpolation, ascending, values);
  for (std::size_t i = 0; i < order.size(); ++i) out[order[i]] = values[i];
  return out;
}

std::vector<double> n_at(const OpticalConstants& optics, std::span<const double> at_nm, std::string_view what,
                         const ReadOptions& options) {
  const auto* formula = std::get_if<DispersionFormula>(&optics.n);
  if (formula == nullptr) return values_at(std::get<Spectrum>(optics.n), at_nm, what, options);
  check_range(at_nm, formula->first_nm, formula->last_nm, what, options.extrapolate);
  std::vector<double> out(at_nm.size());
  evaluate(*formula, at_nm, out);
  for (std::size_t i = 0; i < out.size(); ++i)
    if (!std::isfinite(out[i]))
      throw Error::at(what, "the formula has no n at " + number(at_nm[i], 9) + " nm", "another wavelength");
  return out;
}

std::vector<double> k_at(const OpticalConstants& optics, std::span<const double> at_nm, std::string_view what,
                         const ReadOptions& options) {
  if (!optics.k) throw Error::at(what, "no k is given", "a dataset with k");
  return values_at(*optics.k, at_nm, what, options);
}

}  // namespace etak
