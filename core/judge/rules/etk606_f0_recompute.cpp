// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk606_f0_recompute{
    .id = "ETK606",
    .slug = "f0-recompute",
    .title = "The stored F0 is not that of the data",
    .severity = Severity::error,
    .needs = {Need::material},
    .parameters = {{"difference", 5e-4, 5e-4, "", "largest difference of a linear channel"}},
    .source = "etak; Hoffman's own bytes are 1 off",
    .what =
        "A stored F0 differs by more than 5e-4 from what the preferred dataset gives, or stored codes by more than 1.",
    .why = "The data were changed after F0 was computed, or it was computed under another policy.",
    .example = "An F0 copied from an article beside newer n and k.",
    .fix = "Compute again: etak f0 FILE.",
    .check = [](RuleCheck& check) {
      const auto& material = check.evidence.material;
      if (!material) return;
      if (!material->computed_f0) return;
      double difference = 0;
      int codes = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        if (material->stored_f0)
          difference =
              std::max(difference, std::abs((*material->stored_f0)[c] - (*material->computed_f0)[c]));
        if (material->stored_bytes && material->computed_bytes)
          codes = std::max(codes, std::abs((*material->stored_bytes)[c] - (*material->computed_bytes)[c]));
      }
      if (difference <= check.parameter("difference") && codes <= 1) return;
      Finding& finding = check.report();
      finding.pointer = "/f0";
      finding.linear = material->computed_f0;
      finding.value = difference > check.parameter("difference") ? number(difference, 3) + " off"
                                                                 : std::to_string(codes) + " codes off";
      finding.limit =
          difference > check.parameter("difference") ? number(check.parameter("difference"), 2) : "1 code";
      finding.message = "stored F0 is " + finding.value + "; the data give";
      for (const double c : *material->computed_f0) finding.message += ' ' + number(c, 4);
    }};

}  // namespace etak
