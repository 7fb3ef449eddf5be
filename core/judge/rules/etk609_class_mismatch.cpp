// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"
#include "core/material/material.h"

namespace etak {

constinit const Rule etk609_class_mismatch{
    .id = "ETK609",
    .slug = "class-mismatch",
    .title = "F0 does not fit the class",
    .severity = Severity::warning,
    .needs = {Need::material},
    .source = "Hoffman's zone; silicon and thin-film titanium are the exceptions",
    .what =
        "A conductor whose F0 luminance is below the zone's upper end, or a dielectric above its lower end.",
    .why = "Class and data contradict each other, or the sample is a film or a powder.",
    .example = "A table of an oxide filed under the metal's name.",
    .fix = "Check class and sample.",
    .check = [](RuleCheck& check) {
      const auto& material = check.evidence.material;
      if (!material) return;
      if (!material->luminance || material->material_class.empty()) return;
      const std::string_view kind = optical_kind(material->material_class);
      const double y = *material->luminance;
      const bool low_metal = kind == "conductor" && y < check.settings.zone.high;
      const bool high_dielectric = kind == "dielectric" && y > check.settings.zone.low;
      if (!low_metal && !high_dielectric) return;
      Finding& finding = check.report();
      finding.luminance = y;
      finding.value = "F0 " + number(y, 3);
      finding.limit = low_metal ? "above " + percent(check.settings.zone.high)
                                : "below " + percent(check.settings.zone.low);
      finding.message = "class \"" + material->material_class + "\" with " + finding.value;
    }};

}  // namespace etak
