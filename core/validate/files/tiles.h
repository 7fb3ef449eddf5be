// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/judge/finding.h"

namespace etak {

/// Puts findings into the order in which judge() leaves them.
void sort_findings(CheckedFile& file);

/// Adds the counts and costs of one part of a file to those of the file.
void add_sums(const CheckedFile& one, CheckedFile& file);

/// Joins the results of the tiles of a UDIM set, at least one, to one result, whose findings name their
/// tiles.
CheckedFile joined_tiles(std::vector<CheckedFile> tiles);

}  // namespace etak
