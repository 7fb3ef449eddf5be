// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/material/f0.h"
#include "core/material/library.h"

namespace etak::cli {

/// A library material with the F0 of its preferred dataset.
struct CatalogueEntry {
  Material material;
  F0Result result;
};

/// All materials of the library in the order of their ids, solved on `threads` threads.
std::vector<CatalogueEntry> catalogue(const MaterialLibrary& library, const F0Solver& solver,
                                      unsigned threads);

}  // namespace etak::cli
