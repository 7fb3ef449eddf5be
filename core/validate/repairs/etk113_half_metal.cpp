// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>

#include "core/color/luminance.h"
#include "core/judge/pixels/code_tables.h"
#include "core/judge/pixels/evidence.h"
#include "core/validate/repairs/rows.h"

namespace etak {

namespace {

// Mean luminance of the base colour on a region; none where its picture has another size.
std::optional<double> base_luminance(const RepairBench& bench, const RepairRegion& region,
                                     const Image8& marks) {
  RepairPicture* base = bench.with_role({FileRole::base_color});
  if (base == nullptr || !wrong_size(*base, marks).empty()) return std::nullopt;
  std::array<double, 3> sum{};
  for (const std::size_t i : region.texels)
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += decode_of(bench.settings.transfer,
                          base->value(base->texel(i)[base->colour_channels() == 3 ? c : 0]));
  return luminance_of(sum) / static_cast<double>(region.texels.size());
}

// Texels that count as metal become full metal. Others stay.
std::size_t fill_metal(RepairPicture& metal, std::size_t first, std::size_t last) {
  const int least = metal_first_code * (metal.most / 255);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < metal.codes.pixel_count(); ++i)
    for (std::size_t c = first; c < last; ++c) {
      std::uint16_t& code = metal.texel(i)[c];
      if (code < least || code == metal.most) continue;
      code = static_cast<std::uint16_t>(metal.most);
      ++changed;
    }
  return changed;
}

// Half metals become what they are nearer to. The base colour of a metal is its F0, so that a dark one
// cannot be that of a metal.
RepairOutcome separate_metal(const RepairBench& bench) {
  RepairPicture* metal = bench.with_role({FileRole::metallic, FileRole::metal_rough});
  const auto [first, last] = metal == nullptr ? std::array<std::size_t, 2>{} : metallic_channels(*metal);
  if (first == last) return {"", "metallic is in no channel of a file of the set"};
  const Image8 marks = bench.marks(RegionKind::half_metal);
  if (const std::string why = wrong_size(*metal, marks); !why.empty()) return {"", why};
  std::size_t guessed = 0;
  for (const RepairRegion& region : regions_to_repair(bench, marks, bench.seen().metallic)) {
    const auto base = base_luminance(bench, region, marks);
    const bool may_be_metal = !base || *base >= bench.settings.zone.high;
    const bool is_metal = region.mean[0] >= 0.5 && may_be_metal;
    if (may_be_metal) guessed += region.texels.size();
    for (const std::size_t i : region.texels)
      for (std::size_t c = first; c < last; ++c) metal->texel(i)[c] = metal->code(is_metal ? 1 : 0);
  }
  // Of a metal that is nowhere a full one no texel is half.
  if (std::ranges::find(marks.values, 2) == marks.values.end())
    return fill_metal(*metal, first, last) == 0 ? RepairOutcome{} : RepairOutcome{"made metal full metal"};
  if (2 * guessed >= marks.values.size())
    return {
        "",
        "half of the texels or more are half metal of a base colour that metals have: which are metal is not known"};
  return {"separated metal from what is none"};
}

}  // namespace

constinit const Repair repair_etk113{"ETK113", &separate_metal};

}  // namespace etak
