// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

constexpr RuleParameter etk608_parameters[] = {
    {"spread", 0.05, 0.05, "", "largest difference of reflectance"},
};

void etk608(RuleCheck& check) {
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
  finding.message = "reflectance at 550 nm is " + number(least->second, 3) + " (" + least->first + ") to " +
                    number(most->second, 3) + " (" + most->first + ")";
}

}  // namespace

constinit const Rule etk608_dataset_spread{
    "ETK608",
    "dataset-spread",
    "The sources disagree",
    Severity::info,
    Severity::warning,
    {Need::material},
    etk608_parameters,
    "Titanium 0.20, iron 0.06 without outliers (etak)",
    "Reflectance at 550 nm spans more than 0.05 over the datasets, those flagged as doubtful "
    "left out.",
    "The choice of the dataset matters more than any arithmetic after it.",
    "Evaporated films against polished bulk.",
    "Say why the preferred one is preferred.",
    &etk608};

}  // namespace etak
