// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/number.h"
#include "core/judge/rules/surface_check.h"

namespace etak {

constinit const Rule etk809_not_the_named_material{
    .id = "ETK809",
    .slug = "not-the-named-material",
    .title = "F0 is not that of the material that the name says",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::material},
    .parameters = {{"distance", 8, 8, "dE2000", "from the nearest dataset of the named material"}},
    .source = "The material library of etak, all datasets of each material",
    .what =
        "A surface of a material document has the name of a material of the library, and its F0 is more than 8 dE from every dataset of it.",
    .why = "Name and value contradict each other: one of them is wrong.",
    .example = "A material Gold with the F0 of brass; a Diamond of index 1.5.",
    .fix = "Take the measured F0 (etak f0 NAME), or give it another name.",
    .check = [](RuleCheck& check) {
      for_each_surface(check, [&](const DocumentSurface& surface, const DocumentValues& values) {
        if (!values.f0) return;
        const KnownMaterials& known = known_materials(check.settings);
        const auto entries = named_material(known, surface.name);
        if (!entries || entries->empty() || is_what_it_is_called(known, surface, *values.f0)) return;
        double least = distance_of(*values.f0, *entries->front());
        for (const KnownF0* entry : *entries) least = std::min(least, distance_of(*values.f0, *entry));
        if (least <= check.parameter("distance")) return;
        Finding& finding = report_surface(check, surface, values, values.f0_from,
                                          "F0 is " + number(least, 2) + " dE from " + entries->front()->id);
        finding.limit = number(check.parameter("distance"), 2) + " dE";
      });
    }};

}  // namespace etak
