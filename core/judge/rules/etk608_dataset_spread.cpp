// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk608_dataset_spread{
    .id = "ETK608",
    .slug = "dataset-spread",
    .title = "The sources disagree",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::material},
    .parameters = {{"spread", 0.05, 0.05, "", "largest difference of reflectance"}},
    .source = "Titanium 0.20, iron 0.06 without outliers (etak)",
    .what =
        "Reflectance at 550 nm spans more than 0.05 over the datasets, those flagged as doubtful left out.",
    .why = "The choice of the dataset matters more than any arithmetic after it.",
    .example = "Evaporated films against polished bulk.",
    .fix = "Say why the preferred one is preferred.",
    .check = [](RuleCheck& check) {
      const auto& material = check.evidence.material;
      if (!material) return;
      if (material->at_550.size() < 2) return;
      const auto [least, most] =
          std::minmax_element(material->at_550.begin(), material->at_550.end(),
                              [](const auto& a, const auto& b) { return a.second < b.second; });
      const double spread = most->second - least->second;
      if (spread <= check.parameter("spread")) return;
      Finding& finding = check.report();
      finding.value = number(spread, 2);
      finding.limit = number(check.parameter("spread"), 2);
      finding.message = "reflectance at 550 nm is " + number(least->second, 3) + " (" + least->first +
                        ") to " + number(most->second, 3) + " (" + most->first + ")";
    }};

}  // namespace etak
