// SPDX-License-Identifier: Apache-2.0
#include "core/material/f0/f0_data.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/spectrum/refinement.h"

namespace etak {
namespace {

void count_samples(const Spectrum& table, Coverage& coverage) {
  const auto& w = table.wavelength_nm;
  const auto first = std::lower_bound(w.begin(), w.end(), core_first_nm) - w.begin();
  for (auto i = static_cast<std::size_t>(first); i < w.size(); ++i) {
    if (w[i] <= core_last_nm) ++coverage.samples_400_700;
    if (i == 0 || w[i] == core_first_nm) continue;
    if (w[i - 1] >= core_last_nm) break;
    const double gap = std::min(w[i], core_last_nm) - std::max(w[i - 1], core_first_nm);
    coverage.largest_gap_nm = std::max(coverage.largest_gap_nm, gap);
  }
}

// Adds wavelengths to knots; both are ascending.
void merge(std::span<const double> more, std::vector<double>& knots) {
  const auto middle = knots.insert(knots.end(), more.begin(), more.end());
  std::inplace_merge(knots.begin(), middle, knots.end());
}

}  // namespace

double Coverage::least() const {
  return std::min({weight[0], weight[1], weight[2]});
}

Range range_of(const OpticalConstants& optics) {
  if (const auto* formula = std::get_if<DispersionFormula>(&optics.n))
    return {formula->first_nm, formula->last_nm};
  const auto& table = std::get<Spectrum>(optics.n);
  return {table.first_nm(), table.last_nm()};
}

WeightSums weight_sums(Viewing viewing) {
  const Quadrature q = make_quadrature(Method::nm1, viewing);
  WeightSums sums{};
  for (std::size_t i = 0; i < grid_size; ++i)
    for (std::size_t c = 0; c < 3; ++c) sums[i + 1][c] = sums[i][c] + q.weight[c][i];
  return sums;
}

Coverage coverage_of(Range range, const Spectrum* table, const WeightSums& sums) {
  Coverage coverage;
  coverage.first_nm = range.first_nm;
  coverage.last_nm = range.last_nm;
  coverage.is_formula = table == nullptr;
  const auto index = [](double offset) {
    return static_cast<std::size_t>(std::clamp(offset, 0.0, double{grid_size}));
  };
  const std::size_t first = index(std::ceil(range.first_nm - 0.5 - grid_first_nm));
  const std::size_t last = std::max(first, index(std::floor(range.last_nm + 0.5 - grid_first_nm) + 1));
  for (std::size_t c = 0; c < 3; ++c)
    coverage.weight[c] = (sums[last][c] - sums[first][c]) / sums[grid_size][c];
  if (table) count_samples(*table, coverage);
  return coverage;
}

bool is_sparse(const Coverage& coverage) {
  constexpr std::size_t least_samples = 10;
  return !coverage.is_formula && coverage.samples_400_700 < least_samples;
}

bool is_sparse(const Optics& optics) {
  if (const auto* stack = std::get_if<Stack>(&optics))
    return std::any_of(stack->media.begin(), stack->media.end(),
                       [](const StackMedium& medium) { return is_sparse(medium.constants); });
  const auto* reflectance = std::get_if<Reflectance>(&optics);
  const Spectrum* table =
      reflectance ? &reflectance->spectrum : std::get_if<Spectrum>(&std::get<OpticalConstants>(optics).n);
  Coverage coverage;
  coverage.is_formula = table == nullptr;
  if (table) count_samples(*table, coverage);
  return is_sparse(coverage);
}

void intersect(Coverage& a, const Coverage& b) {
  for (std::size_t c = 0; c < 3; ++c) a.weight[c] = std::min(a.weight[c], b.weight[c]);
  a.first_nm = std::max(a.first_nm, b.first_nm);
  a.last_nm = std::min(a.last_nm, b.last_nm);
  a.largest_gap_nm = std::max(a.largest_gap_nm, b.largest_gap_nm);
  a.samples_400_700 = a.is_formula   ? b.samples_400_700
                      : b.is_formula ? a.samples_400_700
                                     : std::min(a.samples_400_700, b.samples_400_700);
  a.is_formula = a.is_formula && b.is_formula;
}

void append_knots(const OpticalConstants& constants, std::vector<double>& knots) {
  const Spectrum* n = nullptr;
  if (const auto* formula = std::get_if<DispersionFormula>(&constants.n)) {
    merge(std::array{formula->first_nm, formula->last_nm}, knots);
  } else {
    n = &std::get<Spectrum>(constants.n);
    merge(n->wavelength_nm, knots);
  }
  if (constants.k && !(n != nullptr && n->wavelength_nm == constants.k->wavelength_nm))
    merge(constants.k->wavelength_nm, knots);
}

void append_knots(const Optics& optics, std::vector<double>& knots) {
  if (const auto* reflectance = std::get_if<Reflectance>(&optics))
    return merge(reflectance->spectrum.wavelength_nm, knots);
  if (const auto* constants = std::get_if<OpticalConstants>(&optics)) return append_knots(*constants, knots);
  for (const StackMedium& medium : std::get<Stack>(optics).media) append_knots(medium.constants, knots);
  // Between the knots of its media a stack is far from linear in the wavelength.
  std::array<double, grid_size> grid{};
  for (std::size_t i = 0; i < grid_size; ++i) grid[i] = grid_first_nm + static_cast<double>(i);
  merge(grid, knots);
}

double finest_spacing_nm(const Optics& optics) {
  if (const auto* stack = std::get_if<Stack>(&optics)) {
    double least = std::numeric_limits<double>::infinity();
    for (const StackMedium& medium : stack->media)
      least = std::min(least, finest_spacing_nm(medium.constants));
    return least;
  }
  if (const auto* reflectance = std::get_if<Reflectance>(&optics))
    return etak::finest_spacing_nm(reflectance->spectrum.wavelength_nm);
  const auto& constants = std::get<OpticalConstants>(optics);
  double least = std::numeric_limits<double>::infinity();
  if (const auto* n = std::get_if<Spectrum>(&constants.n)) least = etak::finest_spacing_nm(n->wavelength_nm);
  if (constants.k) least = std::min(least, etak::finest_spacing_nm(constants.k->wavelength_nm));
  return least;
}

}  // namespace etak
