// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk007_nan_inf{
    .id = "ETK007",
    .slug = "nan-inf",
    .title = "A value is not a number, or infinite",
    .severity = Severity::error,
    .needs = {Need::header, Need::floats},
    .source = "OpenImageIO, maketx --checknan",
    .what = "Any channel of a float picture is NaN or infinite.",
    .why = "One such texel spreads over a whole mip level and from there over the frame.",
    .example = "A division by zero in a bake; an EXR saved by a broken node.",
    .fix = "Bake again; clean the picture before export.",
    .check = [](RuleCheck& check) {
      for (const auto* picture : {&check.evidence.a, &check.evidence.b}) {
        if (!*picture || !(*picture)->floats) continue;
        const FloatFacts& f = *(*picture)->floats;
        const std::uint64_t count = f.nan + f.infinite;
        if (count == 0) continue;
        Finding& finding = check.report(**picture);
        finding.box = PixelBox{f.nan_at[0], f.nan_at[1], 1, 1};
        finding.area_px = count;
        finding.value = in_thousands(f.nan) + " NaN, " + in_thousands(f.infinite) + " infinite";
        finding.limit = "finite numbers";
        finding.message = finding.value + " values, the first at " + std::to_string(f.nan_at[0]) + "," +
                          std::to_string(f.nan_at[1]);
      }
    }};

}  // namespace etak
