// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk003_size_mismatch{
    .id = "ETK003",
    .slug = "size-mismatch",
    .title = "The textures of a pair differ in size",
    .severity = Severity::error,
    .needs = {Need::header},
    .source = "Schueler 2009: both textures are sampled with the same UVs",
    .what =
        "Width or height of the diffuse and the specular picture differ. A metal-rough set may differ: it is resampled.",
    .why =
        "Rules that need the texels of both pictures cannot judge them, and mip levels of the two do not match.",
    .example = "Diffuse exported at 2048, specular at 1024.",
    .fix = "Export both at one size.",
    .check = [](RuleCheck& check) {
      const auto &a = check.evidence.a, &b = check.evidence.b;
      if (!a || !b || check.evidence.metal_rough) return;
      const PictureHeader &first = a->header, &second = b->header;
      if (first.width == second.width && first.height == second.height) return;
      const auto size = [](const PictureHeader& h) {
        return std::to_string(h.width) + " x " + std::to_string(h.height);
      };
      Finding& finding = check.report(*b);
      finding.value = size(second);
      finding.limit = size(first);
      finding.message = "specular is " + size(second) + ", diffuse is " + size(first);
    }};

}  // namespace etak
