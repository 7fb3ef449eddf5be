// SPDX-License-Identifier: Apache-2.0
// Based on:
//   Gulbrandsen 2014, "Artist Friendly Metallic Fresnel": for one F0 the possible n lie between (1 - r)/(1 +
//   r) and (1 + sqrt r)/(1 - sqrt r), and each has its k
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/fresnel/fresnel.h"
#include "core/material/dispersion.h"
#include "core/material/f0.h"
#include "core/render/optics_grid.h"
#include "core/render/scene.h"
#include "core/spectrum/interpolate.h"

namespace etak {
namespace {

// A colour's F0 may pass 1 (gold in sRGB), no n and k do: n would leave its domain.
constexpr double largest_f0 = 0.9999;
constexpr double smallest_f0 = 0;
// About where red, green and blue of sRGB have their weight; they choose between two solutions, no more.
constexpr std::array<double, 3> channel_nm{611, 549, 464};

struct Index {
  double n, k;
};

// The k that gives reflectance r at normal incidence together with n.
double k_of(double r, double n) {
  return std::sqrt(std::max(0.0, (r * (n + 1) * (n + 1) - (n - 1) * (n - 1)) / (1 - r)));
}

// n and k with f0 and f82 of one channel, by bisection in log n. F82 falls and rises again along the possible
// n, so there are up to two solutions, and sometimes none: then the n nearest to one. `hint` chooses between
// two.
Index solve(double f0, double f82, double hint) {
  // Above 1 the nearest F0 that a metal of this edge has is a little below the edge's.
  const double r = f0 < largest_f0 ? std::max(f0, smallest_f0) : std::clamp(f82, 0.5, largest_f0);
  const double root = std::sqrt(r);
  const double least = std::log((1 - r) / (1 + r)), most = std::log((1 + root) / (1 - root));
  const auto missed = [&](double log_n) {
    const double n = std::exp(log_n);
    return f64::fresnel_exact(n, k_of(r, n), f82_cosine) - f82;
  };
  constexpr int steps = 256;
  const auto node = [&](int i) { return least + (most - least) * i / steps; };
  double best = least, best_miss = std::abs(missed(least));
  bool best_is_root = false;
  // A root beats any other n; of two roots the one nearer to the hint, of two others the one that misses
  // less.
  const auto offer = [&](double log_n, bool is_root) {
    const double miss = std::abs(missed(log_n));
    const bool nearer = std::abs(log_n - hint) < std::abs(best - hint);
    if (is_root ? !best_is_root || nearer : !best_is_root && miss < best_miss) {
      best = log_n;
      best_miss = miss;
      best_is_root = is_root;
    }
  };
  double before = missed(node(0));
  for (int i = 1; i <= steps; ++i) {
    const double after = missed(node(i));
    offer(node(i), after == 0);
    if (before * after < 0) {
      double low = node(i - 1), high = node(i);
      for (int step = 0; step < 60; ++step) {
        const double middle = (low + high) / 2;
        (missed(middle) * before > 0 ? low : high) = middle;
      }
      offer((low + high) / 2, true);
    }
    before = after;
  }
  if (!best_is_root) {
    // The least miss lies within a step of the best node.
    double low = std::max(least, best - (most - least) / steps),
           high = std::min(most, best + (most - least) / steps);
    for (int step = 0; step < 60; ++step) {
      const double third = (high - low) / 3;
      if (std::abs(missed(low + third)) < std::abs(missed(high - third)))
        high -= third;
      else
        low += third;
    }
    offer((low + high) / 2, false);
  }
  const double n = std::exp(best);
  return {n, k_of(r, n)};
}

Vec3 log_n_hint(const OpticalConstants& optics, std::string_view what) {
  const GridIndex index = grid_index(optics, what);
  Vec3 out{};
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = std::log(index.n[static_cast<std::size_t>(channel_nm[c] - grid_first_nm)]);
  return out;
}

}  // namespace

GridIndex grid_index(const OpticalConstants& optics, std::string_view what) {
  GridIndex out;
  if (const auto* formula = std::get_if<DispersionFormula>(&optics.n)) {
    std::array<double, grid_size> at_nm{};
    for (std::size_t i = 0; i < grid_size; ++i) at_nm[i] = grid_first_nm + static_cast<double>(i);
    evaluate(*formula, at_nm, out.n);
  } else {
    resample_to_grid(std::get<Spectrum>(optics.n), out.n);
  }
  if (optics.k) resample_to_grid(*optics.k, out.k);
  for (std::size_t i = 0; i < grid_size; ++i)
    if (!(out.n[i] > 0))
      throw Error::at(
          what,
          "n = " + number(out.n[i], 6) + " at " + std::to_string(grid_first_nm + static_cast<int>(i)) + " nm",
          "n above 0");
  return out;
}

void solve_index(SurfaceValues& surface, const Vec3& log_n_hints) {
  for (std::size_t c = 0; c < 3; ++c) {
    const Index found = solve(surface.f0[c], surface.f82[c], log_n_hints[c]);
    surface.n[c] = found.n;
    surface.k[c] = found.k;
    surface.nk_residual[c] =
        std::max(std::abs(f64::f0(found.n, found.k) - surface.f0[c]),
                 std::abs(f64::fresnel_exact(found.n, found.k, f82_cosine) - surface.f82[c]));
  }
}

SurfaceValues surface_of(const Material& material, const Dataset& dataset, const Vec3& diffuse,
                         double gloss) {
  const F0Solver solver{F0Options{}};
  const F0Result result = solver.solve(dataset.optics, dataset.flags);
  const std::string what = material.id + "/" + dataset.id;
  if (result.refused()) throw Error::at(what, "has no F0: " + result.refusal, "data over the visible range");
  const std::string_view kind = optical_kind(material.material_class);
  SurfaceValues out;
  out.gloss = gloss;
  const auto schlick82 = [](double f0) { return f64::f_schlick(f0, f82_cosine); };
  if (kind == "surface") {
    // A measured reflectance of paint or cloth is the body's colour; its surface is that of any plastic.
    out.diffuse = vec(result.srgb_linear);
  } else {
    out.f0 = vec(result.srgb_linear);
    if (kind == "dielectric") out.diffuse = diffuse;
  }
  Vec3 hint{};
  if (const auto* constants = std::get_if<OpticalConstants>(&dataset.optics); constants && result.f82) {
    out.f82 = vec(*result.f82);
    out.optics = *constants;
    hint = log_n_hint(*constants, what);
  } else {
    for (std::size_t c = 0; c < 3; ++c) {
      out.f82[c] = schlick82(out.f0[c]);
      // Without k known: a dielectric below the forbidden zone, else a metal.
      const double root = std::sqrt(std::clamp(out.f0[c], smallest_f0, largest_f0));
      hint[c] = out.f0[c] < 0.2 ? std::log((1 + root) / (1 - root)) : -1;
    }
  }
  solve_index(out, hint);
  return out;
}

}  // namespace etak
