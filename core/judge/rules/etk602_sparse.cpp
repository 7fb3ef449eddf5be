// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

constexpr RuleParameter etk602_parameters[] = {
    {"min_samples", 10, 10, "", "in 380 to 780 nm"},
    {"max_gap", 30, 30, "nm", "between neighbouring samples"},
};

void etk602(RuleCheck& check) {
  const auto& material = check.evidence.material;
  if (!material) return;
  for (const SpectralRows& rows : material->datasets) {
    if (!rows.preferred || rows.is_formula || rows.wavelength_nm.empty()) continue;
    std::vector<double> inside;
    for (const double nm : rows.wavelength_nm)
      if (nm >= visible_first_nm && nm <= visible_last_nm) inside.push_back(nm);
    std::sort(inside.begin(), inside.end());
    double gap = 0;
    for (std::size_t i = 1; i < inside.size(); ++i) gap = std::max(gap, inside[i] - inside[i - 1]);
    const bool few = static_cast<double>(inside.size()) < check.parameter("min_samples");
    if (!few && gap <= check.parameter("max_gap")) continue;
    Finding& finding = check.report();
    finding.pointer = rows.pointer;
    finding.value = few ? std::to_string(inside.size()) + " samples" : "gap of " + number(gap, 3) + " nm";
    finding.limit = few ? number(check.parameter("min_samples"), 3) + " samples"
                        : number(check.parameter("max_gap"), 3) + " nm";
    finding.message = "dataset \"" + rows.id + "\" has " + std::to_string(inside.size()) +
                      " samples in 380 to 780 nm, largest gap " + number(gap, 3) + " nm";
  }
}

}  // namespace

constinit const Rule etk602_sparse{
    "ETK602",
    "sparse",
    "The spectrum has few samples",
    Severity::warning,
    Severity::error,
    {Need::material},
    etk602_parameters,
    "Public pages go down to 2 to 7 samples (etak)",
    "The preferred dataset has fewer than 10 samples in 380 to 780 nm, or a gap above 30 nm.",
    "Absorption bands between samples are lost.",
    "A table typed from a figure at seven wavelengths.",
    "Prefer a denser dataset.",
    &etk602};

}  // namespace etak
