// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/surface_check.h"

namespace etak {

constinit const Rule etk804_dielectric_f0_unlikely{
    .id = "ETK804",
    .slug = "dielectric-f0-unlikely",
    .title = "A dielectric whose F0 none has",
    .severity = Severity::error,
    .needs = {Need::material},
    .parameters = {{"distance", 2, 2, "dE2000", "from a measured material, up to which an F0 is one"}},
    .source = "The material library of etak: ice 0.017, diamond 0.17, rutile 0.21",
    .what =
        "A material document states a dielectric (metalness 0.1 or less) whose F0, by index, weight and colour, is above 0 but below 0.017 (index 1.30), or above 0.18 (index 2.47), and no measured dielectric is within 2 dE. Also an F0 that is stated by itself and below 0.017. Of glTF scenes materials that triangles show are left to ETK103 and ETK101.",
    .why =
        "No solid or liquid reflects less than ice and water do, and few of no metal more than diamond. An index of 1.0 to 1.3 makes skin and plastic look like gas.",
    .example = "specular_ior 15 for 1.5; specular 0.02 taken for F0, where it is a factor of it.",
    .fix =
        "Set the index: 1.33 water, 1.5 plastic and glass, 1.77 sapphire, 2.42 diamond; leave the weight at 1.",
    .check = [](RuleCheck& check) {
      constexpr double most_of_dielectrics = 0.18;
      for_each_surface(check, [&](const DocumentSurface& surface, const DocumentValues& values) {
        if (surface.looked_at || !values.f0) return;
        const bool dielectric = values.sort == SurfaceSort::dielectric;
        if (!dielectric && values.sort != SurfaceSort::either) return;
        const double y = luminance_of({values.f0->r, values.f0->g, values.f0->b});
        const bool low = y > 0 && y < least_dielectric_f0, high = dielectric && y > most_of_dielectrics;
        if (!low && !high) return;
        const KnownMaterials& known = known_materials(check.settings);
        if (is_what_it_is_called(known, surface, *values.f0)) return;
        const Measured nearest = nearest_measured(known, *values.f0, SurfaceSort::dielectric);
        if (high && nearest.entry != nullptr && !nearest.entry->metal && !nearest.entry->layers &&
            nearest.delta_e <= check.parameter("distance"))
          return;
        Finding& finding = report_surface(check, surface, values, values.f0_from, "F0 is " + number(y, 2));
        if (low) finding.severity = check.at_most(Severity::warning);
        finding.limit =
            number(least_dielectric_f0, 3) + " to " + number(most_of_dielectrics, 3) + ", of dielectrics";
      });
    }};

}  // namespace etak
