// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/atlas/compose.h"
#include "core/atlas/layout.h"
#include "core/atlas/outputs.h"
#include "core/atlas/sources/sources.h"
#include "core/base/files/output_folder.h"
#include "core/scene/gltf.h"

namespace etak {

class PackDecision;
struct PackOptions;

/// A glTF scene as input and output of the packer.
class ScenePack {
 public:
  /// Reads the scene, converts every reached material to diffuse/specular and learns which of its texels are
  /// in use. Throws Error.
  ScenePack(const std::string& path, const PackOptions& options);
  ~ScenePack();

  /// The materials, once.
  PackInputs inputs();

  /// Mips that the scene's samplers read, where pages hold `levels` (0: all).
  int sampled_levels(int levels) const;

  void add_files(std::vector<std::string>& files) const;
  void add_remarks(std::vector<std::string>& remarks) const;

  /// The third texture that plain glTF needs: G = roughness, B = 0.
  void write_page(OutputFolder& folder, int page, const PagePixels& pixels, const WriteOptions& options);

  /// scene.gltf and its buffer; returns the names of all files it stands on beside the pages' own.
  std::vector<std::string> write_scene(OutputFolder& folder, const AtlasLayout& layout,
                                       const PackDecision& decision);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace etak
