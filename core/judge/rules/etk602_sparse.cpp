// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk602_sparse{
    .id = "ETK602",
    .slug = "sparse",
    .title = "The spectrum has few samples",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::material},
    .parameters = {{"min_samples", 10, 10, "", "in 380 to 780 nm"},
                   {"max_gap", 30, 30, "nm", "between neighbouring samples"}},
    .source = "Public pages go down to 2 to 7 samples (etak)",
    .what = "The preferred dataset has fewer than 10 samples in 380 to 780 nm, or a gap above 30 nm.",
    .why = "Absorption bands between samples are lost.",
    .example = "A table typed from a figure at seven wavelengths.",
    .fix = "Prefer a denser dataset.",
    .check = [](RuleCheck& check) {
      for (const SpectralRows& rows : check.datasets()) {
        if (!rows.preferred || rows.is_formula || rows.wavelength_nm.empty()) continue;
        std::vector<double> inside;
        for (const double nm : rows.wavelength_nm)
          if (nm >= visible_first_nm && nm <= visible_last_nm) inside.push_back(nm);
        std::sort(inside.begin(), inside.end());
        double gap = 0;
        for (std::size_t i = 1; i < inside.size(); ++i) gap = std::max(gap, inside[i] - inside[i - 1]);
        const bool few = static_cast<double>(inside.size()) < check.parameter("min_samples");
        if (!few && gap <= check.parameter("max_gap")) continue;
        Finding& finding = check.report(rows);
        finding.value = few ? std::to_string(inside.size()) + " samples" : "gap of " + number(gap, 3) + " nm";
        finding.limit = few ? number(check.parameter("min_samples"), 3) + " samples"
                            : number(check.parameter("max_gap"), 3) + " nm";
        finding.message = "dataset \"" + rows.id + "\" has " + std::to_string(inside.size()) +
                          " samples in 380 to 780 nm, largest gap " + number(gap, 3) + " nm";
      }
    }};

}  // namespace etak
