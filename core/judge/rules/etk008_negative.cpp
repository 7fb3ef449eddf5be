// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk008_negative{
    .id = "ETK008",
    .slug = "negative",
    .title = "A reflectance is negative",
    .severity = Severity::error,
    .needs = {Need::header, Need::floats},
    .source = "etak",
    .what = "Any channel of a float picture is below -1e-6.",
    .why = "Negative light does not exist; filters with negative lobes and gamut conversions make it.",
    .example =
        "A Lanczos-resized EXR rings below zero at a hard edge; a wide-gamut colour converted to sRGB.",
    .fix = "Clamp at 0 after resizing, or use a filter without negative lobes.",
    .check = [](RuleCheck& check) {
      for (const auto* picture : {&check.evidence.a, &check.evidence.b}) {
        if (!*picture || !(*picture)->floats) continue;
        const FloatFacts& f = *(*picture)->floats;
        if (f.negative == 0) continue;
        Finding& finding = check.report(**picture);
        finding.box = PixelBox{f.negative_at[0], f.negative_at[1], 1, 1};
        finding.area_px = f.negative;
        finding.value = number(static_cast<double>(f.most_negative), 3);
        finding.limit = "-1e-06";
        finding.message = in_thousands(f.negative) + " negative values, down to " + finding.value +
                          ", the first at " + std::to_string(f.negative_at[0]) + "," +
                          std::to_string(f.negative_at[1]);
      }
    }};

}  // namespace etak
