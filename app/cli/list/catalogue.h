// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/cli/arguments.h"
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

/// The preferred dataset's kind and what is against it: quality_text().
std::string quality_text(const CatalogueEntry& entry);

/// The flags of the entry's F0 by name: "computed;sparse" for CSV, and as a JSON array.
std::string flag_names(const CatalogueEntry& entry);
std::string json_flags(const CatalogueEntry& entry);

/// --class, which may be given more than once.
void add_class_option(Command verb, std::vector<std::string>& classes, const std::string& help);

/// Throws Error for a class that no material can have.
void check_classes(const std::vector<std::string>& classes);

}  // namespace etak::cli
