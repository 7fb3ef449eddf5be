// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/pack/blocks/compress_options.h"

namespace etak {

/// What compression did, as lines of text: of each texture its format and the worst that became of a material, and the
/// materials that miss the budget. Empty where nothing was compressed.
std::string blocks_text(const std::vector<BlockLevel>& levels);

/// The same of one level as JSON.
///   seconds   with the time that compressing took
std::string block_level_json(const BlockLevel& level, bool seconds);

}  // namespace etak
