// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/judge/pixels/tile_pass.h"

namespace etak {

/// The plan of the first pass: limits from settings and parameters, region kinds of the rules that are on.
///   has_a, has_b, has_metallic   which pictures there are
PassPlan first_plan(const CheckTarget& target, const Settings& settings, bool has_a, bool has_b,
                    bool has_metallic, unsigned workers);

/// Whether some rule needs every row of this tile in its detail already in the first pass.
bool wants_every_row(const CheckTile& tile, const Settings& settings);

/// Whether the first pass has found signs of a defect that only a second pass can decide on. The second pass
/// takes every row into the detail and looks for all plateaus of F0. A clean picture needs no second pass.
bool needs_second_look(const TileEvidence& tile, const PassPlan& plan, const Settings& settings,
                       bool has_gloss);

/// The plan of the second pass.
PassPlan second_plan(const PassPlan& first);

}  // namespace etak
