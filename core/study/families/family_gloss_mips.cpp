// SPDX-License-Identifier: Apache-2.0
// Family g: the gloss that a mip level should hold for two glosses side by side.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/base/number.h"
#include "core/color/gloss.h"
#include "core/color/srgb.h"
#include "core/math/functions.h"
#include "core/math/quadrature.h"
#include "core/study/families/families.h"
#include "core/study/measure.h"

namespace etak {
namespace {

// Rules that make one gloss of two: in double for the errors, in float for the times.
template <class Real>
Real mean_gloss(Real a, Real b) {
  return (a + b) / 2;
}
template <class Real>
Real mean_exponent(Real a, Real b) {
  return gloss_of_exponent((exponent_of_gloss(a) + exponent_of_gloss(b)) / 2);
}
template <class Real>
Real mean_variance(Real a, Real b) {
  return gloss_of_exponent(2 / (1 / exponent_of_gloss(a) + 1 / exponent_of_gloss(b)));
}
// The mean of alpha^2 = 2 / (e + 2). It may be wider than gloss 0, whose exponent is 1.
template <class Real>
Real mean_alpha2(Real a, Real b) {
  const Real mean = 1 / (exponent_of_gloss(a) + 2) + 1 / (exponent_of_gloss(b) + 2);
  return gloss_of_exponent(std::max(2 / mean - 2, Real(1)));
}

struct Rule {
  const char* id;
  const char* title;
  double (*in_double)(double, double);
  float (*in_float)(float, float);
};
constexpr std::array rules{
    Rule{"mean_gloss", "mean of g", mean_gloss<double>, mean_gloss<float>},
    Rule{"mean_exponent", "mean of e", mean_exponent<double>, mean_exponent<float>},
    Rule{"mean_alpha2", "mean of 2 / (e + 2)", mean_alpha2<double>, mean_alpha2<float>},
    Rule{"mean_variance", "mean of 1 / e (etak's mips)", mean_variance<double>, mean_variance<float>}};

struct Pair {
  double a, b;
};
constexpr std::array shown_pairs{Pair{0.5, 0.75}, Pair{0.25, 0.75}, Pair{0.5, 1}, Pair{0, 1}};

// The lobe (e + 2) / (2 pi) nh^e, times pi, as a function of s = nh^2.
double lobe(double e, double s) {
  return s <= 0 ? (e == 0 ? 1 : 0) : (e + 2) / 2 * math::pow(s, e / 2);
}

// Half the integral of |D - mean of D_a and D_b| nh: 0 for equal lobes, 1 for lobes that do not overlap.
double lobe_error(const Pair& pair, double gloss) {
  const double e = exponent_of_gloss(gloss), a = exponent_of_gloss(pair.a), b = exponent_of_gloss(pair.b);
  // With s = nh^2 the measure D nh dw is pi D ds. Glossy lobes lie just below s = 1, so that the pieces of
  // the integral get shorter towards it.
  const auto difference = [&](double t) {
    const double s = 1 - t;
    return std::abs(lobe(e, s) - (lobe(a, s) + lobe(b, s)) / 2);
  };
  double sum = 0, from = 0;
  for (double to = 0x1p-14; from < 1; to *= 2) {
    to = std::min(to, 1.0);
    sum += adaptive_integral(difference, from, to, 1e-9, 16);
    from = to;
  }
  return sum / 2;
}

// The error of the best single lobe. Between the two glosses the error falls once and then rises.
double best_error(const Pair& pair) {
  double best = 1;
  constexpr int steps = 200;
  double at = pair.a;
  for (int i = 0; i <= steps; ++i) {
    const double gloss = pair.a + (pair.b - pair.a) * i / steps, error = lobe_error(pair, gloss);
    if (error < best) best = error, at = gloss;
  }
  double step = (pair.b - pair.a) / steps;
  for (int round = 0; round < 12; ++round, step /= 2)
    for (const double gloss : {at - step, at + step})
      if (const double error = lobe_error(pair, gloss); error < best) best = error, at = gloss;
  return best;
}

std::string text_of(const Pair& pair) {
  return number(pair.a, 3) + " and " + number(pair.b, 3);
}

TimedCase timed(const Rule& rule) {
  const auto values = random_floats(8192, 0, 1);
  return {rule.id, 4096, [values, &rule, out = std::make_shared<std::vector<float>>(4096)] {
            for (std::size_t i = 0; i < out->size(); ++i)
              (*out)[i] = rule.in_float((*values)[2 * i], (*values)[2 * i + 1]);
            keep(out->data());
          }};
}

ErrorTimeTable pair_table(std::vector<TimedSet>& timings) {
  ErrorTimeTable table;
  table.id = "pairs";
  table.title = "Two glosses in one texel";
  table.time_unit = "ns per texel of two";
  table.base = "mean_gloss";
  table.metrics = {{"mean", "mean over all pairs", ""}, {"worst_excess", "most above the best lobe", ""}};
  for (const Pair& pair : shown_pairs)
    table.metrics.push_back(
        {"pair_" + number(pair.a, 3) + "_" + number(pair.b, 3), "gloss " + text_of(pair), ""});
  // All pairs of glosses in steps of a quarter; the shown pairs are among them.
  std::vector<Pair> pairs;
  for (int a = 0; a < 4; ++a)
    for (int b = a + 1; b <= 4; ++b) pairs.push_back({a / 4.0, b / 4.0});

  std::vector<double> best;
  for (const Pair& pair : pairs) best.push_back(best_error(pair));
  const auto add = [&](const std::string& id, const std::string& title, auto error) -> ErrorTimeRow& {
    ErrorTimeRow row;
    row.id = id;
    row.title = title;
    row.errors = {0, 0};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double value = error(pairs[i], i);
      row.errors[0] += value / static_cast<double>(pairs.size());
      row.errors[1] = std::max(row.errors[1], value - best[i]);
    }
    for (const Pair& shown : shown_pairs)
      for (std::size_t i = 0; i < pairs.size(); ++i)
        if (pairs[i].a == shown.a && pairs[i].b == shown.b) row.errors.push_back(error(pairs[i], i));
    return table.rows.emplace_back(std::move(row));
  };
  std::vector<TimedCase> cases;
  for (const Rule& rule : rules) {
    add(rule.id, rule.title,
        [&](const Pair& pair, std::size_t) { return lobe_error(pair, rule.in_double(pair.a, pair.b)); });
    cases.push_back(timed(rule));
  }
  add("best", "best single lobe", [&](const Pair&, std::size_t i) { return best[i]; }).note =
      "searched: what no rule can beat";
  timings.push_back({{table.id}, std::move(cases)});
  return table;
}

}  // namespace

