// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk604_nk_range{
    .id = "ETK604",
    .slug = "nk-range",
    .title = "Optical constants out of range",
    .severity = Severity::error,
    .needs = {Need::material},
    .source = "etak: no solid or liquid has n above 20 or k above 50 in the visible range",
    .what =
        "n below 0, or 0 without k, k below 0 or reflectance outside of 0 to 1 at any wavelength; n above 20 or k above 50 between 360 and 830 nm (in the infrared gold passes 50).",
    .why = "Columns are mixed up, or a number lost its decimal point.",
    .example = "k given as percent.",
    .fix = "Compare with the source.",
    .check = [](RuleCheck& check) {
      for (const SpectralRows& rows : check.datasets()) {
        for (std::size_t i = 0; i < rows.wavelength_nm.size(); ++i) {
          const double n = i < rows.n.size() ? rows.n[i] : 1, k = i < rows.k.size() ? rows.k[i] : 0;
          const double r = i < rows.reflectance.size() ? rows.reflectance[i] : 0;
          const bool visible =
              rows.wavelength_nm[i] >= grid_first_nm && rows.wavelength_nm[i] <= grid_last_nm;
          if ((n > 0 || (n == 0 && k > 0)) && k >= 0 && r >= -0.02 && r <= 1.02 &&
              (!visible || (n <= 20 && k <= 50)))
            continue;
          Finding& finding = check.report(rows);
          finding.value = "n " + number(n, 4) + ", k " + number(k, 4);
          if (!rows.reflectance.empty()) finding.value = "R " + number(r, 4);
          finding.limit =
              rows.reflectance.empty() ? "0 < n <= 20, 0 <= k <= 50 (n = 0 with k > 0)" : "0 to 1";
          finding.message = "dataset \"" + rows.id + "\": " + finding.value + " at " +
                            number(rows.wavelength_nm[i], 5) + " nm";
          break;
        }
      }
    }};

}  // namespace etak
