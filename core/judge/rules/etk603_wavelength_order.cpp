// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"
#include "core/judge/rules/spectral.h"

namespace etak {

constinit const Rule etk603_wavelength_order{
    .id = "ETK603",
    .slug = "wavelength-order",
    .title = "Wavelengths contradict each other",
    .severity = Severity::error,
    .needs = {Need::material},
    .source = "etak",
    .what =
        "A wavelength stands twice with different values, or is not a positive number; in a material file also: the rows do not ascend.",
    .why = "Which of the two values holds is not known.",
    .example = "Two tables pasted one behind the other.",
    .fix = "Remove one of the rows.",
    .check = [](RuleCheck& check) {
      for (const SpectralRows& rows : check.datasets()) {
        if (rows.contradicts) {
          Finding& finding = check.report(rows);
          finding.value = "two values";
          finding.limit = "one per wavelength";
          finding.message = "dataset \"" + rows.id + "\" has a wavelength twice, with different values";
        }
        for (std::size_t i = 0; i + 1 < rows.wavelength_nm.size(); ++i) {
          const double here = rows.wavelength_nm[i], next = rows.wavelength_nm[i + 1];
          if (here > 0 && (next > here || (!check.evidence.material->is_material_file && next != here)))
            continue;
          if (here > 0 && next == here && equal_rows(rows, i, i + 1)) continue;
          Finding& finding = check.report(rows);
          finding.value = number(here, 6) + ", then " + number(next, 6) + " nm";
          finding.limit = "ascending";
          finding.message = "dataset \"" + rows.id + "\", row " + std::to_string(i + 2) + ": wavelength " +
                            number(next, 6) + " nm after " + number(here, 6) + " nm";
          break;
        }
      }
    }};

}  // namespace etak
