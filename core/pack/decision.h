// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/atlas/layout.h"
#include "core/atlas/leave_out.h"
#include "core/atlas/outline_pieces.h"
#include "core/atlas/plan.h"
#include "core/atlas/texels/compose.h"
#include "core/atlas/texels/resolution.h"
#include "core/pack/source.h"
#include "core/pack/totals.h"

namespace etak {

struct PackOptions;

/// Mips of a page, level 0 among them.
struct PageLevels {
  int offered = 1;  // by the settings
  int kept = 1;     // of those the ones that a sampler reads, and in which some region has a texel of its own
};

/// The sizes of the PNG files that the pictures of a decision's pages would become, by the names of the files, in every
/// form that may be written for one of Others.
///   bare   the sizes without occlusion, of pictures that have it in their red channel
struct PictureSizes {
  std::map<std::string, TextureTotals> files, bare;
};

/// What an atlas is to hold and where it goes.
struct PackDecision {
  bool islands = false;                 // texels between islands are left out; see decide()
  bool outlines = false;                // of islands: each keeps its own texels alone
  bool whole = false;                   // each picture lies whole on a page of its own; see decide()
  std::optional<int> gutter;            // texels around each region; none: from the mips
  LeaveOut left_out;                    // its fates: by material
  std::vector<Region> parts;            // the texels that are not left out
  PlacedRegions needed;                 // the same as they are stored, where the plan puts them
  std::vector<Region> regions;          // these with outlines in pieces (outline_pieces.h)
  std::vector<Resolution> resolutions;  // by part: with how many texels it is stored
  PackingPlan plan;                     // its places: by region
  std::vector<PageLevels> levels;       // by page
  // The weights of the pictures, for each of Others; none where files are not weighed.
  std::optional<std::array<PictureSizes, 2>> sizes;
  std::vector<GoalCost> other_goals;  // the same; see other_goals()
};

/// What becomes of a scene's materials that are not of plain metal-rough form.
///   written   they are written in the form that is asked for
///   stay      beside plain ones they stay as they are, with their own textures and UVs
enum class Others { written, stay };

/// Resolutions that were found, by all that they depend on: looking for one takes the material's texels.
using FoundResolutions = std::map<std::array<int, 8>, Resolution>;

/// Decides of all materials together, from the facts that are known of them: what is left out, which regions
/// the other texels are, with how many texels those are stored, and where they lie. Throws Error for a region
/// that fits no page.
///   previous   null: none
///   found      is looked up and added to
///   returns    one decision, with the islands that are asked for only if the pages get smaller by them, and of
///              these with their outlines only if that is smaller than with their boxes;
///              where files are to be weighed, those with and without islands. Where the pages of a scene would
///              take more than the textures that they replace, for the gutters around small pictures, each
///              picture lies whole on a page of its own if that takes less; not where a form of pages, gutters
///              or an earlier layout were asked for
std::vector<PackDecision> decide(const PackOptions& options, const PackSource& source,
                                 const AtlasLayout* previous, FoundResolutions& found);

/// Whether the files are to be weighed that a scene's pages would become, and not their texels alone.
bool weighs_files(const PackOptions& options, const PackSource& source);

/// Takes what the texels taught into the facts of the materials, and into the decision what is left out by
/// these facts. False where other regions are needed by them: then decide() must be called again.
///   learned   by material
bool learn(const std::vector<Learned>& learned, const PackOptions& options, PackSource& source,
           PackDecision& decision);

}  // namespace etak