ErrorTimeFamily gloss_mip_family(const ReportOptions&) {
  ErrorTimeFamily family;
  family.id = "gloss-mips";
  family.letter = "g";
  family.title = "Gloss in mip levels";
  family.reference = "the mean of the two normalised Phong lobes; half the integral of |D - mean| nm";
  family.grid = "pairs of the glosses 0, 0.25, 0.5, 0.75, 1";
  family.tables = {pair_table(family.timed)};
  const auto& rows = family.tables[0].rows;
  family.advice =
      "Where single lobes side by side are all there is, average e: it is within " +
      number(rows[1].errors[1], 2) + " of the best single lobe everywhere, where averaging g loses up to " +
      number(rows[0].errors[1], 2) +
      "; etak's mips average 1 / e, as Toksvig does, because then the spread of normals adds to it.";
  family.picks = {{"gloss in mip levels", "pairs", "mean_exponent", "where there are no normals to add"}};
  const double dark = 0.04, bright = 0.95;
  const double coded = srgb_decode((srgb_encode(dark) + srgb_encode(bright)) / 2);
  family.notes = {"Colour has the same trap: the mean of the sRGB codes of F0 " + number(dark, 2) + " and " +
                      number(bright, 2) + " is " + number(coded, 3) + " in linear light, where the mean is " +
                      number((dark + bright) / 2, 3) +
                      ": inside the forbidden zone, though neither material is.",
                  "Times are of one texel from two in float, with the C library's exp2 and log2."};
  return family;
}

}  // namespace etak
