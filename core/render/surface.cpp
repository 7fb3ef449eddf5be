// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/color/luminance.h"
#include "core/fresnel/fresnel.h"
#include "core/material/appearance.h"
#include "core/material/f0.h"
#include "core/material/seen_stack.h"
#include "core/math/functions.h"
#include "core/render/scene.h"
#include "core/spectrum/interpolate.h"

namespace etak {
namespace {

// Beer's law for each channel, from the depth for which the colour is known to the diameter of the ball.
Vec3 passing_of(const ClearBody& body) {
  constexpr double least = 1e-6;
  Vec3 out = vec(body.color);
  for (double& each : out)
    each = body.depth_m > 0
               ? std::clamp(math::pow(std::max(each, least), clear_ball_m / body.depth_m), least, 1.0)
               : 1;
  return out;
}

}  // namespace

void solve_index(SurfaceValues& surface) {
  for (std::size_t c = 0; c < 3; ++c) {
    const SolvedIndex found = solve_index(surface.f0[c], surface.f82[c]);
    surface.n[c] = found.n;
    surface.k[c] = found.k;
    surface.nk_residual[c] =
        std::max(std::abs(f64::f0(found.n, found.k) - surface.f0[c]),
                 std::abs(f64::fresnel_exact(found.n, found.k, f82_cosine) - surface.f82[c]));
  }
}

SurfaceValues surface_of(const Material& material, const Dataset& dataset, const Vec3& diffuse,
                         const Gloss& gloss) {
  static const F0Solver solver{F0Options{}};
  return surface_of(material, dataset, solver.solve(dataset.optics, dataset.flags), diffuse, gloss);
}

SurfaceValues surface_of(const Material& material, const Dataset& dataset, const F0Result& result,
                         const Vec3& diffuse, const Gloss& gloss, const F0Options& options) {
  const std::string what = material.id + "/" + dataset.id;
  if (result.refused()) throw Error::at(what, "has no F0: " + result.refusal, "data over the visible range");
  const std::string_view kind = optical_kind(material.material_class);
  SurfaceValues out;
  out.gloss = gloss;
  if (kind == "surface") {
    // The measured reflectance of paint or cloth is the sum of that of the body and that of a surface like
    // plastic.
    const TotalReflectance parts = divided(result.srgb_linear);
    out.diffuse = vec(parts.diffuse);
    out.f0 = vec(parts.f0);
  } else {
    out.f0 = vec(result.srgb_linear);
    if (kind == "dielectric") out.diffuse = diffuse;
  }
  if (const auto* constants = std::get_if<OpticalConstants>(&dataset.optics); constants && result.f82)
    out.optics = *constants;
  for (std::size_t c = 0; c < 3; ++c)
    out.f82[c] = result.f82 ? vec(*result.f82)[c] : f64::f_schlick(out.f0[c], f82_cosine);
  solve_index(out);
  std::optional<ClearBody> body;
  if (diffuse == Vec3{0, 0, 0}) body = clear_body(material, dataset);
  if (body) out.passing = passing_of(*body);
  const auto* stack = std::get_if<Stack>(&dataset.optics);
  if (stack == nullptr) return out;
  out.optics = *stack;
  const SeenStack seen(*stack, options);
  out.curve = fitted_curve(std::cref(seen));
  if (body)
    out.layers = {
        body->n_d.value_or(1.5) / seen.spectra().outside[588 - grid_first_nm],  // helium's yellow line
        fitted_curve([&](double c) { return seen.passed_twice(c); })};
  return out;
}

double unseen_luminance(const SurfaceValues& surface) {
  if (!surface.layers) return luminance_of(surface.f0);
  return 1 - std::sqrt(std::clamp(luminance_of(surface.layers->twice.at(1)), 0.0, 1.0));
}

FresnelCurve curve_of(const SurfaceValues& surface) {
  if (surface.curve) return *surface.curve;
  if (surface.optics) {
    const SeenStack seen(*surface.optics);
    return fitted_curve(std::cref(seen));
  }
  return fitted_curve([&](double cosine) {
    Vec3 out{};
    for (std::size_t c = 0; c < 3; ++c) out[c] = f64::fresnel_exact(surface.n[c], surface.k[c], cosine);
    return out;
  });
}

std::string curve_note(const FresnelCurve& curve) {
  return "F of the layers is drawn as a curve of " + std::to_string(FresnelCurve::count) +
         " colours over the angle, off by at most " + number(curve.off.de2000, 2) + " (CIEDE2000), at " +
         number(curve.off.at_deg, 3) + " degrees";
}

void complete_from_f0(SurfaceValues& surface) {
  for (std::size_t c = 0; c < 3; ++c) {
    const double root = std::sqrt(std::clamp(surface.f0[c], 0.0, 0.9999)), clear_n = (1 + root) / (1 - root);
    surface.f82[c] = surface.f0[c] < forbidden_zone_first ? f64::fresnel_exact(clear_n, 0, f82_cosine)
                                                          : f64::f_schlick(surface.f0[c], f82_cosine);
  }
  solve_index(surface);
}

}  // namespace etak
