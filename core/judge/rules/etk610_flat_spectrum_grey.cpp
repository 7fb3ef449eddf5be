// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"
#include "core/material/f0.h"

namespace etak {

constinit const Rule etk610_flat_spectrum_grey{
    .id = "ETK610",
    .slug = "flat-spectrum-grey",
    .title = "A flat spectrum is not grey",
    .severity = Severity::error,
    .needs = {Need::material},
    .source = "Filament's specular-color tool: blue 1.7 % low on a flat spectrum (etak)",
    .what = "Self-test of the arithmetic: a flat reflectance must give R = G = B to 1e-12.",
    .why = "White point and sums do not fit together, and every neutral metal gets a tint.",
    .example = "Sums at other wavelengths than those of the white.",
    .fix = "A mistake in etak: please report it.",
    .check = [](RuleCheck& check) {
      const auto& material = check.evidence.material;
      if (!material) return;
      static const double difference = [] {
        const F0Solver solver{F0Options{}};
        const F0Result f0 =
            solver.solve(Optics{Reflectance{Spectrum{{grid_first_nm, grid_last_nm}, {0.5, 0.5}}}});
        return std::max({f0.linear.r, f0.linear.g, f0.linear.b}) -
               std::min({f0.linear.r, f0.linear.g, f0.linear.b});
      }();
      if (difference <= 1e-12) return;
      Finding& finding = check.report();
      finding.value = number(difference, 2);
      finding.limit = "1e-12";
      finding.message = "a flat spectrum gives channels " + finding.value + " apart";
    }};

}  // namespace etak
