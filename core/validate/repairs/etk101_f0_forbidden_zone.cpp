// SPDX-License-Identifier: Apache-2.0
#include <optional>

#include "core/judge/nearest.h"
#include "core/judge/pixels/code_tables.h"
#include "core/validate/repairs/rows.h"

namespace etak {

namespace {

// The F0 of the material that the target says it is of, where that lies outside of the zone.
std::optional<std::array<double, 3>> named_f0(const RepairBench& bench) {
  const auto named = known_materials(bench.settings).f0_of(bench.target.manifest.material);
  for (const KnownF0* entry : named)
    if (entry->preferred &&
        (entry->luminance <= bench.settings.zone.low || entry->luminance >= bench.settings.zone.high))
      return entry->linear;
  return std::nullopt;
}

// Undoes one region, where its cause is known: F0 of a dielectric that was encoded twice, or a material that
// is named and has another F0.
bool undo_region(const RepairBench& bench, const RepairRegion& region,
                 const std::optional<std::array<double, 3>>& named, RepairPicture& b) {
  const TextureTransfer transfer = bench.settings.transfer;
  const Explanation why = explain_f0(known_materials(bench.settings), region.linear, transfer);
  const bool doubled = why.cause == Explanation::Cause::doubled;
  if (!doubled && !named) return false;
  for (const std::size_t i : region.texels) {
    const auto texel = b.texel(i);
    for (std::size_t c = 0; c < b.colour_channels(); ++c)
      texel[c] = doubled ? b.code(decode_of(transfer, b.value(texel[c])))
                         : b.code(encode_of(transfer, std::clamp((*named)[c], 0.0, 1.0)));
  }
  return true;
}

RepairOutcome undo_zone(const RepairBench& bench) {
  RepairPicture* b = bench.with_role({FileRole::specular_gloss, FileRole::f0_only});
  if (b == nullptr || bench.seen().metallic.pixel_count() != 0)
    return {"", "F0 comes from base colour and metallic, and neither alone is wrong"};
  const auto named = named_f0(bench);
  if (!named && bench.finding.severity < Severity::error)
    return {"", "the colour may be meant: it is that of a material of the zone"};
  const Image8 marks = bench.marks(RegionKind::zone);
  if (const std::string why = wrong_size(*b, marks); !why.empty()) return {"", why};
  std::size_t undone = 0, left = 0;
  for (const RepairRegion& region : regions_to_repair(bench, marks, bench.seen().b))
    ++(undo_region(bench, region, named, *b) ? undone : left);
  RepairOutcome out;
  if (undone > 0)
    out.what = named ? "gave the zone's plateaus the F0 of " + bench.target.manifest.material
                     : "undid the second encoding of the zone's plateaus";
  if (left > 0 || undone == 0)
    out.left =
        "what the surface is meant to be is not known: no dielectric encoded twice has this colour, and no material is named";
  return out;
}

}  // namespace

constinit const Repair repair_etk101{"ETK101", &undo_zone};

}  // namespace etak
