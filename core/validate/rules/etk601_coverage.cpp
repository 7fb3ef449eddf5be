// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/number.h"
#include "core/spectrum/integration.h"
#include "core/validate/rules/rows.h"
#include "core/validate/rules/spectral.h"

namespace etak {

namespace {

void check(RuleCheck& check) {
  const auto& material = check.evidence.material;
  if (!material) return;
  for (const SpectralRows& rows : material->datasets) {
    const double first = first_nm(rows), last = last_nm(rows);
    if (first <= 0 || (first <= 380 && last >= 780)) continue;
    const bool core = first <= 400 && last >= 700;
    const double missing = 1 - weight_inside(Viewing{}, first, last)[1];
    Finding& finding = check.report();
    finding.pointer = rows.pointer;
    if (core) finding.severity = check.at_most(Severity::warning);
    finding.value = number(first, 5) + " to " + number(last, 5) + " nm";
    finding.limit = core ? "380 to 780 nm" : "400 to 700 nm";
    finding.message = "dataset \"" + rows.id + "\" covers " + finding.value + "; " +
                      percent(std::max(0.0, missing)) + " of the luminous weight is outside";
  }
}

}  // namespace

constinit const Rule etk601_coverage{
    "ETK601",
    "coverage",
    "The spectrum does not cover the visible range",
    Severity::error,
    Severity::error,
    {Need::material},
    {},
    "8 of 147 pages of refractiveindex.info fall short; Filament's tool takes short data in "
    "silence (etak)",
    "The data do not cover 400 to 700 nm (error), or not 380 to 780 nm (warning, with the "
    "share of the luminous weight that is missing).",
    "What is not there is guessed by holding the end values.",
    "An infrared measurement used for a colour.",
    "Use another dataset, or complete the table.",
    &check};

}  // namespace etak
