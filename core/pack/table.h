// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/atlas/layout.h"
#include "core/pack/decision.h"
#include "core/scene/gltf.h"

namespace etak {

struct OnePage;
struct PackOptions;
struct PackResult;

// What is written of a decision: the layout for programs that read the atlas, the boxes of a material for the
// written scene, and the account of what was left out for the report.

/// The layout without its hashes.
AtlasLayout layout_table(const PackOptions& options, const PackSource& source, const PackDecision& decision);

/// Puts the texels of regions, gutters and waste, and every line of what was left out, into the report.
void account(const PackInputs& inputs, const PackDecision& decision, PackResult& report);

/// Adds to the report what one page for all materials left out before: parts that are shared, and numbers.
void account_of_parts(const OnePage& of, const PackDecision& decision, PackResult& report);

/// Where the texels of a scene's material lie: its page, and each of its boxes on it.
struct BoxesOnPage {
  int page = -1;
  bool own_page = false;
  std::vector<AtlasIsland> boxes;
};

/// The boxes of a material that uses the texels of `owner`. Throws Error where they lie on several pages.
BoxesOnPage boxes_of(const PackInput& in, std::size_t owner, const PackDecision& decision);

}  // namespace etak
