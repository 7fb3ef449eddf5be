// SPDX-License-Identifier: Apache-2.0
// Family a: the integral from a spectrum to F0, by every method.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/number.h"
#include "core/color/delta_e.h"
#include "core/exchange/rii/rii_page.h"
#include "core/material/f0.h"
#include "core/material/library.h"
#include "core/study/families/families.h"
#include "core/study/measure.h"

namespace etak {
namespace {

struct Sample {
  std::string name;
  Optics optics;
};

// Every table and formula of the library that gives F0; the stacks made of them are refused as they are filed.
std::vector<Sample> usable_samples() {
  std::vector<Sample> out;
  const auto library = MaterialLibrary::builtin();
  const F0Solver solver({});
  for (std::size_t i = 0; i < library.ids().size(); ++i)
    for (const Material material = library.as_filed(i); const Dataset& dataset : material.datasets)
      if (!solver.solve(dataset.optics).refused())
        out.push_back({material.id + "/" + dataset.id, dataset.optics});
  return out;
}

struct Way {
  std::string id, title;
  F0Options options;
};

// The name of a method as people write it: "10 nm" for "10nm".
std::string title_of(Method method) {
  std::string text(name(method));
  if (text.starts_with("point-")) {
    text = "3 samples, " + text.substr(6) + " nm";
    std::replace(text.begin(), text.end(), '-', '/');
  } else if (text.starts_with("e308-")) {
    text = "E308, " + text.substr(5);
  }
  if (const auto at = text.find("nm"); at != text.npos && text[at - 1] != ' ') text.insert(at, " ");
  return text;
}

std::vector<Way> ways() {
  std::vector<Way> out;
  for (const Method method : all_methods) {
    Way way{std::string(name(method)), title_of(method), {}};
    way.options.method = method;
    out.push_back(way);
  }
  for (const double bound : {1e-3, 1e-5}) {
    Way way{"auto-" + number(bound, 1), "auto, bound " + number(bound, 1), {}};
    way.options.method = Method::automatic;
    way.options.integration_bound = bound;
    out.push_back(way);
  }
  return out;
}

double largest_difference(const F0Result& a, const F0Result& b) {
  const Vec3 x = vec(a.srgb_linear), y = vec(b.srgb_linear);
  return std::max({std::abs(x[0] - y[0]), std::abs(x[1] - y[1]), std::abs(x[2] - y[2])});
}

std::vector<F0Result> solve_all(const F0Solver& solver, std::span<const Sample> samples) {
  std::vector<F0Result> out;
  for (const Sample& sample : samples) out.push_back(solver.solve(sample.optics));
  return out;
}

// How many results each method gave: "1nm 240, exact 36".
std::string steps_taken(std::span<const F0Result> results) {
  std::map<Method, std::size_t> counts;
  for (const F0Result& result : results)
    if (result.integration) ++counts[result.integration->method];
  std::string out;
  for (const Method method : {Method::nm20, Method::nm10, Method::nm5, Method::nm1, Method::exact})
    if (counts.contains(method))
      out += (out.empty() ? "" : ", ") + std::string(name(method)) + " " + std::to_string(counts[method]);
  return out;
}

// Samples that the timed cases share.
using Samples = std::shared_ptr<const std::vector<Sample>>;

TimedCase timed(const Way& way, const Samples& all) {
  // Some of many samples are enough, and a round then takes a fraction of the time.
  constexpr std::size_t most = 100;
  auto samples = std::make_shared<std::vector<Sample>>();
  const std::size_t step = (all->size() + most - 1) / most;
  for (std::size_t i = 0; i < all->size(); i += step) samples->push_back((*all)[i]);
  return {way.id, samples->size(), [samples, solver = std::make_shared<F0Solver>(way.options)] {
            double sum = 0;
            for (const Sample& sample : *samples) sum += solver->solve(sample.optics).luminance;
            keep(&sum);
          }};
}

ErrorTimeTable library_table(std::span<const Way> all, const Samples& shared, std::span<const F0Result> truth,
                             std::vector<TimedSet>& timings) {
  const std::vector<Sample>& samples = *shared;
  ErrorTimeTable table;
  table.id = "library";
  table.title = "The whole way from n and k to a colour";
  table.time_unit = "ns per spectrum";
  table.base = all[0].id;
  table.metrics = {{"max_df0", "largest error of F0", ""},
                   {"mean_df0", "mean error of F0", ""},
                   {"codes_changed", "materials with another 8-bit code", ""},
                   {"codes_changed_percent", "the same", "%"},
                   {"max_de", "largest colour difference", "ΔE2000"}};
  std::vector<TimedCase> cases;
  for (const Way& way : all) {
    const auto results = solve_all(F0Solver(way.options), samples);
    ErrorTimeRow row;
    row.id = way.id;
    row.title = way.title;
    double most = 0, mean = 0, changed = 0, max_de = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double difference = largest_difference(truth[i], results[i]);
      mean += difference / static_cast<double>(samples.size());
      changed += truth[i].srgb8 != results[i].srgb8;
      max_de = std::max(max_de, delta_e2000(to_lab(truth[i].srgb_linear), to_lab(results[i].srgb_linear)));
      if (difference > most) row.note = "worst: " + samples[i].name;
      most = std::max(most, difference);
    }
    row.errors = {most, mean, changed, 100 * changed / static_cast<double>(samples.size()), max_de};
    if (way.options.method == Method::automatic) row.note = "took " + steps_taken(results);
    table.rows.push_back(row);
    cases.push_back(timed(way, shared));
  }
  timings.push_back({{table.id}, std::move(cases)});
  return table;
}

// ---- the same with a page to be read

void append_rows(std::string& out, std::string_view type, const Spectrum& first, const Spectrum* second) {
  out += "  - type: tabulated " + std::string(type) + "\n    data: |\n";
  for (std::size_t i = 0; i < first.size(); ++i) {
    out += "        " + number(first.wavelength_nm[i] / 1000, 7) + " " + number(first.value[i], 6);
    if (second != nullptr) out += " " + number(second->value[i], 6);
    out += '\n';
  }
}

// The data as a page of refractiveindex.info; empty for reflectances.
std::string page_of(const Optics& optics) {
  const auto* constants = std::get_if<OpticalConstants>(&optics);
  if (constants == nullptr) return {};
  std::string out = "REFERENCES: \"made from the library\"\nDATA:\n";
  const auto* n = std::get_if<Spectrum>(&constants->n);
  if (n != nullptr && constants->k && constants->k->wavelength_nm == n->wavelength_nm) {
    append_rows(out, "nk", *n, &*constants->k);
    return out;
  }
  if (n != nullptr) {
    append_rows(out, "n", *n, nullptr);
  } else {
    const auto& formula = std::get<DispersionFormula>(constants->n);
    out += "  - type: formula " + std::to_string(formula.number) +
           "\n    wavelength_range: " + number(formula.first_nm / 1000, 7) + " " +
           number(formula.last_nm / 1000, 7) + "\n    coefficients:";
    for (const double c : formula.coefficients) out += " " + number(c, 10);
    out += '\n';
  }
  if (constants->k) append_rows(out, "k", *constants->k, nullptr);
  return out;
}

// Adds the quickest sum and the 1 nm sum with the text of a database page to be read before them: rows and cases of
// the library's table, whose errors are those without the page.
void add_pages(std::span<const Way> all, std::span<const Sample> samples, ErrorTimeTable& library,
               TimedSet& timings) {
  auto pages = std::make_shared<std::vector<std::string>>();
  constexpr std::size_t step = 5;  // every fifth page is enough to be timed
  for (std::size_t i = 0; i < samples.size(); i += step)
    if (std::string page = page_of(samples[i].optics); !page.empty()) pages->push_back(std::move(page));
  for (std::size_t w = 0; w < all.size(); ++w) {
    library.rows[w].truth = "n and k";
    const Method method = all[w].options.method;
    if (method != Method::nm20 && method != Method::nm1) continue;
    ErrorTimeRow row = library.rows[w];
    row.id += "-page";
    row.title += ", from a page's text";
    row.truth = "a page's text";
    library.rows.push_back(row);
    timings.cases.push_back(
        {row.id, pages->size(),
         [pages, solver = std::make_shared<F0Solver>(all[w].options), page = RiiPage()]() mutable {
           double sum = 0;
           for (const std::string& text : *pages) {
             parse_rii_page(text, "page.yml", page);
             sum += solver->solve(page.optics, page.flags).luminance;
           }
           keep(&sum);
         }});
  }
}

// ---- stiff spectra

constexpr double stiff_middle_nm = 550.3;  // which lies on none of the grids

// A Lorentz line of reflectance, 0.1 to 0.9, with samples a twentieth of its half width apart in its middle.
Optics lorentz_line(double half_width_nm) {
  Spectrum s;
  const auto add = [&](double nm) {
    const double x = (nm - stiff_middle_nm) / half_width_nm;
    s.wavelength_nm.push_back(nm);
    s.value.push_back(0.1 + 0.8 / (1 + x * x));
  };
  // Steps that grow with the distance from the middle, as the line flattens.
  std::vector<double> offsets{0};
  for (double at = 0; at < 300;) {
    at += std::max(half_width_nm / 20, at / 20);
    offsets.push_back(at);
  }
  for (std::size_t i = offsets.size(); i-- > 1;) add(stiff_middle_nm - offsets[i]);
  for (const double offset : offsets) add(stiff_middle_nm + offset);
  return Reflectance{std::move(s)};
}

Optics step_edge() {
  return Reflectance{{{300, 550.3, 550.31, 900}, {0.1, 0.1, 0.9, 0.9}}};
}

// A reflectance of 0.9 over half a nanometre in every two, at the places where coarse sums take their
// samples.
Optics comb() {
  Spectrum s{{350}, {0.1}};
  for (double tooth = 360; tooth <= 830; tooth += 2)
    for (const auto& [offset, value] : {std::pair{-0.26, 0.1}, {-0.25, 0.9}, {0.25, 0.9}, {0.26, 0.1}}) {
      s.wavelength_nm.push_back(tooth + offset);
      s.value.push_back(value);
    }
  return Reflectance{std::move(s)};
}

std::vector<Sample> stiff_samples() {
  std::vector<Sample> out;
  for (const double width : {10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1})
    out.push_back({"line, half width " + number(width, 2) + " nm", lorentz_line(width)});
  out.push_back({"step", step_edge()});
  out.push_back({"comb", comb()});
  return out;
}

// X, Y, Z by trapezoids of 0.001 nm: independent of knots and Gauss points.
Vec3 fine_sum(const Optics& optics) {
  constexpr int parts = 1000;
  const Spectrum& spectrum = std::get<Reflectance>(optics).spectrum;
  const auto cmf = matching_functions(Observer::cie1931_2deg);
  const auto power = relative_power(Illuminant::d65);
  std::vector<double> at(parts + 1), r(parts + 1);
  Vec3 sum{};
  double white = 0;
  for (std::size_t cell = 0; cell + 1 < grid_size; ++cell) {
    for (std::size_t i = 0; i <= parts; ++i)
      at[i] = grid_first_nm + static_cast<double>(cell) + static_cast<double>(i) / parts;
    resample(spectrum, Interpolation::linear, at, r);
    for (std::size_t i = 0; i <= parts; ++i) {
      const double t = static_cast<double>(i) / parts, share = i == 0 || i == parts ? 0.5 : 1;
      const double p = share * (power[cell] + t * (power[cell + 1] - power[cell]));
      for (std::size_t c = 0; c < 3; ++c) {
        const double w = p * (cmf[cell][c] + t * (cmf[cell + 1][c] - cmf[cell][c]));
        sum[c] += w * r[i];
        if (c == 1) white += w;
      }
    }
  }
  return {sum[0] / white, sum[1] / white, sum[2] / white};
}

ErrorTimeTable stiff_table(std::span<const Way> all, const Samples& shared, std::vector<TimedSet>& timings) {
  const std::vector<Sample>& samples = *shared;
  ErrorTimeTable table;
  table.id = "stiff";
  table.title = "Spectra with features narrower than the grid";
  table.time_unit = "ns per spectrum";
  table.base = all[0].id;
  table.metrics = {{"max", "largest error of X, Y, Z", ""}};
  std::vector<Vec3> truth;
  for (const Sample& sample : samples) {
    table.metrics.push_back({"error_" + std::to_string(truth.size()), sample.name, ""});
    truth.push_back(fine_sum(sample.optics));
  }
  std::vector<TimedCase> cases;
  for (const Way& way : all) {
    const auto results = solve_all(F0Solver(way.options), samples);
    ErrorTimeRow row;
    row.id = way.id;
    row.title = way.title;
    row.errors = {0};
    std::size_t flagged = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Vec3 got = vec(results[i].xyz);
      double error = 0;
      for (std::size_t c = 0; c < 3; ++c) error = std::max(error, std::abs(got[c] - truth[i][c]));
      row.errors.push_back(error);
      row.errors[0] = std::max(row.errors[0], error);
      flagged += results[i].flags.has(Flag::finer_than_grid);
    }
    if (flagged > 0)
      row.note = std::to_string(flagged) + " of " + std::to_string(samples.size()) +
                 " flagged: data finer than the grid";
    if (way.options.method == Method::automatic) row.note = "took " + steps_taken(results);
    table.rows.push_back(row);
    cases.push_back(timed(way, shared));
  }
  timings.push_back({{table.id}, std::move(cases)});
  return table;
}

