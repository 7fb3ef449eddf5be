// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "core/atlas/pack/scene/gltf_pack.h"
#include "core/atlas/sources/sources.h"

namespace etak {

struct OnePage;  // core/atlas/pack/one_page.h
struct PackManifest;
struct PackOptions;

/// What is packed, as it was read.
struct PackSource {
  PackInputs inputs;
  std::unique_ptr<const SceneRead> scene;  // null: no glTF
  // Of one page for all materials: what they read of `inputs`, which hold their shared parts then. Null: `inputs` are
  // the materials.
  std::shared_ptr<const OnePage> one_page;

  /// The materials as they were read.
  const std::vector<PackInput>& materials() const;
};

/// Reads a manifest, a folder or a glTF scene. Throws Error, also for options that say nothing of such an
/// input.
///   manifest   null: the file or folder `input` is packed
PackSource read_source(const std::string& input, const PackManifest* manifest, const PackOptions& options,
                       const MaterialLibrary& library);

}  // namespace etak
