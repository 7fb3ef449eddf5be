// SPDX-License-Identifier: Apache-2.0
#include "core/study/angle_curves.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>

#include "core/fresnel/fresnel.h"
#include "core/math/functions.h"
#include "core/study/measure.h"

namespace etak {
namespace {

constexpr std::array<std::string_view, 5> shown{"schlick", "schueler", "f82", "f82_tint", "lazanyi"};
constexpr std::array<std::string_view, 4> without_index{"schlick", "schueler", "f82", "f82_tint"};
constexpr std::array<std::string_view, 2> of_f0{"schlick", "schueler"};

AngleCurve curve_of(const FresnelForm& form, const FresnelTruth& truth, const FresnelValues& values,
                    bool exact) {
  AngleCurve out{form.id, form.title, {}, {}, 0};
  for (const double cosine : truth.cosine) {
    Vec3 rgb{};
    for (std::size_t c = 0; c < 3; ++c) rgb[c] = form.value(values[c].data(), cosine);
    out.rgb.push_back(rgb);
  }
  if (exact) out.error = fresnel_error(truth, form, values);
  return out;
}

// Nanoseconds of one call of each body: the median over rounds, in which all bodies are called in turn.
std::vector<double> median_ns(const std::vector<std::function<void()>>& bodies) {
  constexpr int rounds = 15;
  std::vector<std::vector<double>> times(bodies.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const auto begin = std::chrono::steady_clock::now();
      bodies[i]();
      times[i].push_back(
          std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count());
    }
  std::vector<double> out;
  for (auto& each : times) {
    std::nth_element(each.begin(), each.begin() + rounds / 2, each.end());
    out.push_back(each[rounds / 2]);
  }
  return out;
}

}  // namespace

AngleCurves angle_curves(const Optics& optics, const F0Options& options, std::string_view what,
                         double step_deg) {
  AngleCurves out;
  FresnelTruth truth;
  const bool exact = !std::holds_alternative<Reflectance>(optics);
  if (exact) {
    truth = fresnel_truth(optics, what, step_deg, options);
    out.exact = truth.rgb;
  } else {
    const F0Result result = F0Solver(options).solve(optics);
    if (result.refused()) return out;
    // Reflectance data do not tell F at other angles.
    truth = fresnel_truth([&](double) { return vec(result.srgb_linear); }, step_deg);
  }
  for (const double cosine : truth.cosine)
    out.angle_deg.push_back(math::acos(cosine) * 180 / std::numbers::pi);
  const auto add = [&](std::string_view id) {
    const FresnelForm& form = *fresnel_form(id);
    out.forms.push_back(curve_of(form, truth, form.fit(truth), exact));
  };
  using Ids = std::span<const std::string_view>;
  for (const std::string_view id : !exact                                  ? Ids(of_f0)
                                   : std::holds_alternative<Stack>(optics) ? Ids(without_index)
                                                                           : Ids(shown))
    add(id);
  return out;
}

void time_angle_curves(AngleCurves& curves) {
  constexpr std::size_t count = 4096, spectra = 64;
  const auto cosines = random_floats(count, 0, 1);
  // Values of an ordinary metal.
  const std::array<float, most_form_numbers> values{0.7f, 0.75f, 0.1f, 5.0f};
  std::vector<float> floats(count);
  std::vector<std::function<void()>> bodies;
  for (const AngleCurve& curve : curves.forms)
    bodies.emplace_back([form = fresnel_form(curve.id), &values, &cosines, &floats] {
      form->many(values.data(), cosines->data(), floats.data(), count);
      keep(floats.data());
    });
  const Quadrature quadrature = make_quadrature(Method::nm1, {});
  std::array<double, grid_size> n{}, k{}, reflectance{};
  n.fill(0.6);
  k.fill(2.5);
  if (!curves.exact.empty())
    bodies.emplace_back([&] {
      double sum = 0;
      for (std::size_t i = 0; i < spectra; ++i) {
        f64::fresnel_exact(n, k, double{(*cosines)[i]}, reflectance);
        sum += quadrature.integrate(reflectance)[1];
      }
      keep(&sum);
    });
  const std::vector<double> ns = median_ns(bodies);
  for (std::size_t i = 0; i < curves.forms.size(); ++i)
    curves.forms[i].ns = ns[i] / static_cast<double>(count);
  if (!curves.exact.empty()) curves.exact_ns = ns.back() / static_cast<double>(spectra);
}

}  // namespace etak
