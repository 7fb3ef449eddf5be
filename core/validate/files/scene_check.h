// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/judge/pixels/evidence.h"
#include "core/scene/material_uses.h"
#include "core/validate/files/load.h"
#include "core/validate/files/metal_rough.h"

namespace etak {

/// The used materials of a scene that give the same pictures: they are judged once, under all their names.
struct SceneLook {
  std::vector<int> materials;  // of the document, rising
  std::string names;           // "brass, steel"
};

/// The findings about a look, and the evidence they rest on.
struct JudgedLook {
  CheckedFile file;
  Evidence evidence;
};

/// The texels of a look.
///   use      as of texels_in_use()
///   labels   the files that findings are said to be in
struct LookTexels {
  Pictures pictures;
  std::vector<std::uint8_t> use;
  std::array<std::string, 2> labels;
};

/// Judges the materials of a scene: each on its own, on the texels that triangles read, and the header of each
/// texture once. The caller gives the texels, from the files of the scene or from the pages that the scene was
/// packed into, so that both get the same verdict.
class SceneCheck {
 public:
  /// All three outlive this.
  ///   of_scene   what findings are about that lie in no texture
  SceneCheck(const MaterialUses& uses, const TargetFile& of_scene, const PictureDoor& door);

  std::vector<SceneLook> looks() const;

  /// The pictures of a look as the scene's files have them. Throws Error.
  Pictures pictures_of(const SceneLook& look);
  /// The files that hold its colour and its F0 or metal; the scene where it has none.
  std::array<std::string, 2> labels_of(const SceneLook& look) const;

  /// Judges a look where triangles read its texels. A box in a texture has its place in UVs too.
  ///   manifest   what is said of all pictures of the scene
  JudgedLook judge(const SceneLook& look, LookTexels texels, const Manifest& manifest,
                   const Settings& settings, unsigned threads) const;

  /// Judges the header of every texture that is judged of a material, and the normal maps where rules need them.
  /// Throws Error for a picture that cannot be read.
  void judge_headers(const Manifest& manifest, const Settings& settings, CheckedFile& file);
  /// The number of those textures.
  std::size_t textures() const { return roles_.size(); }

 private:
  const GltfMaterial& lead(const SceneLook& look) const;
  SceneFacts facts_of_scene();
  std::vector<TextureDensity> densities();
  std::vector<PictureLook> picture_looks(const Settings& settings);

  const MaterialUses& uses_;
  const TargetFile& of_scene_;
  const PictureDoor& door_;
  ScenePictures pictures_;
  std::map<int, FileRole> roles_;          // by image
  std::vector<DocumentSurface> surfaces_;  // by material
};

/// Adds the findings and counts of one look to those of the scene.
void add_look(JudgedLook one, CheckedFile& file);

}  // namespace etak
