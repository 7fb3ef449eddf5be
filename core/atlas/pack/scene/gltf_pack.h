// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/atlas/layout.h"
#include "core/atlas/outputs.h"
#include "core/atlas/pack/totals.h"
#include "core/atlas/sources/sources.h"
#include "core/atlas/texels/compose.h"
#include "core/base/files/output_folder.h"
#include "core/scene/gltf.h"
#include "core/scene/uv_use.h"

namespace etak {

struct PackDecision;
struct PackOptions;

/// A scene that is packed, as a check of its pages sees it. Lives until pack() returns.
struct PackedScene {
  struct Material {
    std::string name;                    // in the layout
    const MaterialPair* pair = nullptr;  // as the scene's own files give it, whole
    const TexelUse* use = nullptr;       // of the pair's texels; null: not known
    const Image8* metallic = nullptr;    // beside the pair, as of scene_metallic()
  };
  const MaterialUses* uses = nullptr;
  std::map<int, Material> materials;  // those that are packed, by their index in the document
};

/// A glTF scene as input and output of the packer.
class ScenePack {
 public:
  /// Reads the scene, converts every reached material to diffuse/specular and learns which of its texels are
  /// in use. Throws Error.
  ScenePack(const std::string& path, const PackOptions& options);
  ~ScenePack();

  const GltfScene& scene() const;

  /// The materials that are packed.
  PackInputs inputs();

  /// What PackCheckHooks::scene is told; where that is not set, metallic is empty.
  PackedScene packed() const;

  /// Mips that the scene's samplers read, where pages hold `levels` (0: all).
  int sampled_levels(int levels) const;

  void add_files(std::vector<std::string>& files) const;
  void add_remarks(std::vector<std::string>& remarks) const;

  /// What the textures that the pages replace take on a GPU: those of colour, metal, roughness, F0 and gloss
  /// that are read.
  std::uint64_t replaced_gpu_bytes() const;

  /// Whether scene.gltf is among the files that are asked for.
  bool writes_scene() const;

  /// Adds to the decision's sizes, which are there, what the scene's pictures of a page would take as files.
  void weigh_page(int page, const PagePixels& pixels, PackDecision& decision, const WriteOptions& options);

  /// Which of the scene's other textures are placed on the pages, what each form would take, and where the
  /// smallest is asked for, which it is. Before pages are written, of the decision they are written by.
  /// Returns the weight of what scene.gltf will read; 0 where none is written.
  double choose_pictures(const PackDecision& decision);
  /// What the textures that scene.gltf reads would take in each form. Empty before choose_pictures(), and where
  /// no scene is written.
  const std::vector<FormCost>& form_costs() const;

  /// The pictures of a page that the scene reads beside the page's two textures.
  void write_page(OutputFolder& folder, int page, const PagePixels& pixels, const PackDecision& decision,
                  const WriteOptions& options);

  /// Writes scene.gltf, its buffer and the files that it refers to; returns their names, without the pages'
  /// own.
  std::vector<std::string> write_scene(OutputFolder& folder, const AtlasLayout& layout);

  struct State;

 private:
  std::unique_ptr<State> state_;
};

}  // namespace etak
