// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "core/atlas/outputs.h"
#include "core/atlas/texels/compose.h"

namespace etak {

// Pages that are never whole in memory: a slab is made while the slab above it is written. That is faster,
// because fresh memory costs more than filling it, and because the texels are still in the processor's cache
// when they are compressed.

/// The rows where a page is cut into slabs, from 0 to its height. Two entries mean one slab: the page
/// cannot be cut, or is too small to gain by it. Regions that have mips are not cut through.
///   levels   of the page
std::vector<int> page_cuts(const Composer& composer, const std::vector<Region>& regions,
                           const PackingPlan& plan, int page, int levels, bool bleed);

/// A page that is made slab by slab.
///   cuts          of page_cuts()
///   folder        null: nothing is written
///   region_done   called after each region's texture; may be empty
struct StreamedPage {
  const std::vector<Region>& regions;
  const PackingPlan& plan;
  int page, levels;
  const std::vector<int>& cuts;
  OutputFolder* folder;
  const WriteOptions& write;
  const std::function<void()>& region_done;

  const PlannedPage& size() const { return plan.pages[static_cast<std::size_t>(page)]; }
};

/// Composes a page and writes it as PNG, mips and all: the bytes of Composer::texels() and mips() with
/// write_page().
void stream_page(Composer& composer, const StreamedPage& of, std::vector<Learned>& learned);

}  // namespace etak
