// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

void etk008(RuleCheck& check) {
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
}

}  // namespace

constinit const Rule etk008_negative{
    "ETK008",
    "negative",
    "A reflectance is negative",
    Severity::error,
    Severity::error,
    {Need::header, Need::floats},
    {},
    "etak",
    "Any channel of a float picture is below -1e-6.",
    "Negative light does not exist; filters with negative lobes and gamut conversions make "
    "it.",
    "A Lanczos-resized EXR rings below zero at a hard edge; a wide-gamut colour converted to "
    "sRGB.",
    "Clamp at 0 after resizing, or use a filter without negative lobes.",
    &etk008};

}  // namespace etak
