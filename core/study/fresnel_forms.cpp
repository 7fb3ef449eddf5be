// SPDX-License-Identifier: Apache-2.0
#include "core/study/fresnel_forms.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/color/delta_e.h"
#include "core/fresnel/fresnel.h"
#include "core/math/functions.h"
#include "core/render/scene.h"

namespace etak {
namespace {

namespace in_double {
#include "core/math/real_f64.h"

#include "core/fresnel/texts.h"

#include "core/study/fresnel_forms.inc"
}  // namespace in_double

namespace in_single {
#include "core/math/real_f32.h"

#include "core/fresnel/texts.h"

#include "core/study/fresnel_forms.inc"
}  // namespace in_single

constexpr std::array<double, 3> channel_nm{611.4, 549.1, 464.3};

// ---- fits: the numbers that a renderer is given for each channel

FresnelValues per_channel(const FresnelTruth& truth, ChannelValues (*fit)(const FresnelTruth&, std::size_t)) {
  FresnelValues out{};
  for (std::size_t c = 0; c < 3; ++c) out[c] = fit(truth, c);
  return out;
}

FresnelValues fit_f0(const FresnelTruth& truth) {
  return per_channel(truth, [](const FresnelTruth& t, std::size_t c) -> ChannelValues { return {t.f0[c]}; });
}

FresnelValues fit_f82(const FresnelTruth& truth) {
  return per_channel(truth, [](const FresnelTruth& t, std::size_t c) -> ChannelValues {
    return {t.f0[c], t.f82[c]};
  });
}

// Authors give F0 and tint in [0, 1], so both are clamped.
FresnelValues fit_f82_tint(const FresnelTruth& truth) {
  return per_channel(truth, [](const FresnelTruth& t, std::size_t c) -> ChannelValues {
    const double f0 = std::clamp(t.f0[c], 0.0, 1.0);
    return {f0, std::clamp(t.f82[c] / f64::f_schlick(t.f0[c], f82_cosine), 0.0, 1.0)};
  });
}

FresnelValues fit_index(const FresnelTruth& truth) {
  SurfaceValues surface;
  surface.f0 = truth.f0;
  surface.f82 = truth.f82;
  solve_index(surface);
  FresnelValues out{};
  for (std::size_t c = 0; c < 3; ++c) out[c] = {surface.n[c], surface.k[c]};
  return out;
}

FresnelValues fit_mean_index(const FresnelTruth& truth) {
  return per_channel(truth, [](const FresnelTruth& t, std::size_t c) -> ChannelValues {
    return {t.mean_index[0][c], std::max(0.0, t.mean_index[1][c])};
  });
}

FresnelValues fit_three(const FresnelTruth& truth) {
  return per_channel(truth, [](const FresnelTruth& t, std::size_t c) -> ChannelValues {
    return {t.three_wavelengths[0][c], t.three_wavelengths[1][c]};
  });
}

// F between the angles of the truth, which are even.
FresnelValues fit_curve(const FresnelTruth& truth) {
  const double last = static_cast<double>(truth.rgb.size() - 1);
  const FresnelCurve curve = fitted_curve([&](double cosine) {
    const double place = last * math::acos(std::min(cosine, 1.0)) / (std::numbers::pi / 2);
    const auto at = std::min(static_cast<std::size_t>(place), truth.rgb.size() - 2);
    Vec3 out{};
    for (std::size_t c = 0; c < 3; ++c)
      out[c] = std::lerp(truth.rgb[at][c], truth.rgb[at + 1][c], place - static_cast<double>(at));
    return out;
  });
  FresnelValues out{};
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < FresnelCurve::count; ++i) out[c][i] = curve.colors[i][c];
  return out;
}

// Sum of squared errors of one channel, with equal weights for all angles. With the weights of a sphere,
// grazing angles would hardly count, where the errors are largest.
template <class Value>
double squared_error(const FresnelTruth& truth, std::size_t channel, Value value) {
  double sum = 0;
  for (std::size_t i = 0; i < truth.cosine.size(); ++i) {
    const double error = value(truth.cosine[i]) - truth.rgb[i][channel];
    sum += error * error;
  }
  return sum;
}

// The place in [low, high] where a function that falls once and then rises is least, by golden sections.
template <class F>
double least_of(double low, double high, F f) {
  constexpr double golden = 0.6180339887498949;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double fa = f(a), fb = f(b);
  for (int step = 0; step < 60; ++step) {
    if (fa < fb) {
      high = b, b = a, fb = fa;
      fa = f(a = high - golden * (high - low));
    } else {
      low = a, a = b, fa = fb;
      fb = f(b = low + golden * (high - low));
    }
  }
  return (low + high) / 2;
}

FresnelValues fit_gulbrandsen(const FresnelTruth& truth) {
  return per_channel(truth, [](const FresnelTruth& t, std::size_t c) -> ChannelValues {
    const double r = t.f0[c];
    const double g = least_of(0, 1, [&](double edge) {
      return squared_error(t, c, [&](double cosine) { return in_double::f_gulbrandsen(r, edge, cosine); });
    });
    return {r, g};
  });
}

// n and k are those of F0 and F82. The dip a c (1 - c)^alpha is fitted by least squares: a follows from a
// linear equation, alpha is searched.
FresnelValues fit_lazanyi(const FresnelTruth& truth) {
  FresnelValues out = fit_index(truth);
  for (std::size_t c = 0; c < 3; ++c) {
    const double n = out[c][0], k = out[c][1];
    const auto best_a = [&](double alpha) {
      double over = 0, under = 0;
      for (std::size_t i = 0; i < truth.cosine.size(); ++i) {
        const double cosine = truth.cosine[i], m = 1 - cosine;
        const double dip = cosine * math::pow(std::max(m, 0.0), alpha);
        over += dip * (in_double::f_lazanyi(n, k, 0, alpha, cosine) - truth.rgb[i][c]);
        under += dip * dip;
      }
      return under > 0 ? over / under : 0.0;
    };
    const double alpha = least_of(0.5, 20, [&](double candidate) {
      const double a = best_a(candidate);
      return squared_error(truth, c,
                           [&](double cosine) { return in_double::f_lazanyi(n, k, a, candidate, cosine); });
    });
    out[c] = {n, k, best_a(alpha), alpha};
  }
  return out;
}

// ---- the forms

template <float (*F)(const float*, float)>
void many(const float* p, const float* c, float* out, std::size_t count) {
  std::array<float, most_form_numbers> own{};  // `out` cannot alias a copy: it stays in registers
  std::copy_n(p, own.size(), own.begin());
  for (std::size_t i = 0; i < count; ++i) out[i] = F(own.data(), c[i]);
}

#define ETAK_ROW(id, title, physical, fit) \
  { #id, title, physical, fit, in_double::form_##id, many < in_single::form_##id> }
constexpr FresnelForm rows[] = {
    ETAK_ROW(schlick, "Schlick", true, fit_f0),
    ETAK_ROW(schueler, "Schüler, 4th power", true, fit_f0),
    ETAK_ROW(spherical_gaussian, "spherical Gaussian", true, fit_f0),
    ETAK_ROW(f82, "F82", true, fit_f82),
    ETAK_ROW(f82_tint, "F82 tint, clamped", true, fit_f82_tint),
    ETAK_ROW(lazanyi, "Lazányi, fitted", true, fit_lazanyi),
    ETAK_ROW(gulbrandsen, "Gulbrandsen, fitted", true, fit_gulbrandsen),
    ETAK_ROW(from_f0, "exact, n from F0", true, fit_f0),
    ETAK_ROW(by_f0, "exact below F0 of 0.2, Schlick above", true, fit_f0),
    ETAK_ROW(index, "exact, n and k from F0 and F82", true, fit_index),
    ETAK_ROW(mean_index, "exact, averaged n and k", true, fit_mean_index),
    ETAK_ROW(three_wavelengths, "exact, n and k at 611, 549, 464 nm", true, fit_three),
    ETAK_ROW(curve, "curve of 16 colours", true, fit_curve),
    ETAK_ROW(hidden, "K / (l h) of Optimized", false, fit_f0),
};
#undef ETAK_ROW

}  // namespace

std::array<float, most_form_numbers> single_values(const ChannelValues& values) {
  std::array<float, most_form_numbers> out{};
  std::ranges::transform(values, out.begin(), [](double each) { return static_cast<float>(each); });
  return out;
}

std::span<const FresnelForm> fresnel_forms() {
  return rows;
}

const FresnelForm* fresnel_form(std::string_view id) {
  for (const FresnelForm& form : rows)
    if (form.id == id) return &form;
  return nullptr;
}

FresnelTruth fresnel_truth(const std::function<Vec3(double)>& seen, double step_deg) {
  FresnelTruth truth;
  const auto steps = static_cast<std::size_t>(std::lround(90 / step_deg));
  double sum = 0;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double angle = std::numbers::pi / 2 * static_cast<double>(i) / static_cast<double>(steps);
    truth.cosine.push_back(i == steps ? 0 : math::cos(angle));
    truth.weight.push_back(math::sin(angle) * truth.cosine.back());
    sum += truth.weight.back();
    truth.rgb.push_back(seen(truth.cosine.back()));
  }
  for (double& weight : truth.weight) weight /= sum;
  truth.f0 = truth.rgb.front();
  truth.f82 = seen(f82_cosine);
  return truth;
}