// Largest differences of the 5, 10 and 20 nm sums from the 1 nm sum.
std::string against_1nm(std::span<const Sample> samples) {
  const auto by = [&](Method method) {
    F0Options options;
    options.method = method;
    return solve_all(F0Solver(options), samples);
  };
  const auto reference = by(Method::nm1);
  std::string out;
  for (const Method method : {Method::nm5, Method::nm10, Method::nm20}) {
    const auto results = by(method);
    double most = 0;
    for (std::size_t i = 0; i < results.size(); ++i)
      most = std::max(most, largest_difference(reference[i], results[i]));
    out += (out.empty() ? "" : ", ") + std::string(name(method)) + " " + number(most, 2);
  }
  return out;
}

}  // namespace

ErrorTimeFamily quadrature_family(const ReportOptions&) {
  const std::vector<Way> all = ways();
  const auto shared = std::make_shared<const std::vector<Sample>>(usable_samples());
  const std::vector<Sample>& samples = *shared;
  F0Options exact;
  exact.method = Method::exact;
  const auto truth = solve_all(F0Solver(exact), samples);

  ErrorTimeFamily family;
  family.id = "quadrature";
  family.letter = "a";
  family.title = "Spectral quadrature";
  family.reference =
      "the exact integral over all knots of data, observer and illuminant; for stiff spectra a sum at 0.001 nm";
  family.grid = std::to_string(samples.size()) +
                " datasets of the library that give F0, n and k linear in wavelength, CIE 1931 2°, D65";
  ErrorTimeTable library = library_table(all, shared, truth, family.timed);
  add_pages(all, samples, library, family.timed.back());
  const auto row = [&](std::string_view id) -> const ErrorTimeRow& {
    return *std::find_if(library.rows.begin(), library.rows.end(),
                         [&](const ErrorTimeRow& r) { return r.id == id; });
  };
  const double moved = row("1nm").errors[2];
  family.advice =
      "Keep the 1 nm sum: its error of " + number(row("1nm").errors[0], 2) + " moves " +
      (moved == 0 ? "no 8-bit code" : "the 8-bit codes of " + number(moved, 3) + " materials") +
      " over the library, and a page takes longer to be read; where lines finer than a nanometre would get lost in it, it gives way to exact by itself.";
  const auto stiff = std::make_shared<const std::vector<Sample>>(stiff_samples());
  family.tables = {std::move(library), stiff_table(all, stiff, family.timed)};
  family.picks = {{"a colour from n and k", "library", "1nm", "no 8-bit code of the library needs more"},
                  {"data finer than a nanometre", "stiff", "exact", "right where fixed steps fail",
                   "etak f0 FILE --method exact"}};
  family.notes = {
      "Against the 1 nm sum instead of the exact integral, over the same datasets: " + against_1nm(samples) +
          ".",
      "Auto takes the coarsest of 20, 10, 5, 1 nm and exact whose estimated error of X, Y, Z is within the bound; the estimate comes from where the data bend, not from trying (resources/doc/f0.md).",
      "Times are of the whole solve: coverage, interpolation, Fresnel at 0 degrees and at cos 1/7, sum, colour. Pages are read from memory."};
  return family;
}

}  // namespace etak
