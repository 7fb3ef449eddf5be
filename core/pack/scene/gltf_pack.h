// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/atlas/sources/sources.h"
#include "core/atlas/texels/page_memory.h"
#include "core/pack/scene/kept_pictures.h"
#include "core/pack/scene/scene_facts.h"
#include "core/pack/totals.h"
#include "core/scene/gltf.h"
#include "core/scene/uv_use.h"

namespace etak {

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

/// A glTF scene as the packer has read it. Scene, options and pictures must stay where they are as long as the
/// functions of the inputs are called.
struct SceneRead {
  struct Entry {
    int material = -1;  // in the document
    std::optional<TexelUse> use;
    std::shared_ptr<const MaterialPair> pair;
    Image8 metallic;                   // for a check that asks for it
    std::optional<OwnMetalRough> own;  // of a material that is one texel, and of plain metal-rough form
    bool tiles = false;                // on a page of its own
    bool exact = true;   // as diffuse and F0 the material is what it was, but for the rounding of codes
    double clamped = 0;  // percent of the texels whose gloss was brought back to 0..1
    std::vector<std::string> remarks;  // from the thread that learned it
  };

  /// A picture that is written as less than its file.
  struct LightPicture {
    std::optional<OneTexel> texel;  // none: its file, of what that says of texels alone
    TextureTotals totals;
  };

  const PackOptions& options;
  GlossForm gloss = GlossForm::one_minus_roughness;
  GltfScene scene;
  std::optional<MaterialUses> uses = {};   // of the scene
  PackInputs inputs = {};                  // the materials that are packed
  std::vector<Entry> entries = {};         // beside the inputs
  std::vector<std::string> remarks = {};   // what had to be said of the materials
  std::vector<int> stands_for = {};        // by image: the first of the same bytes
  std::map<int, LightPicture> light = {};  // by image that stands for itself, where its file can do with less
  mutable std::map<int, PictureHeader> headers = {};  // by image, of those that were asked for

  const GltfMaterial& material(const Entry& entry) const {
    return scene.materials[static_cast<std::size_t>(entry.material)];
  }
  bool is_used(const Entry& entry) const {
    return scene.material_used[static_cast<std::size_t>(entry.material)];
  }
  const PictureFile& file(int image) const { return scene.images[static_cast<std::size_t>(image)]; }
  /// The name of a material of the document in remarks.
  static std::string label(const GltfMaterial& m, std::string_view between);

  /// Pictures of the document.
  Picture decoded(int image) const;
  const PictureHeader& header(int image) const;
  TextureTotals image_totals(int image) const;

  /// What the image takes beside the written scene, where no page has it: one texel may stand for it.
  TextureTotals kept_totals(int image) const;
  /// The totals of images of the document, each file once.
  TextureTotals input_totals(const std::vector<bool>& images) const;
  TextureTotals kept_totals(const std::vector<bool>& images) const;

  /// What the textures that the pages replace take on a GPU: those of colour, metal, roughness, F0 and gloss
  /// that are read.
  std::uint64_t replaced_gpu_bytes() const;

  /// Mips that the scene's samplers read, where pages hold `levels` (0: all).
  int sampled_levels(int levels) const;

  /// Whether scene.gltf is among the files that are asked for.
  bool writes_scene() const;

  /// What PackCheckHooks::scene is told; where that is not set, metallic is empty.
  PackedScene packed() const;
};

/// Reads the scene, converts every reached material to diffuse/specular and learns which of its texels are in
/// use. Throws Error.
std::unique_ptr<const SceneRead> read_scene(const std::string& path, const PackOptions& options);

}  // namespace etak
