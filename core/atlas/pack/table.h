// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/atlas/layout.h"
#include "core/atlas/pack/decision.h"
#include "core/atlas/sources/sources.h"

namespace etak {

struct PackOptions;
struct PackReport;

// What is told of a decision: the layout's table for who reads the atlas, and the account of what was left
// out for who packed it.

/// The layout without its hashes.
///   scene   the materials are those of a glTF
AtlasLayout layout_table(const PackOptions& options, const PackInputs& inputs, const PackDecision& decision,
                         bool scene);

/// Texels of regions, gutters and waste, and every line of what was left out.
void account(const PackInputs& inputs, PackDecision& decision, PackReport& report);

}  // namespace etak
