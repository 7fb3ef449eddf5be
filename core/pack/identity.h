// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/pack/source.h"

namespace etak {

struct PackOptions;

// The layout of an atlas holds two hashes, by which an atlas in place is known to be of the same input.

/// Hash of all that decides the result, except for the bytes of the files.
std::string settings_hash(const PackOptions& options, const PackSource& source);

/// All files that are read, sorted.
std::vector<std::string> input_files(const PackOptions& options, const PackSource& source);

/// Hash of the bytes of input_files(); their names play no part.
std::string content_hash(const PackOptions& options, const PackSource& source);

}  // namespace etak
