// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/atlas/pack/source.h"

namespace etak {

struct PackOptions;

// By what a result in place is known to be of the same input: two hashes that its layout holds.

/// Of everything but the bytes of the files.
std::string settings_hash(const PackOptions& options, const PackInputs& inputs);

/// All files that are read, sorted.
std::vector<std::string> input_files(const PackOptions& options, const PackSource& source);

/// Of the bytes of input_files(), whatever they are called.
std::string content_hash(const PackOptions& options, const PackSource& source);

}  // namespace etak