FresnelTruth fresnel_truth(const Optics& optics, std::string_view what, double step_deg,
                           const F0Options& seen_under) {
  const SeenStack seen(optics, seen_under, Method::nm1, what);
  FresnelTruth truth = fresnel_truth(std::cref(seen), step_deg);
  const auto [n, k] = seen.bare_index();
  if (n.empty()) return truth;
  truth.mean_index = {seen.seen(n), seen.seen(k)};
  for (std::size_t c = 0; c < 3; ++c) {
    const double place = channel_nm[c] - grid_first_nm;
    const auto at = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(at);
    truth.three_wavelengths[0][c] = std::lerp(n[at], n[at + 1], share);
    truth.three_wavelengths[1][c] = std::lerp(k[at], k[at + 1], share);
  }
  return truth;
}

FresnelError fresnel_error(const FresnelTruth& truth, const FresnelForm& form, const FresnelValues& values) {
  FresnelError error;
  double weight = 0;
  Vec3 means{};
  for (std::size_t i = 0; i < truth.cosine.size(); ++i) {
    Vec3 rgb{};
    for (std::size_t c = 0; c < 3; ++c) {
      rgb[c] = form.value(values[c].data(), truth.cosine[i]);
      const double miss = std::abs(rgb[c] - truth.rgb[i][c]);
      means[c] += truth.weight[i] * miss;
      if (!(miss <= error.max_abs)) {
        error.max_abs = miss;
        error.at_deg = math::acos(truth.cosine[i]) * 180 / std::numbers::pi;
      }
    }
    const double de = delta_e2000(to_lab(to_rgb(rgb)), to_lab(to_rgb(truth.rgb[i])));
    error.max_de = std::max(error.max_de, de);
    error.mean_de += truth.weight[i] * de;
    weight += truth.weight[i];
  }
  error.mean_abs = std::max({means[0], means[1], means[2]});
  error.mean_de /= weight;
  return error;
}

}  // namespace etak
