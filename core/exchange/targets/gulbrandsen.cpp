// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/exchange/targets/target.h"
#include "core/fresnel/fresnel.h"

namespace etak {
namespace {

void write_gulbrandsen(const TargetJob& j) {
  constexpr double most_r = 0.99;
  const LinearRgb r = fitted(j.s.f0, j.fit, most_r, j.s.space, "reflectivity",
                             "n and k are undefined at 1 and above", j.out.changes);
  LinearRgb g{0, 0, 0};
  if (j.s.f82) {
    const Vec3 f0 = vec(r), f82 = vec(*j.s.f82);
    Vec3 edge{}, seen{};
    for (std::size_t c = 0; c < 3; ++c) {
      const SolvedIndex index = solve_index(f0[c], f82[c]);
      const double root = std::sqrt(f0[c]);
      const double most = (1 + root) / (1 - root), least = (1 - f0[c]) / (1 + f0[c]);
      edge[c] = most > least ? std::clamp((most - index.n) / (most - least), 0.0, 1.0) : 0;
      // The form ends at the n of the largest k; an edge above that of it is out of its reach.
      seen[c] = index.n < least ? f64::fresnel_exact(least, 2 * root / (1 + f0[c]), f82_cosine)
                                : f64::fresnel_exact(index.n, index.k, f82_cosine);
    }
    g = to_rgb(edge);
    note_change(j.out.changes, "F82", list(*j.s.f82), {seen[0], seen[1], seen[2]}, "nearest",
                "no edge colour gives this F82 with this reflectivity");
  }
  j.note_no_transmission("a shader of conductors does not draw");
  j.add("reflectivity", r, plain_text);
  j.add("edge_color", g, plain_text);
}

}  // namespace

constinit const TargetRow target_gulbrandsen{{"gulbrandsen", "Gulbrandsen (MaterialX artistic_ior)"},
                                             write_gulbrandsen};

}  // namespace etak
