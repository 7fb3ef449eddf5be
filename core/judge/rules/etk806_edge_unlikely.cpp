// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "core/fresnel/fresnel.h"
#include "core/judge/rules/surface_check.h"

namespace etak {

namespace {

// How far the nearest n and k are from an F82, in the worst channel.
double missed(const LinearRgb& f0, const LinearRgb& f82) {
  double worst = 0;
  const auto a = vec(f0), b = vec(f82);
  for (std::size_t c = 0; c < 3; ++c) {
    const double r = std::clamp(a[c], 0.0, 0.999);
    const SolvedIndex index = solve_index(r, std::clamp(b[c], 0.0, 1.0));
    worst = std::max(worst, std::abs(f64::fresnel_exact(index.n, index.k, f82_cosine) - b[c]));
  }
  return worst;
}

}  // namespace

constinit const Rule etk806_edge_unlikely{
    .id = "ETK806",
    .slug = "edge-unlikely",
    .title = "An edge colour that no metal of that F0 has",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::material},
    .parameters = {{"miss", 0.05, 0.05, "", "of F82, up to which n and k that give F0 count as giving it"},
                   {"distance", 12, 12, "dE2000", "between F82 and that of the measured metal that F0 is"}},
    .source = "Fresnel's equations; Hoffman 2019 and Kutz 2021 (F82 tint)",
    .what =
        "A metal states its edge (F82, F82 tint, edge colour), and no n and k give that reflectance at cos 1/7 together with its F0, by more than 0.05 in a channel; or its F0 is within 3 dE of a measured metal whose F82 is more than 12 dE away.",
    .why = "F0 and F82 come from one n and k: most metals are nearly white at the edge.",
    .example = "specular_color holds F0 once more, where it is the tint of the edge.",
    .fix = "Leave the tint at white, or take it from etak export NAME --to openpbr.",
    .check = [](RuleCheck& check) {
      for_each_surface(check, [&](const DocumentSurface& surface, const DocumentValues& values) {
        if (!values.f0 || !values.f82 || values.edge_from == nullptr) return;
        const KnownMaterials& known = known_materials(check.settings);
        if (is_what_it_is_called(known, surface, *values.f0)) return;
        const double miss = missed(*values.f0, *values.f82);
        const Measured nearest = nearest_measured(known, *values.f0, SurfaceSort::metal);
        double off = 0;
        if (nearest.entry != nullptr && nearest.entry->metal && nearest.entry->f82 && nearest.delta_e <= 3) {
          KnownF0 edge = *nearest.entry;
          edge.linear = {edge.f82->r, edge.f82->g, edge.f82->b};
          off = delta_e_of({values.f82->r, values.f82->g, values.f82->b}, edge);
        }
        if (miss <= check.parameter("miss") && off <= check.parameter("distance")) return;
        const std::string what = "F82 " + numbers_text({values.f82->r, values.f82->g, values.f82->b}) +
                                 (miss > check.parameter("miss")
                                      ? ", which n and k that give F0 miss by " + number(miss, 2)
                                      : ", " + number(off, 2) + " dE from that of " + nearest.entry->id);
        report_surface(check, surface, values, values.edge_from, what);
      });
    }};

}  // namespace etak
