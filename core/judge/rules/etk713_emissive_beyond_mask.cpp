// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk713_emissive_beyond_mask{
    .id = "ETK713",
    .slug = "emissive-beyond-mask",
    .title = "Emission goes beyond its mask",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::maps},
    .source = "etak",
    .what =
        "Half of the texels or more glow with codes 1 to 24 beside others of 64 and more, and less than 1 % is black; or 1 % of the texels glow with codes above 16 where the base colour beside has alpha 0. Found from a veil of 1 code.",
    .why =
        "The whole surface glows in the dark, most of all with the exposure of a night scene; what is cut out leaves a bright fringe in mips.",
    .example =
        "A mask of emission that was compressed as JPEG or multiplied with a grey that is not quite black.",
    .fix = "Subtract the veil, and multiply emission by its mask.",
    .check = [](RuleCheck& check) {
      for_each_map(check, FileRole::emissive, [&](const MapEvidence& map) {
        const GreyFacts& grey = map.grey;
        if (grey.texels == 0) return;
        const auto share = [&](std::uint64_t count) {
          return static_cast<double>(count) / static_cast<double>(grey.texels);
        };
        const std::uint64_t faint = grey.between(1, 24), lit = grey.between(64, 255);
        const bool glows_faintly = share(faint) >= 0.5 && share(lit) >= 1e-4 && share(grey.codes[0]) < 0.01;
        const bool glows_hidden = grey.hidden > 0 && share(grey.hidden_lit) >= 0.01;
        if (!glows_faintly && !glows_hidden) return;
        Finding& finding = check.report(map);
        const std::uint64_t area = glows_hidden ? grey.hidden_lit : faint;
        finding.area_px = area;
        finding.area_share = share(area);
        finding.value = percent(finding.area_share) + " of the texels";
        finding.limit = glows_hidden ? "black under alpha 0" : "black beside what glows";
        finding.message = glows_hidden ? "emission above code 16 on " + area_text(area, grey.texels) +
                                             " where the base colour's alpha is 0"
                                       : "a faint emission of codes 1 to 24 on " +
                                             area_text(area, grey.texels) + ", and hardly a texel is black";
      });
    }};

}  // namespace etak
