// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/surface_check.h"

namespace etak {

constinit const Rule etk803_metal_f0_unlikely{
    .id = "ETK803",
    .slug = "metal-f0-unlikely",
    .title = "A metal whose F0 no metal has",
    .severity = Severity::error,
    .needs = {Need::material},
    .parameters = {{"distance", 3, 3, "dE2000", "from a measured conductor, up to which an F0 is one"}},
    .source = "Hoffman, \"Crafting Physically Motivated Shading Models\"; the material library of etak",
    .what =
        "A material document states a metal (metalness 0.9 or more, or n and k) whose F0 has a luminance below the upper end of the forbidden zone (0.45), and no measured conductor is within 3 dE. An F0 that is stated without metalness is judged in the zone alone. Of glTF scenes materials that triangles show are left to ETK101 and ETK114.",
    .why = "Metals reflect half of the light or more; darker ones are measured for a few compounds alone.",
    .example = "A metal in a colour that was picked for paint: base_color 0.2 0.05 0.05, metalness 1.",
    .fix = "Take the F0 of a measured metal (etak f0 NAME); for painted metal set the metalness to 0.",
    .check = [](RuleCheck& check) {
      for_each_surface(check, [&](const DocumentSurface& surface, const DocumentValues& values) {
        if (surface.looked_at || !values.f0) return;
        if (values.sort != SurfaceSort::metal && values.sort != SurfaceSort::either) return;
        const KnownMaterials& known = known_materials(check.settings);
        const double y = luminance_of({values.f0->r, values.f0->g, values.f0->b});
        const ZoneSettings& zone = check.settings.zone;
        if (y >= zone.high || (values.sort == SurfaceSort::either && y <= zone.low)) return;
        if (is_what_it_is_called(known, surface, *values.f0)) return;
        const Measured nearest = nearest_measured(known, *values.f0, values.sort);
        if (nearest.entry != nullptr && (nearest.entry->metal || values.sort == SurfaceSort::either) &&
            nearest.delta_e <= check.parameter("distance"))
          return;
        if (!transfer_slip(known, *values.f0).empty()) return;  // ETK807
        Finding& finding =
            report_surface(check, surface, values, values.f0_from, "F0 of luminance " + number(y, 2));
        finding.limit = number(zone.high, 2) + " or more";
      });
    }};

}  // namespace etak
