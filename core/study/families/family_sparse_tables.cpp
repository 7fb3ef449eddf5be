// SPDX-License-Identifier: Apache-2.0
// Family j: the errors of tables with few rows, for several ways to interpolate between them.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number.h"
#include "core/fresnel/fresnel.h"
#include "core/material/f0.h"
#include "core/material/library.h"
#include "core/study/families/families.h"
#include "core/study/measure.h"

namespace etak {
namespace {

// n and k in one table.
struct NkTable {
  std::string name;
  std::vector<double> nm, n, k;
};

// All tables of n and k of the library that have `least` to `most` rows in 400..700 nm.
std::vector<NkTable> pages_with(std::size_t least, std::size_t most) {
  std::vector<NkTable> out;
  const auto library = MaterialLibrary::builtin();
  const F0Solver solver({});
  for (std::size_t i = 0; i < library.ids().size(); ++i)
    for (const Material material = library.at(i); const Dataset& dataset : material.datasets) {
      const auto* constants = std::get_if<OpticalConstants>(&dataset.optics);
      const auto* n = constants ? std::get_if<Spectrum>(&constants->n) : nullptr;
      if (n == nullptr || (constants->k && constants->k->wavelength_nm != n->wavelength_nm)) continue;
      const F0Result result = solver.solve(dataset.optics);
      if (result.refused() || result.coverage.samples_400_700 < least ||
          result.coverage.samples_400_700 > most)
        continue;
      out.push_back({material.id + "/" + dataset.id, n->wavelength_nm, n->value,
                     constants->k ? constants->k->value : std::vector<double>(n->size(), 0.0)});
    }
  return out;
}

// The rows nearest to `points` wavelengths that lie evenly over the visible range, its ends included.
NkTable decimated(const NkTable& page, std::size_t points) {
  const double first = std::max(page.nm.front(), visible_first_nm),
               last = std::min(page.nm.back(), visible_last_nm);
  NkTable out{page.name, {}, {}, {}};
  for (std::size_t i = 0; i < points; ++i) {
    const double wanted = first + (last - first) * static_cast<double>(i) / static_cast<double>(points - 1);
    auto at =
        static_cast<std::size_t>(std::lower_bound(page.nm.begin(), page.nm.end(), wanted) - page.nm.begin());
    if (at == page.nm.size() || (at > 0 && wanted - page.nm[at - 1] < page.nm[at] - wanted)) --at;
    if (!out.nm.empty() && page.nm[at] <= out.nm.back()) continue;
    out.nm.push_back(page.nm[at]);
    out.n.push_back(page.n[at]);
    out.k.push_back(page.k[at]);
  }
  return out;
}

Optics constants_of(const NkTable& page) {
  OpticalConstants out;
  out.n = Spectrum{page.nm, page.n};
  out.k = Spectrum{page.nm, page.k};
  return out;
}

Optics reflectance_of(const NkTable& page) {
  Spectrum out{page.nm, std::vector<double>(page.nm.size())};
  f64::f0(page.n, page.k, out.value);
  return Reflectance{std::move(out)};
}

struct Way {
  const char* id;
  const char* title;
  Interpolation interpolation;
  Optics (*optics)(const NkTable&);
};
constexpr std::array ways{Way{"linear_nk", "n and k, linear", Interpolation::linear, constants_of},
                          Way{"pchip_nk", "n and k, pchip", Interpolation::pchip, constants_of},
                          Way{"linear_r", "R, linear", Interpolation::linear, reflectance_of},
                          Way{"pchip_r", "R, pchip", Interpolation::pchip, reflectance_of}};

F0Solver solver_of(const Way& way) {
  F0Options options;
  options.interpolation = way.interpolation;
  options.allow_extrapolation = true;  // a decimated table may end a few nanometres earlier
  return F0Solver(options);
}

// The errors of every way over `tables`, against the results `truth` of the same index.
ErrorTimeTable table_of(std::string id, std::string title, std::span<const NkTable> tables,
                        std::span<const F0Result> truth, std::vector<TimedSet>& timings) {
  ErrorTimeTable table;
  table.id = std::move(id);
  table.title = std::move(title);
  table.time_unit = "ns per spectrum";
  table.base = ways[0].id;
  table.metrics = {{"max_df0", "largest error of F0", ""},
                   {"mean_df0", "mean error of F0", ""},
                   {"codes_changed", "pages with another 8-bit code", ""},
                   {"codes_changed_percent", "the same", "%"}};
  table.plotted = 1;
  std::vector<TimedCase> cases;
  const auto count = static_cast<double>(tables.size());
  for (const Way& way : ways) {
    auto solver = std::make_shared<F0Solver>(solver_of(way));
    auto inputs = std::make_shared<std::vector<Optics>>();
    ErrorTimeRow row;
    row.id = way.id;
    row.title = way.title;
    row.errors = {0, 0, 0, 0};
    for (std::size_t i = 0; i < tables.size(); ++i) {
      const F0Result got = solver->solve(inputs->emplace_back(way.optics(tables[i])));
      const Vec3 a = vec(got.srgb_linear), b = vec(truth[i].srgb_linear);
      double error = 0;
      for (std::size_t c = 0; c < 3; ++c) error = std::max(error, std::abs(a[c] - b[c]));
      if (error > row.errors[0]) row.note = "worst: " + tables[i].name;
      row.errors[0] = std::max(row.errors[0], error);
      row.errors[1] += error / count;
      row.errors[2] += got.srgb8 != truth[i].srgb8;
    }
    row.errors[3] = 100 * row.errors[2] / count;
    table.rows.push_back(row);
    cases.push_back({way.id, tables.size(), [solver, inputs] {
                       double sum = 0;
                       for (const Optics& optics : *inputs) sum += solver->solve(optics).luminance;
                       keep(&sum);
                     }});
  }
  timings.push_back({{table.id}, std::move(cases)});
  return table;
}

std::vector<F0Result> truth_of(std::span<const NkTable> pages) {
  const F0Solver reference = solver_of(ways[0]);
  std::vector<F0Result> out;
  for (const NkTable& page : pages) out.push_back(reference.solve(constants_of(page)));
  return out;
}

constexpr std::size_t dense_rows = 100;
constexpr std::array<std::size_t, 4> kept{5, 10, 20, 40};

}  // namespace

ErrorTimeFamily sparse_table_family(const ReportOptions&) {
  const std::vector<NkTable> dense = pages_with(dense_rows, 1000000);
  ErrorTimeFamily family;
  family.id = "sparse-tables";
  family.letter = "j";
  family.title = "Tables with few rows";
  family.reference = "the same table with all its rows, n and k linear in wavelength, sum at 1 nm";
  family.grid = std::to_string(dense.size()) + " tables of the library with at least " +
                std::to_string(dense_rows) + " rows in 400-700 nm, thinned evenly over 380-780 nm";
  const auto truth = truth_of(dense);
  for (const std::size_t points : kept) {
    std::vector<NkTable> thin;
    for (const NkTable& page : dense) thin.push_back(decimated(page, points));
    family.tables.push_back(table_of("points_" + std::to_string(points),
                                     std::to_string(points) + " rows kept", thin, truth, family.timed));
  }
  // Johnson and Christy's metals have about ten rows in the visible range, and there are no denser data to
  // compare them with.
  std::vector<NkTable> johnson = pages_with(1, dense_rows - 1);
  std::erase_if(johnson,
                [](const NkTable& page) { return page.name.find("/johnson-197") == std::string::npos; });
  family.tables.push_back(table_of("johnson",
                                   "Johnson and Christy's metals, drawn otherwise than by n and k linear",
                                   johnson, truth_of(johnson), family.timed));
  const auto error = [&](std::size_t table, std::size_t row) {
    return number(family.tables[table].rows[row].errors[1], 2);
  };
  family.advice = "Draw n and k by pchip where a table has 20 rows or fewer over the visible (mean error " +
                  error(1, 1) + " with 10 rows, where straight lines give " + error(1, 0) +
                  "); from 40 rows on straight lines, the reference policy, are good to " + error(3, 0) +
                  " and faster.";
  family.picks = {{"tables of 20 rows or fewer", "points_10", "pchip_nk", "curves between few rows",
                   "etak f0 FILE --interpolation pchip"}};
  family.notes = {
      "R between the rows of n and k is not much worse than n and k themselves: what counts is how many rows there are. etak interpolates n and k, because F82 and other media follow from them.",
      "Times are of the whole solve."};
  return family;
}

}  // namespace etak
