// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk605_unit_suspect{
    .id = "ETK605",
    .slug = "unit-suspect",
    .title = "Wavelengths in another unit",
    .severity = Severity::error,
    .needs = {Need::material},
    .source = "etak",
    .what =
        "The wavelengths do not reach into 300 to 900 nm. Wider limits, such as 10 to 50,000 nm, would let a table of gold in micrometres pass that runs to 25.",
    .why = "Micrometres taken for nanometres, or the reverse: then nothing lies in the visible range.",
    .example = "A page in micrometres imported as nanometres.",
    .fix = "State the unit of the source.",
    .check = [](RuleCheck& check) {
      for (const SpectralRows& rows : check.datasets()) {
        if (rows.wavelength_nm.empty()) continue;
        const auto [least, most] = std::minmax_element(rows.wavelength_nm.begin(), rows.wavelength_nm.end());
        if (*least <= 900 && *most >= 300) continue;
        Finding& finding = check.report(rows);
        finding.value = number(*least, 4) + " to " + number(*most, 4) + " nm";
        finding.limit = "300 to 900 nm";
        finding.message = "dataset \"" + rows.id + "\" runs from " + finding.value + ": another unit?";
      }
    }};

}  // namespace etak
