// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

// Parts of one set are read by one UV, so that another aspect stretches what they show.
void report_aspects(RuleCheck& check) {
  const auto differ = [](int width, int height, int other_width, int other_height) {
    const double ratio =
        static_cast<double>(width) * other_height / (static_cast<double>(height) * other_width);
    return ratio > 1.02 || ratio < 1 / 1.02;
  };
  const auto tell = [&](Finding& finding, int width, int height, const std::string& first, int first_width,
                        int first_height) {
    finding.severity = check.at_most(Severity::warning);
    finding.value = std::to_string(width) + " x " + std::to_string(height);
    finding.limit = "the aspect of " + std::to_string(first_width) + " x " + std::to_string(first_height);
    finding.message = "the picture is " + finding.value + ", and " + first + " of the same set is " +
                      std::to_string(first_width) + " x " + std::to_string(first_height) +
                      ": it is stretched";
  };
  const auto& parts = check.evidence.headers;
  for (const PictureEvidence& part : parts)
    if (const PictureHeader& h = part.header, &first = parts.front().header;
        differ(h.width, h.height, first.width, first.height))
      tell(check.report(part), h.width, h.height, parts.front().label, first.width, first.height);
  const auto& maps = check.evidence.maps;
  for (const MapEvidence& map : maps)
    if (!map.packed && differ(map.width, map.height, maps.front().width, maps.front().height))
      tell(check.report(map), map.width, map.height, maps.front().label, maps.front().width,
           maps.front().height);
}

}  // namespace

constinit const Rule etk003_size_mismatch{
    .id = "ETK003",
    .slug = "size-mismatch",
    .title = "The textures of a pair differ in size",
    .severity = Severity::error,
    .needs = {Need::header},
    .source = "Schueler 2009: both textures are sampled with the same UVs",
    .what =
        "Width or height of the diffuse and the specular picture differ. A metal-rough set may differ: it is resampled; there, and among normal, occlusion and emissive maps, another aspect is a warning.",
    .why =
        "Rules that need the texels of both pictures cannot judge them, and mip levels of the two do not match.",
    .example = "Diffuse exported at 2048, specular at 1024.",
    .fix = "Export both at one size.",
    .check = [](RuleCheck& check) {
      const auto &a = check.evidence.a, &b = check.evidence.b;
      if (check.target.with_role({FileRole::scene}) != nullptr) return;
      if (check.evidence.metal_rough || !check.evidence.maps.empty()) return report_aspects(check);
      if (!a || !b) return;
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
