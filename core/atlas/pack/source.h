// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "core/atlas/pack/scene/gltf_pack.h"
#include "core/atlas/sources/sources.h"

namespace etak {

struct PackManifest;
struct PackOptions;

/// What is packed, as it was read.
struct PackSource {
  PackInputs inputs;
  std::unique_ptr<ScenePack> scene;  // null: no glTF
};

/// Reads a manifest, a folder or a glTF scene. Throws Error, also for options that say nothing of such an
/// input.
///   manifest   null: the file or folder `input` is packed
PackSource read_source(const std::string& input, const PackManifest* manifest, const PackOptions& options,
                       const MaterialLibrary& library);

}  // namespace etak
