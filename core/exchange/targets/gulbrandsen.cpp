// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/exchange/targets/target.h"
#include "core/fresnel/fresnel.h"

namespace etak {

ArtisticIndex artistic_index(const TargetJob& j, const char* field) {
  constexpr double most_r = 0.99;
  ArtisticIndex out;
  out.reflectivity = fitted(j.s.f0, {j.fit, most_r, j.s.space}, field, "n and k are undefined at 1 and above",
                            j.out.changes);
  const Vec3 f0 = vec(out.reflectivity);
  Vec3 edge{}, n{}, k{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double root = std::sqrt(std::max(f0[c], 0.0));
    const double most = (1 + root) / (1 - root), least = (1 - f0[c]) / (1 + f0[c]);
    if (j.s.f82 && most > least) {
      const SolvedIndex index = solve_index(f0[c], vec(*j.s.f82)[c]);
      edge[c] = std::clamp((most - index.n) / (most - least), 0.0, 1.0);
    }
    n[c] = edge[c] * least + (1 - edge[c]) * most;
    k[c] =
        std::sqrt(std::max((f0[c] * (n[c] + 1) * (n[c] + 1) - (n[c] - 1) * (n[c] - 1)) / (1 - f0[c]), 0.0));
  }
  out.edge_color = to_rgb(edge);
  out.n = to_rgb(n);
  out.k = to_rgb(k);
  if (j.s.f82) {
    Vec3 seen{};
    for (std::size_t c = 0; c < 3; ++c) seen[c] = f64::fresnel_exact(n[c], k[c], f82_cosine);
    note_change(j.out.changes, "F82", list(*j.s.f82), {seen[0], seen[1], seen[2]}, "nearest",
                "no edge colour gives this F82 with this reflectivity");
  }
  return out;
}

namespace {

void write_gulbrandsen(const TargetJob& j) {
  const ArtisticIndex index = artistic_index(j, "reflectivity");
  j.shows_conductor(index.n, index.k);
  j.note_no_transmission("a shader of conductors does not draw");
  j.add("reflectivity", index.reflectivity, plain_text);
  j.add("edge_color", index.edge_color, plain_text);
}

}  // namespace

constinit const TargetRow target_gulbrandsen{
    {.id = "gulbrandsen",
     .title = "Gulbrandsen (MaterialX artistic_ior)",
     .version = "JCGT 3(4), 2014",
     .formula = "Fresnel's equations with the n and k that the two colours stand for"},
    write_gulbrandsen};

}  // namespace etak
