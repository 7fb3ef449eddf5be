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

struct PackDecision;
struct PackOptions;

/// A glTF scene as input and output of the packer.
class ScenePack {
 public:
  /// Reads the scene, converts every reached material to diffuse/specular and learns which of its texels are
  /// in use. Throws Error.
  ScenePack(const std::string& path, const PackOptions& options);
  ~ScenePack();

  /// The materials that are packed.
  PackInputs inputs();

  /// Mips that the scene's samplers read, where pages hold `levels` (0: all).
  int sampled_levels(int levels) const;

  void add_files(std::vector<std::string>& files) const;
  void add_remarks(std::vector<std::string>& remarks) const;

  /// Writes the further textures that the forms of the written glTF need, such as roughness.
  void write_page(OutputFolder& folder, int page, const PagePixels& pixels, const WriteOptions& options);

  /// Writes scene.gltf, its buffer and the files that it refers to; returns their names, without the pages'
  /// own.
  std::vector<std::string> write_scene(OutputFolder& folder, const AtlasLayout& layout,
                                       const PackDecision& decision);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace etak
