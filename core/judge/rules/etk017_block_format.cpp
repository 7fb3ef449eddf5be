// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

// What a format of blocks takes away from what a role holds; empty: nothing that is told by its name.
struct BlockFault {
  std::string loss, limit;
  bool lost = false;  // the channel is as good as gone
};

BlockFault fault_of(FileRole role, const std::string& format) {
  const bool bc1 = format.starts_with("BC1"), bc2 = format == "BC2", bc3 = format == "BC3";
  if (role == FileRole::specular_gloss && bc1)
    return {"keeps one bit of the fourth channel at most, which is gloss", "BC7, BC3 or ASTC 4x4", true};
  if (role == FileRole::specular_gloss && bc2)
    return {"keeps 16 steps of gloss, of which each changes the exponent by three quarters",
            "BC7, BC3 or ASTC 4x4", true};
  const bool roughness = traits(role).data && role != FileRole::metallic;
  if (roughness && (bc1 || bc2 || bc3))
    return {
        "keeps its colour channels on one line a block, of 5, 6 and 5 bits, where roughness is one of them",
        "BC7, ASTC 4x4, or BC4 for roughness alone"};
  if (role == FileRole::normal && bc1)
    return {"keeps x, y and z of 4 x 4 normals on one line of 5, 6 and 5 bits",
            "BC5, whose z follows from x and y, BC7 or ASTC"};
  if (role == FileRole::f0_only && bc1)
    return {"keeps 5, 6 and 5 bits of F0, on one line a block", "BC7 or ASTC"};
  return {};
}

// The standard deviation of gloss over all tiles, in codes.
double gloss_deviation(const RuleCheck& check) {
  double count = 0, sum = 0, squares = 0;
  for (const TileEvidence& tile : check.evidence.tiles) {
    count += static_cast<double>(tile.counts.gloss_texels);
    sum += static_cast<double>(tile.counts.gloss_sum);
    squares += static_cast<double>(tile.counts.gloss_squares);
  }
  return count == 0 ? 0 : std::sqrt(std::max(0.0, squares / count - sum / count * (sum / count)));
}

// Reports a fault of a picture or a map.
template <class Judged>
void tell(RuleCheck& check, const Judged& judged, const std::string& format, const BlockFault& fault) {
  if (fault.loss.empty()) return;
  Finding& finding = check.report(judged);
  if (fault.lost) finding.severity = check.at_least(Severity::error);
  finding.value = format;
  finding.limit = fault.limit;
  finding.message = std::string(name(judged.role)) + " in " + format + ", which " + fault.loss;
}

}  // namespace

constinit const Rule etk017_block_format{
    .id = "ETK017",
    .slug = "block-format",
    .title = "The blocks of a texture cannot hold what it is for",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::header, Need::bytes_b, Need::maps},
    .parameters = {{"bits", 5, 5, "bits",
                    "a texel of F0 with gloss in ASTC has so many at least where gloss varies"},
                   {"deviation", 2, 2, "codes", "standard deviation of gloss from which on it varies"}},
    .source =
        "Khronos Data Format Specification 1.3, chapters 18 to 23; etak report, family l: at 3.6 bits a texel the exponent's error is three times that of 8",
    .what =
        "A DDS or KTX2 file holds gloss in BC1 or BC2 (an error), roughness in the colours of BC1 to BC3, F0 or normals in BC1, or F0 with a gloss that varies in ASTC of more than 25 texels a block.",
    .why =
        "These formats share one line and a few bits among channels of a block. Colours bear it, the exponent does not: one code of gloss is 3.3 % of it.",
    .example = "An ORM texture compressed with the preset for colour (BC1).",
    .fix =
        "Compress it again from its source, in the format that the finding names; etak pack --compress auto weighs gloss by its exponent.",
    .check = [](RuleCheck& check) {
      for (const PictureEvidence& picture : check.evidence.headers) {
        const std::string& format = picture.header.blocks;
        if (format.empty()) continue;
        BlockFault fault = fault_of(picture.role, format);
        const double bits = picture.header.bits_per_texel, deviation = gloss_deviation(check);
        const bool coarse = picture.role == FileRole::specular_gloss && bits < check.parameter("bits") &&
                            format.starts_with("ASTC") && deviation >= check.parameter("deviation");
        if (coarse)
          fault = {"keeps " + number(bits, 2) + " bits a texel, where gloss varies by " +
                       number(deviation, 2) + " codes",
                   "ASTC 4x4 or 5x5"};
        tell(check, picture, format, fault);
      }
      for (const MapEvidence& map : check.evidence.maps)
        tell(check, map, map.blocks, fault_of(map.role, map.blocks));
    }};

}  // namespace etak
