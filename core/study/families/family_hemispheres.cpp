// SPDX-License-Identifier: Apache-2.0
// Family d: formulas for specular light from two hemispheres, against the integral.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

#include "core/base/number.h"
#include "core/brdf/integrals/albedo.h"
#include "core/brdf/models.h"
#include "core/color/gloss.h"
#include "core/math/functions.h"
#include "core/study/families/families.h"
#include "core/study/measure.h"

namespace etak {
namespace {

namespace in_double {
#include "core/math/real_f64.h"

#include "core/fresnel/texts.h"

#include "core/light/texts.h"
}  // namespace in_double

namespace in_single {
#include "core/math/real_f32.h"

#include "core/fresnel/texts.h"

#include "core/light/texts.h"
}  // namespace in_single

constexpr std::array reflectances{0.02, 0.04, 0.17, 0.5, 0.9};
constexpr std::array glosses{0.0, 0.25, 0.5, 0.75, 0.9, 1.0};
constexpr std::array view_cosines{1.0, 0.8, 0.6, 0.4, 0.2, 0.1, 0.05};

struct Form {
  const char* id;
  const char* title;
  in_double::vec3 (*in_double)(in_double::vec3, double, double, double, in_double::vec3, in_double::vec3);
  in_single::vec3 (*in_single)(in_single::vec3, float, float, float, in_single::vec3, in_single::vec3);
};
constexpr std::array forms{Form{"corrected", "corrected, width 1 - g", in_double::hemisphere_specular,
                                in_single::hemisphere_specular},
                           Form{"wide", "corrected, width 1.8 2^(-6 g)", in_double::hemisphere_specular_wide,
                                in_single::hemisphere_specular_wide},
                           Form{"printed", "as printed", in_double::hemisphere_specular_printed,
                                in_single::hemisphere_specular_printed}};

// A viewer at the cosine nv from the normal, whose mirror direction has the cosine rz from the axis of the hemispheres.
struct Seen {
  double nv, rz;
};

// The light of a form, of a lower hemisphere of that radiance and an upper one of radiance 1.
double value(const Form& form, double K, double g, const Seen& seen, double lower) {
  return form.in_double(in_double::vec3(K), g, seen.nv, seen.rz, in_double::vec3(lower), in_double::vec3(1.0))
      .x;
}

// The light that the model Simplified sends to a viewer, for one reflectance.
struct Truth {
  double albedo = 0;
  std::vector<double> upper;  // for each axis z, the share of the light from l . z > 0
};

// Axes of the hemispheres: tilts and azimuths from 0 to 180 degrees, because the other half is a mirror
// image.
std::vector<Vec3> make_axes(int tilts, int azimuths) {
  std::vector<Vec3> out;
  for (int tilt = 0; tilt < tilts; ++tilt)
    for (int azimuth = 0; azimuth < azimuths; ++azimuth)
      out.push_back(direction_deg(tilt * 180.0 / (tilts - 1), azimuth * 180.0 / (azimuths - 1)));
  return out;
}

// The truth for all reflectances at once, as a sum over half vectors. They are distributed as the lobe is, so
// that all have about the same weight: midpoints of `steps` equal parts of the lobe's weight, times `steps`
// azimuths.
std::array<Truth, reflectances.size()> integrate(double g, double nv, std::span<const Vec3> axes, int steps) {
  const Model& model = *find_model("schueler-simplified");
  const double e = exponent_of_gloss(g);
  const Vec3 v{std::sqrt(1 - nv * nv), 0, nv};
  std::array<Truth, reflectances.size()> out{};
  for (Truth& truth : out) truth.upper.assign(axes.size(), 0.0);
  for (int i = 0; i < steps; ++i) {
    const double share = (i + 0.5) / steps, log_nh = math::log(share) / (e + 2);
    const double nh = math::exp(log_nh), s = std::sqrt(-math::expm1(2 * log_nh));
    for (int j = 0; j < steps; ++j) {
      const double phi = 2 * std::numbers::pi * (j + 0.5) / steps;
      const Vec3 h{s * math::cos(phi), s * math::sin(phi), nh};
      const double vh = v[0] * h[0] + v[2] * h[2];
      const Vec3 l{2 * vh * h[0] - v[0], 2 * vh * h[1], 2 * vh * h[2] - v[2]};
      if (!(vh > 0) || !(l[2] > 0)) continue;
      // dl = 4 vh dh, and the half vectors' density is (e + 2) / (2 pi) nh^(e + 1).
      const double weight =
          l[2] * 4 * vh * 2 * std::numbers::pi / ((e + 2) * math::exp((e + 1) * log_nh) * steps * steps);
      // One evaluation has three channels, so that it gives three reflectances.
      std::array<double, 6> f{};
      for (std::size_t k = 0; k < f.size(); k += 3) {
        const std::array<double, 4> values{reflectances[k], reflectances[k + 1],
                                           reflectances[std::min(k + 2, reflectances.size() - 1)], g};
        model.f64({l[0], l[1], l[2], v[0], v[1], v[2]}, values.data(), f.data() + k);
      }
      for (std::size_t z = 0; z < axes.size(); ++z) {
        const double lz = l[0] * axes[z][0] + l[1] * axes[z][1] + l[2] * axes[z][2];
        if (!(lz > 0)) continue;
        for (std::size_t k = 0; k < reflectances.size(); ++k) out[k].upper[z] += weight * f[k];
      }
      for (std::size_t k = 0; k < reflectances.size(); ++k) out[k].albedo += weight * f[k];
    }
  }
  for (Truth& truth : out)
    for (double& upper : truth.upper) upper /= truth.albedo;
  return out;
}

// Errors of one form at one gloss, over reflectances and views.
struct Errors {
  double mean = 0, max = 0;                // of the albedo
  double share_square = 0, share_max = 0;  // of the upper hemisphere's share; mean square
};

std::array<Errors, forms.size()> measure(double g, std::span<const Vec3> axes, int steps) {
  std::array<Errors, forms.size()> out{};
  constexpr double cells = reflectances.size() * view_cosines.size();
  for (const double nv : view_cosines) {
    const auto truths = integrate(g, nv, axes, steps);
    const Vec3 r{-std::sqrt(1 - nv * nv), 0, nv};
    for (std::size_t k = 0; k < reflectances.size(); ++k)
      for (std::size_t f = 0; f < forms.size(); ++f) {
        Errors& errors = out[f];
        // With both hemispheres white, only the Fresnel term is left.
        const double all = value(forms[f], reflectances[k], g, {nv, 0}, 1);
        const double miss = std::abs(all - truths[k].albedo);
        errors.mean += miss / cells;
        errors.max = std::max(errors.max, miss);
        for (std::size_t z = 0; z < axes.size(); ++z) {
          const double rz = r[0] * axes[z][0] + r[1] * axes[z][1] + r[2] * axes[z][2];
          const double wrong = value(forms[f], reflectances[k], g, {nv, rz}, 0) / all - truths[k].upper[z];
          errors.share_square += wrong * wrong / (cells * static_cast<double>(axes.size()));
          errors.share_max = std::max(errors.share_max, std::abs(wrong));
        }
      }
  }
  return out;
}

TimedCase timed(const Form& form) {
  const auto K = random_floats(4096, 0.02f, 0.9f), g = random_floats(4096, 0, 1, 2),
             nv = random_floats(4096, 0.05f, 1, 3), rz = random_floats(4096, -1, 1, 4);
  return {form.id, K->size(), [=, &form, out = std::make_shared<std::vector<float>>(K->size() * 3)] {
            const in_single::vec3 lower(0.1f, 0.1f, 0.1f), upper(0.9f, 0.9f, 1);
            for (std::size_t i = 0; i < K->size(); ++i) {
              const auto light =
                  form.in_single(in_single::vec3((*K)[i]), (*g)[i], (*nv)[i], (*rz)[i], lower, upper);
              (*out)[3 * i] = light.x;
              (*out)[3 * i + 1] = light.y;
              (*out)[3 * i + 2] = light.z;
            }
            keep(out->data());
          }};
}

using PerGloss = std::array<std::array<Errors, forms.size()>, glosses.size()>;

ErrorTimeTable albedo_table(const PerGloss& errors) {
  ErrorTimeTable table;
  table.id = "albedo";
  table.title = "Light from a white surrounding";
  table.metrics = {{"mean", "mean error of the albedo", ""},
                   {"mean_glossy", "the same from g = 0.25 on", ""},
                   {"max", "largest error of the albedo", ""}};
  for (std::size_t f = 0; f < forms.size(); ++f) {
    ErrorTimeRow& row = table.rows.emplace_back();
    row.errors = {0, 0, 0};
    for (std::size_t i = 0; i < glosses.size(); ++i) {
      const Errors& e = errors[i][f];
      row.errors[0] += e.mean / glosses.size();
      if (i > 0) row.errors[1] += e.mean / (glosses.size() - 1);
      row.errors[2] = std::max(row.errors[2], e.max);
    }
  }
  return table;
}

ErrorTimeTable share_table(const PerGloss& errors) {
  ErrorTimeTable table;
  table.id = "share";
  table.title = "Share of the upper hemisphere";
  table.metrics = {{"rms", "rms error of the share", ""}, {"max", "largest error of the share", ""}};
  for (const double g : glosses)
    table.metrics.push_back({"rms_" + number(g, 3), "rms at g = " + number(g, 3), ""});
  for (std::size_t f = 0; f < forms.size(); ++f) {
    ErrorTimeRow& row = table.rows.emplace_back();
    row.errors = {0, 0};
    for (std::size_t i = 0; i < glosses.size(); ++i) {
      const Errors& e = errors[i][f];
      row.errors[0] += e.share_square / glosses.size();
      row.errors[1] = std::max(row.errors[1], e.share_max);
      row.errors.push_back(std::sqrt(e.share_square));
    }
    row.errors[0] = std::sqrt(row.errors[0]);
  }
  return table;
}

}  // namespace

ErrorTimeFamily hemisphere_family(const ReportOptions& options) {
  const int steps = options.full ? 240 : 120;
  const std::vector<Vec3> axes = make_axes(13, 5);
  PerGloss errors;
  for (std::size_t i = 0; i < glosses.size(); ++i) errors[i] = measure(glosses[i], axes, steps);

  ErrorTimeFamily family;
  family.id = "hemispheres";
  family.letter = "d";
  family.title = "Two-hemisphere specular";
  family.reference = "Schüler's CookTorranceSimplified integrated under two hemispheres of constant radiance";
  family.grid =
      "5 reflectances from 0.02 to 0.9, 6 glosses, 7 view cosines from 1 to 0.05, 13 tilts and 5 azimuths of the axis";
  family.tables = {albedo_table(errors), share_table(errors)};
  TimedSet timings;
  for (const Form& form : forms) timings.cases.push_back(timed(form));
  for (ErrorTimeTable& table : family.tables) {
    table.base = forms[0].id;
    timings.tables.push_back(table.id);
    for (std::size_t f = 0; f < forms.size(); ++f) {
      table.rows[f].id = forms[f].id;
      table.rows[f].title = forms[f].title;
    }
  }
  family.timed = {std::move(timings)};

  // The transition of a polished surface is so narrow that few axes meet it: many more axes are taken.
  const auto polished = measure(1, make_axes(37, 25), 120);
  const auto rms = [&](std::size_t form) { return number(std::sqrt(polished[form].share_square), 2); };
  family.advice =
      "Use the corrected form with the width 1.8 2^(-6 g): it halves the error of the share on polished surfaces (rms " +
      rms(1) + " at g = 1, where a step has " + rms(0) +
      ") and never divides by 1 - g; never use the printed one.";
  family.picks = {{"light of a sky and a ground", "share", "wide", "never divides by 1 - g"}};
  family.notes = {
      "As printed, F(g nv) makes rough surfaces white (water at g = 0, face on: " +
          number(value(forms[2], 0.02, 0, {1, 0}, 1), 3) + " against " +
          number(integrate(0, 1, axes, steps)[0].albedo, 2) +
          ") and the weight in [-1, 1] makes radiance negative below the horizon.",
      "The share of polished surfaces changes within a degree or two of the axis: its rms at g = 1 depends on where the few axes stand. Over 37 tilts and 25 azimuths it is " +
          rms(0) + " (corrected) and " + rms(1) +
          " (1.8 2^(-6 g)); over 13 tilts, azimuths every 22.5 to 90 degrees make it 0.002 to 0.043 and 0.023 to 0.026. Figures of other sets of axes agree in their order, not in their digits.",
      "Times are of the float formulas that shaders get, three channels, 4096 random inputs."};
  return family;
}

}  // namespace etak
