// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"
#include "core/judge/rules/spectral.h"
#include "core/material/coverage.h"

namespace etak {

constinit const Rule etk601_coverage{
    .id = "ETK601",
    .slug = "coverage",
    .title = "The spectrum does not cover the visible range",
    .severity = Severity::error,
    .needs = {Need::material},
    .source =
        "etak f0 refuses the same data, by the same limit; Filament's tool takes short data in silence (etak)",
    .what =
        "The data hold less than 95 % of the luminous weight, so that etak f0 gives no colour for them (error; of a dataset beside the preferred one a warning), or more, but not all of 380 to 780 nm (a "
        "remark, with the share that is missing).",
    .why =
        "What is not there is guessed by holding the end values. Past 95 % that moves a colour by less than instruments differ; below, it is a guess.",
    .example = "An infrared measurement used for a colour.",
    .fix = "Use another dataset, or complete the table.",
    .check = [](RuleCheck& check) {
      for (const SpectralRows& rows : check.datasets()) {
        const double first = first_nm(rows), last = last_nm(rows);
        if (first <= 0 || (first <= visible_first_nm && last >= visible_last_nm)) continue;
        const double held = luminous_coverage(first, last);
        const bool refused = !covers_enough(held);
        Finding& finding = check.report(rows);
        // A dataset that is not preferred is used only where it is named, and etak f0 refuses it then.
        if (!refused || !rows.preferred)
          finding.severity = check.at_most(refused ? Severity::warning : Severity::info);
        finding.value = number(first, 5) + " to " + number(last, 5) + " nm";
        finding.limit = refused ? percent(least_coverage) + " of the luminous weight" : "380 to 780 nm";
        finding.message = "dataset \"" + rows.id + "\" covers " + finding.value + "; " +
                          percent(std::max(0.0, 1 - held)) + " of the luminous weight is outside" +
                          (refused ? ", too much for a colour" : "");
      }
    }};

}  // namespace etak
