// SPDX-License-Identifier: Apache-2.0
// Family c: whole lobes against Schueler's technique 1 (CookTorranceFull).
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/brdf/models.h"
#include "core/color/gloss.h"
#include "core/math/functions.h"
#include "core/math/quadrature.h"
#include "core/study/families/families.h"
#include "core/study/measure.h"

namespace etak {
namespace {

// A surface by n and k at one wavelength, because lobes are compared and not colours.
struct Surface {
  const char* id;
  const char* title;
  double n, k;
};
constexpr std::array surfaces{
    Surface{"glass", "glass", 1.5, 0},      Surface{"water", "water", 1.333, 0},
    Surface{"diamond", "diamond", 2.42, 0}, Surface{"gold", "gold, red", 0.16, 3.5},
    Surface{"iron", "iron", 2.9, 3.05},     Surface{"silicon", "silicon", 4.08, 0.04}};
constexpr std::size_t count = surfaces.size();

double f0_of(const Surface& s) {
  return ((s.n - 1) * (s.n - 1) + s.k * s.k) / ((s.n + 1) * (s.n + 1) + s.k * s.k);
}

constexpr std::string_view reference_id = "schueler-full";
struct Way {
  std::string_view id, title;
};
constexpr std::array ways{Way{reference_id, "Full: exact F, Beckmann"},
                          Way{"schueler-simplified", "Simplified"},
                          Way{"schueler-ksk", "KelemenSzirmayKalos"},
                          Way{"schueler-optimized", "Optimized, as printed"},
                          Way{"schueler-optimized-bounded", "Optimized, bounded"},
                          Way{"phong-schlick", "Simplified, e + 2, Schlick"},
                          Way{"phong-kelemen", "KSK, e + 2, Schlick"},
                          Way{"beckmann-schlick", "Beckmann, Schlick, V-grooves"},
                          Way{"blinn-phong", "Blinn-Phong"},
                          Way{"ggx-schlick", "GGX, Schlick, Smith"}};

const Model& model_of(std::string_view id) {
  const Model* model = find_model(id);
  if (model == nullptr) throw Error::at(id, "is no model");
  return *model;
}

// The values of a model at one gloss, with a surface in each of the three channels.
std::vector<double> values_for(const Model& model, std::span<const Surface> three, double gloss) {
  const double e = exponent_of_gloss(gloss);
  std::vector<double> out;
  for (const Parameter& p : model.parameters)
    for (std::size_t c = 0; c < (p.color ? 3 : 1); ++c) switch (p.role) {
        case Role::f0:
          out.push_back(f0_of(three[c]));
          break;
        case Role::n:
          out.push_back(three[c].n);
          break;
        case Role::k:
          out.push_back(three[c].k);
          break;
        case Role::gloss:
          out.push_back(gloss);
          break;
        case Role::exponent:
          out.push_back(e);
          break;
        case Role::alpha:
          out.push_back(alpha_of_exponent(e));
          break;
        default:
          out.push_back(0);  // the diffuse part of Blinn-Phong is left out
      }
  return out;
}

// Sums over light and view, per surface.
struct Sums {
  std::array<double, count> difference{}, bias{};  // of |f - f*| and f - f*, times nl nv
  std::array<double, count> ratio{};               // the largest of f / f* and f* / f
};

struct Measured {
  std::array<double, count> whole{};  // of f* nl nv
  std::array<Sums, ways.size()> by_way;
};

// One pair of directions with its weight in the integral over light.
struct Sample {
  Directions d;
  double weight;
};

// Pairs of directions whose half vectors are distributed as in GGX of the width that the gloss has, so that
// long tails are sampled too: `steps` equal parts of its weight, `steps` azimuths over half a turn (the other
// half is a mirror image).
std::vector<Sample> samples_of(double gloss, double nv, int steps) {
  const double alpha2 = 2 / (exponent_of_gloss(gloss) + 2);
  const double vx = std::sqrt(1 - nv * nv);
  std::vector<Sample> out;
  for (int i = 0; i < steps; ++i) {
    const double share = (i + 0.5) / steps, tan2 = alpha2 * share / (1 - share);
    const double nh2 = 1 / (1 + tan2), nh = std::sqrt(nh2), s = std::sqrt(tan2 * nh2);
    const double root = nh2 * (alpha2 + tan2);
    const double density = alpha2 / (std::numbers::pi * root * root) * nh;
    for (int j = 0; j < steps; ++j) {
      const double phi = std::numbers::pi * (j + 0.5) / steps;
      const double hx = s * math::cos(phi), hy = s * math::sin(phi), vh = vx * hx + nv * nh;
      const Directions d{2 * vh * hx - vx, 2 * vh * hy, 2 * vh * nh - nv, vx, 0, nv};
      if (!(vh > 0) || !(d.lz > 0)) continue;
      out.push_back({d, 4 * vh / (density * steps * steps)});  // dl = 4 vh dh
    }
  }
  return out;
}

void add_view(double gloss, double nv, double view_weight, int steps, Measured& out) {
  const std::vector<Sample> samples = samples_of(gloss, nv, steps);
  std::vector<double> truth(samples.size() * 3);
  for (std::size_t first = 0; first < count; first += 3) {
    const std::span<const Surface> three(surfaces.data() + first, 3);
    std::array<double, 3> peak{};
    for (std::size_t w = 0; w < ways.size(); ++w) {
      const Model& model = model_of(ways[w].id);
      const std::vector<double> values = values_for(model, three, gloss);
      Sums& sums = out.by_way[w];
      for (std::size_t i = 0; i < samples.size(); ++i) {
        const double nl = samples[i].d.lz, weight = samples[i].weight * view_weight * nl * nv;
        double* f0 = &truth[3 * i];
        double f[3];
        model.f64(samples[i].d, values.data(), f);
        for (std::size_t c = 0; c < 3; ++c) {
          if (w == 0) {
            f0[c] = f[c];
            peak[c] = std::max(peak[c], f[c] * nl);
            out.whole[first + c] += weight * f[c];
          }
          sums.difference[first + c] += weight * std::abs(f[c] - f0[c]);
          sums.bias[first + c] += weight * (f[c] - f0[c]);
          if (nv > 0.25 && f0[c] * nl >= 0.01 * peak[c] && f[c] > 0)
            sums.ratio[first + c] = std::max({sums.ratio[first + c], f[c] / f0[c], f0[c] / f[c]});
        }
      }
    }
  }
}

Measured measure(double gloss, int steps) {
  Measured out;
  static const GaussLegendre<12> views;
  for (std::size_t i = 0; i < views.node.size(); ++i)
    add_view(gloss, (1 + views.node[i]) / 2, views.weight[i] / 2, steps, out);
  return out;
}

std::vector<TimedCase> timed_ways() {
  constexpr std::size_t directions = 4096;
  auto arrays = std::make_shared<std::array<std::vector<float>, 6>>();
  Random random(7);
  for (std::size_t i = 0; i < directions; ++i)
    for (std::size_t side = 0; side < 6; side += 3) {
      const double z = random.uniform(0.05, 1), phi = random.uniform(0, 2 * std::numbers::pi);
      const double s = std::sqrt(1 - z * z);
      (*arrays)[side].push_back(static_cast<float>(s * math::cos(phi)));
      (*arrays)[side + 1].push_back(static_cast<float>(s * math::sin(phi)));
      (*arrays)[side + 2].push_back(static_cast<float>(z));
    }
  std::vector<TimedCase> cases;
  for (const Way& way : ways) {
    const Model& model = model_of(way.id);
    cases.push_back({std::string(way.id), directions,
                     [arrays, &model, values = values_for(model, {surfaces.data(), 3}, 0.75),
                      out = std::make_shared<std::array<std::vector<float>, 3>>(
                          std::array{std::vector<float>(directions), std::vector<float>(directions),
                                     std::vector<float>(directions)})] {
                       const float* in[6];
                       float* rgb[3];
                       for (std::size_t i = 0; i < 6; ++i) in[i] = (*arrays)[i].data();
                       for (std::size_t c = 0; c < 3; ++c) rgb[c] = (*out)[c].data();
                       model.f32_batch(directions, in, values.data(), rgb);
                       keep(rgb[0]);
                     }});
  }
  return cases;
}

ErrorTimeTable table_of(double gloss, const Measured& measured) {
  ErrorTimeTable table;
  table.id = "gloss_" + number(gloss, 3);
  table.title = "Gloss " + number(gloss, 3) + " (exponent " + number(exponent_of_gloss(gloss), 4) + ")";
  table.time_unit = "ns per pair of directions, three channels";
  table.base = "schueler-simplified";
  table.metrics = {{"l1_mean", "relative L1, mean", "%"}};
  for (const Surface& s : surfaces)
    table.metrics.push_back({std::string("l1_") + s.id, std::string("L1, ") + s.title, "%"});
  for (const Surface& s : surfaces)
    table.metrics.push_back({std::string("bias_") + s.id, std::string("albedo bias, ") + s.title, "%"});
  table.metrics.push_back({"max_ratio", "largest ratio near the peak", ""});
  for (std::size_t w = 0; w < ways.size(); ++w) {
    const Sums& sums = measured.by_way[w];
    ErrorTimeRow row;
    row.id = ways[w].id;
    row.title = ways[w].title;
    row.errors = {0};
    for (std::size_t s = 0; s < count; ++s) {
      row.errors.push_back(100 * sums.difference[s] / measured.whole[s]);
      row.errors[0] += row.errors.back() / count;
    }
    for (std::size_t s = 0; s < count; ++s) row.errors.push_back(100 * sums.bias[s] / measured.whole[s]);
    row.errors.push_back(*std::max_element(sums.ratio.begin(), sums.ratio.end()));
    if (w == 0) row.note = "the reference";
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace

ErrorTimeFamily lobe_family(const ReportOptions& options) {
  constexpr std::array every_gloss{0.0, 0.25, 0.5, 0.75, 1.0};
  constexpr std::array quick_gloss{0.25, 0.75};
  const std::span<const double> glosses =
      options.full ? std::span<const double>(every_gloss) : std::span<const double>(quick_gloss);
  ErrorTimeFamily family;
  family.id = "lobes";
  family.letter = "c";
  family.title = "Whole lobes";
  family.reference =
      "CookTorranceFull as a BRDF: Beckmann of the width that fits the exponent, exact Fresnel, V-grooves";
  const int steps = options.full ? 200 : 120;
  family.grid = "12 Gauss points in the view's cosine, " + std::to_string(steps) + " x " +
                std::to_string(2 * steps) + " half vectors spread as GGX spreads them";
  for (const double gloss : glosses) family.tables.push_back(table_of(gloss, measure(gloss, steps)));
  TimedSet timed{{}, timed_ways()};
  for (const ErrorTimeTable& table : family.tables) timed.tables.push_back(table.id);
  family.timed = {std::move(timed)};
  const ErrorTimeTable& glossy = family.tables[options.full ? 3 : 1];
  const auto mean = [&](std::size_t way) { return number(glossy.rows[way].errors[0], 2) + " %"; };
  family.advice = "Take a Beckmann or e + 2 lobe with Schlick's F: at gloss 0.75 they are " + mean(7) +
                  " and " + mean(5) + " from the full technique, where Simplified as printed is " + mean(1) +
                  " and bounded Optimized " + mean(4) + "; GGX is another lobe (" + mean(9) +
                  "), for materials that were authored with it.";
  family.picks = {{"surfaces in Schüler's manner", glossy.id, "beckmann-schlick",
                   "the cheapest lobe that is near the full technique at every gloss"}};
  family.notes = {
      "Relative L1 is the integral of |f - f*| nl nv over all light and view over that of f* nl nv, albedo bias the same without the bars; the ratio is where f* nl is above 1 % of its peak and nv above 0.25.",
      "The techniques get F0 of the same n and k; the width of GGX is that of Beckmann, sqrt(2 / (e + 2)).",
      "Schüler puts KelemenSzirmayKalos below Simplified: it lacks the minimum of G, and on the cards of 2009 each operation took its time. Here both wait for one division, 1 / (4 lh^2) or min(lh, 2 nh least) / (4 lh least "
      "most), beside which the minima cost next to nothing, and the power of D takes most of either: they differ by less than two runs do, so that one may stand in front as well as the other.",
      "Times are of the single-precision loops of " + std::string(batch_instruction_set()) +
          " over 4096 pairs of directions."};
  return family;
}

}  // namespace etak
