// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk009_npot{
    .id = "ETK009",
    .slug = "npot",
    .title = "A side is not a power of two",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::header},
    .parameters = {{"multiple", 0, 0, "texels",
                    "sides are to be multiples of this, such as 4 for block compression; 0: powers of two"}},
    .source = "glTF-Validator (information); Unity Asset Auditor (fails the asset)",
    .what =
        "Width or height is no power of two, or no multiple of what [rules] ETK009 of etak.toml asks for. Pages of an atlas are not judged.",
    .why = "Mip levels of odd sides shift, and some hardware and block compressors refuse them.",
    .example = "A decal cropped to 300 x 200.",
    .fix = "Resize or pack into an atlas.",
    .check = [](RuleCheck& check) {
      // The sides of an atlas page are the choice of its packer.
      if (!check.target.manifest.tiles.empty() || check.target.manifest.packed) return;
      const auto multiple = static_cast<int>(check.parameter("multiple"));
      const auto fits = [&](int side) {
        return multiple > 0 ? side % multiple == 0 : side > 0 && (side & (side - 1)) == 0;
      };
      for (const PictureEvidence& picture : check.evidence.headers) {
        const PictureHeader& h = picture.header;
        if (fits(h.width) && fits(h.height)) continue;
        Finding& finding = check.report(picture);
        finding.value = std::to_string(h.width) + " x " + std::to_string(h.height);
        finding.limit = multiple > 0 ? "multiples of " + std::to_string(multiple) : "powers of two";
        finding.message = "the picture is " + finding.value;
        if (multiple > 0) finding.message += ", where the project asks for " + finding.limit;
      }
    }};

}  // namespace etak
