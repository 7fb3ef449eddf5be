// SPDX-License-Identifier: Apache-2.0
// Family f: the errors of 8 bits per channel in an atlas.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/base/number.h"
#include "core/color/delta_e.h"
#include "core/color/gloss.h"
#include "core/color/srgb.h"
#include "core/material/f0.h"
#include "core/material/library.h"
#include "core/math/functions.h"
#include "core/study/families/families.h"
#include "core/study/measure.h"

namespace etak {
namespace {

// A way to store a number in [0, 1] as one of `codes` + 1 codes: `encode`, then rounding to nearest.
struct Coding {
  const char* id;
  const char* title;
  double codes;
  double (*encode)(double);
  double (*decode)(double);
  void (*many)(const float* in, std::uint16_t* out, std::size_t count);
};

// ---- F0

float encode_srgb(float x) {
  return x <= 0.0031308f ? 12.92f * x : 1.055f * math::pow(x, 1 / 2.4f) - 0.055f;
}
template <class Encode>
void encode_many(const float* in, std::uint16_t* out, std::size_t count, float codes, Encode encode) {
  for (std::size_t i = 0; i < count; ++i)
    out[i] = static_cast<std::uint16_t>(codes * encode(std::clamp(in[i], 0.0f, 1.0f)) + 0.5f);
}

constexpr std::array f0_codings{
    Coding{"srgb8", "sRGB, 8 bit", 255, srgb_encode, srgb_decode,
           [](const float* in, std::uint16_t* out, std::size_t count) {
             encode_many(in, out, count, 255, encode_srgb);
           }},
    Coding{"power22_8", "power 1/2.2, 8 bit", 255, [](double x) { return math::pow(x, 1 / 2.2); },
           [](double y) { return math::pow(y, 2.2); },
           [](const float* in, std::uint16_t* out, std::size_t count) {
             encode_many(in, out, count, 255, [](float x) { return math::pow(x, 1 / 2.2f); });
           }},
    Coding{"root8", "square root, 8 bit", 255, [](double x) { return std::sqrt(x); },
           [](double y) { return y * y; },
           [](const float* in, std::uint16_t* out, std::size_t count) {
             encode_many(in, out, count, 255, [](float x) { return std::sqrt(x); });
           }},
    Coding{"linear8", "linear, 8 bit", 255, [](double x) { return x; }, [](double y) { return y; },
           [](const float* in, std::uint16_t* out, std::size_t count) {
             encode_many(in, out, count, 255, [](float x) { return x; });
           }},
    Coding{"linear16", "linear, 16 bit", 65535, [](double x) { return x; }, [](double y) { return y; },
           [](const float* in, std::uint16_t* out, std::size_t count) {
             encode_many(in, out, count, 65535, [](float x) { return x; });
           }}};
constexpr std::array shown_f0{0.02, 0.04, 0.08, 0.5};

double rounded(const Coding& coding, double x) {
  return coding.decode(std::floor(coding.codes * coding.encode(x) + 0.5) / coding.codes);
}

// Half the distance between codes at x, as a share of x: the mean of the steps up and down.
double half_step(const Coding& coding, double x) {
  const double code = coding.encode(x), half = 0.5 / coding.codes;
  return (coding.decode(code + half) - coding.decode(code - half)) / 2 / x;
}

// F0 of every table and formula of the library, clamped to [0, 1], because errors of clipping are not the question
// here.
std::vector<LinearRgb> library_colours() {
  const auto library = MaterialLibrary::builtin();
  const F0Solver solver({});
  std::vector<LinearRgb> out;
  for (std::size_t i = 0; i < library.ids().size(); ++i)
    for (const Material material = library.as_filed(i); const Dataset& dataset : material.datasets) {
      const F0Result result = solver.solve(dataset.optics);
      if (result.refused()) continue;
      Vec3 rgb = vec(result.srgb_linear);
      for (double& channel : rgb) channel = std::clamp(channel, 0.0, 1.0);
      out.push_back(to_rgb(rgb));
    }
  return out;
}

TimedSet timed_set(const ErrorTimeTable& table, std::span<const Coding> codings) {
  const auto values = random_floats(4096, 0.02f, 1);
  std::vector<TimedCase> cases;
  for (const Coding& coding : codings)
    cases.push_back({coding.id, values->size(),
                     [values, &coding, out = std::make_shared<std::vector<std::uint16_t>>(values->size())] {
                       coding.many(values->data(), out->data(), values->size());
                       keep(out->data());
                     }});
  return {{table.id}, std::move(cases)};
}

ErrorTimeTable f0_table(std::span<const LinearRgb> colours, std::vector<TimedSet>& timings) {
  ErrorTimeTable table;
  table.id = "f0";
  table.title = "F0 in a code";
  table.time_unit = "ns per encoded channel";
  table.base = "srgb8";
  table.metrics = {{"library_max_de", "library: largest colour difference", "ΔE2000"},
                   {"library_mean_de", "library: mean colour difference", "ΔE2000"},
                   {"library_max", "library: largest error of a channel above 0.01", "%"}};
  for (const double x : shown_f0)
    table.metrics.push_back({"half_step_" + number(x, 3), "half a step at " + number(x, 3), "%"});
  for (const Coding& coding : f0_codings) {
    ErrorTimeRow row;
    row.id = coding.id;
    row.title = coding.title;
    // Twice the bytes are another choice: what a texture can hold is decided first.
    row.truth = coding.codes > 255 ? "16 bits" : "8 bits";
    double max_de = 0, mean_de = 0, worst = 0;
    for (const LinearRgb& colour : colours) {
      const Vec3 before = vec(colour);
      Vec3 after{};
      for (std::size_t c = 0; c < 3; ++c) {
        after[c] = rounded(coding, before[c]);
        if (before[c] > 0.01) worst = std::max(worst, std::abs(after[c] / before[c] - 1));
      }
      const double de = delta_e2000(to_lab(colour), to_lab(to_rgb(after)));
      max_de = std::max(max_de, de);
      mean_de += de / static_cast<double>(colours.size());
    }
    row.errors = {max_de, mean_de, 100 * worst};
    for (const double x : shown_f0) row.errors.push_back(100 * half_step(coding, x));
    table.rows.push_back(row);
  }
  timings.push_back(timed_set(table, f0_codings));
  return table;
}

// ---- gloss: the number that is stored is a function of Schueler's g, as the exponent is

double gloss_of_alpha(double alpha) {
  return gloss_of_exponent(exponent_of_alpha(alpha));
}

constexpr std::array gloss_codings{
    Coding{"gloss8", "gloss g, 8 bit", 255, [](double g) { return g; }, [](double code) { return code; },
           [](const float* in, std::uint16_t* out, std::size_t count) {
             encode_many(in, out, count, 255, [](float g) { return g; });
           }},
    Coding{"roughness8", "roughness, the root of alpha, 8 bit", 255,
           [](double g) { return std::sqrt(alpha_of_gloss(g)); },
           [](double code) { return gloss_of_alpha(code * code); },
           [](const float* in, std::uint16_t* out, std::size_t count) {
             encode_many(in, out, count, 255, [](float g) { return std::sqrt(alpha_of_gloss(g)); });
           }},
    Coding{"alpha8", "alpha, 8 bit", 255, [](double g) { return alpha_of_gloss(g); }, gloss_of_alpha,
           [](const float* in, std::uint16_t* out, std::size_t count) {
             encode_many(in, out, count, 255, [](float g) { return alpha_of_gloss(g); });
           }},
    Coding{"exponent8", "exponent e up to 4096, 8 bit", 255,
           [](double g) { return exponent_of_gloss(g) / 4096; },
           [](double code) { return gloss_of_exponent(std::max(4096 * code, 1.0)); },
           [](const float* in, std::uint16_t* out, std::size_t count) {
             encode_many(in, out, count, 255, [](float g) { return exponent_of_gloss(g) / 4096; });
           }}};

ErrorTimeTable gloss_table(std::vector<TimedSet>& timings) {
  ErrorTimeTable table;
  table.id = "gloss";
  table.title = "Gloss in a code";
  table.time_unit = "ns per encoded texel";
  table.base = "gloss8";
  table.metrics = {{"max_alpha", "largest error of alpha", "%"},
                   {"mean_alpha", "mean error of alpha", "%"},
                   {"max_e", "largest error of e", "%"},
                   {"mean_e", "mean error of e", "%"}};
  constexpr int sweep = 100000;
  for (const Coding& coding : gloss_codings) {
    ErrorTimeRow row;
    row.id = coding.id;
    row.title = coding.title;
    row.errors = {0, 0, 0, 0};
    for (int i = 0; i <= sweep; ++i) {
      const double gloss = i / double{sweep};
      const double kept = std::clamp(rounded(coding, gloss), 0.0, 2.0);
      const double alpha = 100 * std::abs(alpha_of_gloss(kept) / alpha_of_gloss(gloss) - 1);
      const double e = 100 * std::abs(exponent_of_gloss(kept) / exponent_of_gloss(gloss) - 1);
      row.errors[0] = std::max(row.errors[0], alpha);
      row.errors[1] += alpha / (sweep + 1);
      row.errors[2] = std::max(row.errors[2], e);
      row.errors[3] += e / (sweep + 1);
    }
    table.rows.push_back(row);
  }
  timings.push_back(timed_set(table, gloss_codings));
  return table;
}

}  // namespace

ErrorTimeFamily quantisation_family(const ReportOptions&) {
  const auto colours = library_colours();
  ErrorTimeFamily family;
  family.id = "quantisation";
  family.letter = "f";
  family.title = "Eight bits in an atlas";
  family.reference = "the number before it was rounded to a code";
  family.grid =
      std::to_string(colours.size()) + " colours of the library, kept to [0, 1]; 100,001 glosses from 0 to 1";
  family.tables = {f0_table(colours, family.timed), gloss_table(family.timed)};
  const auto& f0 = family.tables[0].rows;
  family.advice =
      "Keep F0 as sRGB in 8 bit (at most ΔE2000 " + number(f0[0].errors[0], 2) +
      " over the library, where linear 8 bit gives " + number(f0[3].errors[0], 2) +
      "; 16 bit linear has nothing to see and is quicker, for twice the bytes) and gloss as it is: its " +
      number(family.tables[1].rows[0].errors[2], 2) +
      " % of e is the same everywhere, while alpha in 8 bit fails on polished surfaces.";
  family.picks = {{"F0 in a texture of 8 bits", "f0", "srgb8",
                   "no visible step; 16 bits are closer, for twice the bytes"},
                  {"gloss in a texture", "gloss", "gloss8", "the same relative step everywhere"}};
  family.notes = {
      "One code of gloss multiplies the exponent by " + number(exponent_of_gloss(1 / 255.0), 5) +
          "; g = 0 and g = 1 are codes.",
      "Half a step is the most that rounding moves a value, as a share of it. Times are of a float to a code with the C library's functions; tables of 256 entries are faster."};
  return family;
}

}  // namespace etak
