// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/gltf.h"
#include "core/validate/files/files.h"
#include "core/validate/target.h"

namespace etak {

/// Pictures of a document, loaded when first asked for; of PNG the head alone where that is enough.
class ScenePictures {
 public:
  /// Both outlive this.
  ScenePictures(const std::vector<PictureFile>& images, const PictureDoor& door);
  const Image8& codes(int image);
  const PictureHeader& header(int image);
  /// An image that is no file's: in place of what would be loaded.
  void set(int image, Image8 codes);

 private:
  void load(int image);
  const std::vector<PictureFile>* images_;
  const PictureDoor* door_;
  std::vector<Image8> codes_;
  std::vector<PictureHeader> headers_;
};

/// A material as the rules see it: diffuse + alpha, F0 + gloss (as 1 - roughness, so that what clips is the
/// file and not the conversion), and the metallic channel, all of the size of its largest texture. metallic
/// is empty for the specular-glossiness model.
LoadedPictures convert_material(const GltfMaterial& material, ScenePictures& pictures);

/// The files of a material as one: base colour with metallic and roughness, which are single files or
/// channels of packed ones, or diffuse and specular with gloss in a file of its own. What is missing of
/// metallic, roughness and gloss is a constant. Pictures that are put together get the larger's size (the
/// texel under the centre is taken).
class MetalRoughSet {
 public:
  /// Opens nothing yet. `door` outlives this.
  MetalRoughSet(const CheckTarget& target, const PictureDoor& door);
  /// Throws Error for a file that cannot be read.
  LoadedPictures convert();
  /// The same in strips of rows, from the top whenever it is called; the three must be read in step, on any
  /// threads. No rows where a file must be loaded whole or the files differ in size.
  PictureRows rows() const;
  /// Of the n-th file of the set, in the target's order.
  const PictureHeader& header(int file) { return pictures_.header(file); }

  /// Whether it is diffuse and specular instead of base colour and metallic.
  bool is_specular() const { return material_.specular_glossiness; }

  static bool is_part(FileRole role);
  /// Whether a target is such a set.
  static bool is_set(const CheckTarget& target);

 private:
  friend class MetalRoughStrips;
  /// A channel of an image; none: the constant.
  struct Channel {
    int image = -1;
    std::size_t index = 0;
    bool inverted = false;
  };
  void add_channels(std::string_view letters, int image);
  Image8 joined(ScenePictures& pictures) const;
  LoadedPictures convert(ScenePictures& pictures) const;

  const PictureDoor* door_;
  std::vector<PictureFile> images_;
  GltfMaterial material_;
  Channel metallic_, roughness_;
  int specular_ = -1, joined_ = -1;  // images
  ScenePictures pictures_;
};

}  // namespace etak
