// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/exchange/targets/rgb_index.h"
#include "core/fresnel/fresnel.h"

namespace etak {

RgbIndex rgb_index(const ExportSurface& s) {
  const Vec3 f0 = vec(s.f0);
  Vec3 n{}, k{}, residual{};
  for (std::size_t c = 0; c < 3; ++c) {
    if (!s.f82) {
      n[c] = ior_of_f0(std::clamp(f0[c], 0.0, largest_dielectric_f0));
      residual[c] = std::abs(f64::f0(n[c], 0) - f0[c]);
      continue;
    }
    const double f82 = vec(*s.f82)[c];
    const SolvedIndex found = solve_index(f0[c], f82);
    n[c] = found.n;
    k[c] = found.k;
    residual[c] = std::max(std::abs(f64::f0(n[c], k[c]) - f0[c]),
                           std::abs(f64::fresnel_exact(n[c], k[c], f82_cosine) - f82));
  }
  return {to_rgb(n), to_rgb(k), to_rgb(residual)};
}

void note_residual(const TargetJob& j, const RgbIndex& index) {
  if (largest(index.residual) <= 1e-6) return;
  const auto reflected = [&](double c) {
    return LinearRgb{f64::fresnel_exact(index.n.r, index.k.r, c), f64::fresnel_exact(index.n.g, index.k.g, c),
                     f64::fresnel_exact(index.n.b, index.k.b, c)};
  };
  note_change(j.out.changes, "F0", list(j.s.f0), list(reflected(1)), "clamp",
              "no n and k reflect more than all");
  if (j.s.f82)
    note_change(j.out.changes, "F82", list(*j.s.f82), list(reflected(f82_cosine)), "nearest",
                "no n and k have this F0 and this edge");
}

namespace {

void write_rgb_nk(const TargetJob& j) {
  const RgbIndex index = rgb_index(j.s);
  j.add("n", index.n, plain_text);
  j.add("k", index.k, plain_text);
  j.add("residual", index.residual, plain_text);
  j.shows_conductor(index.n, index.k);
  j.note_no_transmission("a shader of conductors does not draw");
  j.note(j.s.f82 ? "n and k give F0 and F82 of each channel; residual is what they miss of the two"
                 : "without a known edge: k is 0 and n gives F0");
  note_residual(j, index);
}

}  // namespace

constinit const TargetRow target_rgb_nk{{.id = "rgb-nk",
                                         .title = "RGB n, k (conductor shaders)",
                                         .version = "any",
                                         .formula = "Fresnel's equations of each channel"},
                                        write_rgb_nk};

}  // namespace etak
