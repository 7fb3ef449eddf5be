// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/atlas/sources/sources.h"

namespace etak {

struct PackOptions;
class ScenePack;

// By what a result in place is known to be of the same input: two hashes that its layout holds.

/// Of everything but the bytes of the files.
std::string settings_hash(const PackOptions& options, const PackInputs& inputs);

/// All files that are read, sorted.
///   scene   null: no glTF
std::vector<std::string> input_files(const PackOptions& options, const PackInputs& inputs,
                                     const ScenePack* scene);

/// Of the bytes of input_files(), whatever they are called.
std::string content_hash(const PackOptions& options, const PackInputs& inputs, const ScenePack* scene);

}  // namespace etak
