// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk503_alpha_constant{
    .id = "ETK503",
    .slug = "alpha-constant",
    .title = "Alpha is the same everywhere",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::bytes_a},
    .source = "OpenImageIO, maketx --opaque-detect",
    .what =
        "Alpha is 255 everywhere (information; pages of an atlas are not judged) or 0 everywhere (error). One finding per file.",
    .why = "Alpha 255 everywhere is a channel for nothing; alpha 0 everywhere is an invisible object.",
    .example = "Alpha slot left empty on export.",
    .fix = "Leave the channel out, or fill it.",
    .check = [](RuleCheck& check) {
      if (!check.has_alpha()) return;
      std::uint64_t texels = 0, full = 0, zero = 0;
      for (const TileEvidence& tile : check.evidence.tiles) {
        texels += tile.counts.texels;
        full += tile.counts.alpha_full;
        zero += tile.counts.alpha_zero;
      }
      if (texels == 0 || (full != texels && zero != texels)) return;
      // A page of an atlas has an alpha channel even where none of its materials needs one.
      if (full == texels && !check.target.manifest.tiles.empty()) return;
      Finding& finding = check.report();
      finding.file = check.file_of(FileRole::diffuse_alpha);
      if (zero == texels) finding.severity = check.at_least(Severity::error);
      finding.area_px = texels;
      finding.area_share = 1;
      finding.value = zero == texels ? "alpha 0" : "alpha 255";
      finding.message = finding.value + " everywhere: " +
                        (zero == texels ? "nothing is visible" : "the channel says nothing");
    }};

}  // namespace etak
