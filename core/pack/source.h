// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/atlas/sources/sources.h"
#include "core/pack/scene/gltf_pack.h"

namespace etak {

struct OnePage;  // core/pack/one_page.h
struct PackManifest;
struct PackOptions;

/// What is packed, as it was read.
struct PackSource {
  PackInputs inputs;
  std::unique_ptr<const SceneRead> scene;  // null: no glTF
  // What the materials read of `inputs` where one page holds all of them: `inputs` are their shared parts then. Null:
  // `inputs` are the materials.
  std::shared_ptr<const OnePage> one_page;

  /// The materials as they were read.
  const std::vector<PackInput>& materials() const;
};

/// The materials of a folder, by options.input.pattern, or by the conventions of names where there is none. A folder all
/// of whose known names follow default_pattern, whose gloss is Schueler's, is read by that.
///   remarks   gets what was skipped or left out
///   pattern   gets the pattern that was taken; empty: none
inline constexpr const char* default_pattern = "{name}_{role}.png";
AtlasManifest manifest_in_folder(const std::string& folder, const PackOptions& options,
                                 std::vector<std::string>& remarks, std::string& pattern);

/// Reads a manifest, a folder or a glTF scene. Throws Error, also for options that say nothing of such an
/// input.
///   manifest   null: the file or folder `input` is packed
PackSource read_source(const std::string& input, const PackManifest* manifest, const PackOptions& options,
                       const MaterialLibrary& library);

}  // namespace etak
