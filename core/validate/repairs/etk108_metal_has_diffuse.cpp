// SPDX-License-Identifier: Apache-2.0
#include "core/validate/repairs/rows.h"

namespace etak {

namespace {

RepairOutcome blacken_metal(const RepairBench& bench) {
  RepairPicture* a = bench.with_role({FileRole::diffuse_alpha});
  if (a == nullptr) return {"", "diffuse is in no file of its own"};
  const Image8 marks = bench.marks(RegionKind::metal_with_diffuse);
  if (const std::string why = wrong_size(*a, marks); !why.empty()) return {"", why};
  for (const RepairRegion& region : regions_to_repair(bench, marks, bench.seen().b))
    for (const std::size_t i : region.texels)
      for (std::size_t c = 0; c < a->colour_channels(); ++c) a->texel(i)[c] = 0;
  return {"made diffuse black under metal"};
}

}  // namespace

constinit const Repair repair_etk108{"ETK108", &blacken_metal};

}  // namespace etak
