// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

void etk007(RuleCheck& check) {
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
}

}  // namespace

constinit const Rule etk007_nan_inf{
    "ETK007",
    "nan-inf",
    "A value is not a number, or infinite",
    Severity::error,
    Severity::error,
    {Need::header, Need::floats},
    {},
    "OpenImageIO, maketx --checknan",
    "Any channel of a float picture is NaN or infinite.",
    "One such texel spreads over a whole mip level and from there over the frame.",
    "A division by zero in a bake; an EXR saved by a broken node.",
    "Bake again; clean the picture before export.",
    &etk007};

}  // namespace etak
