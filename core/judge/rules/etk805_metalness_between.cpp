// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/surface_check.h"

namespace etak {

constinit const Rule etk805_metalness_between{
    .id = "ETK805",
    .slug = "metalness-between",
    .title = "Metalness that is neither 0 nor 1",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::material},
    .source = "Khronos glTF 2.0, OpenPBR and Filament: metalness is 0 or 1",
    .what =
        "A material document states one metalness between 0.02 and 0.98 for the whole surface. Of glTF scenes materials that triangles show are left to ETK113.",
    .why =
        "A surface is metal or it is not. Values between are for the filtered edges of pictures; as a number they give an F0 that no material has.",
    .example = "metalness 0.5 for a varnished or dusty metal.",
    .fix = "Set it to 0 or 1; varnish is a coat, dust a second material.",
    .check = [](RuleCheck& check) {
      constexpr double least = 0.02;
      for_each_surface(check, [&](const DocumentSurface& surface, const DocumentValues& values) {
        if (surface.looked_at || !values.metalness || values.metal_from == nullptr) return;
        if (*values.metalness <= least || *values.metalness >= 1 - least || *values.metalness > 1) return;
        Finding& finding =
            report_surface(check, surface, values, values.metal_from, number(*values.metalness, 3));
        finding.limit = "0 or 1";
      });
    }};

}  // namespace etak
