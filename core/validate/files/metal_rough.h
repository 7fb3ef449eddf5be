// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/judge/pixels/evidence.h"
#include "core/judge/target.h"
#include "core/maps/map_evidence.h"
#include "core/scene/gltf.h"
#include "core/validate/files/load.h"

namespace etak {

/// The pictures of a scene, loaded when they are first needed; of PNG the header alone where that is enough.
class ScenePictures {
 public:
  /// Images and door must outlive this object.
  ScenePictures(const std::vector<PictureFile>& images, const PictureDoor& door);
  const Image8& codes(int image);
  const PictureHeader& header(int image);
  /// Sets the codes of an image that has no file.
  void set(int image, Image8 codes);

 private:
  void load(int image);
  const std::vector<PictureFile>* images_;
  const PictureDoor* door_;
  std::vector<Image8> codes_;
  std::vector<PictureHeader> headers_;
};

/// A material as the rules see it: diffuse + alpha, F0 + gloss (as 1 - roughness, so that values clip in the
/// file only and not by the conversion), and the metallic channel, all of the size of its largest texture.
/// metallic is empty for the specular-glossiness model.
Pictures convert_material(const GltfMaterial& material, ScenePictures& pictures);

/// The files of a material as one: base colour with metallic and roughness, which are single files or
/// channels of packed ones, or diffuse and specular with gloss in a file of its own. A constant replaces
/// metallic, roughness or gloss where it is missing. Pictures that are joined get the size of the larger one
/// (the texel under the centre is taken).
class MetalRoughSet {
 public:
  /// Opens no file yet. `door` must outlive this object.
  MetalRoughSet(const CheckTarget& target, const PictureDoor& door);
  /// The converted pictures, whole. Throws Error for a file that cannot be read.
  Pictures convert();
  /// The converted pictures in strips of rows; each call begins at the top. The three sources must be read in
  /// step, on any threads. No source where a file must be loaded whole or the files differ in size.
  PictureRows rows();
  /// What the occlusion of a packed picture came to in the last convert(), or in the last rows() that were
  /// read: its codes, and the file's place in the target's order. None where no picture says that it holds
  /// occlusion.
  struct Occlusion {
    std::size_t file = 0, channel = 0;
    GreyFacts codes;
  };
  const Occlusion* occlusion() const { return occlusion_.get(); }
  /// The codes of the n-th file by the same reading; null: it was not read.
  const DataCodes* data(std::size_t file) const;
  /// The header of the n-th file of the set, in the target's order.
  const PictureHeader& header(int file) { return pictures_.header(file); }

  /// Whether it is diffuse and specular instead of base colour and metallic.
  bool is_specular() const { return material_.specular_glossiness; }

  /// Whether a file of this role makes a target such a set.
  static bool is_part(FileRole role);
  /// Whether a target is such a set.
  static bool is_set(const CheckTarget& target);

 private:
  friend class MetalRoughStrips;
  /// A channel of an image; without an image a constant.
  struct Channel {
    int image = -1;
    std::size_t index = 0;
    bool inverted = false;
  };
  void count_codes(std::size_t image, const Image8& codes, int first_row, int height) const;
  void add_channels(std::string_view letters, int image);
  Image8 joined(ScenePictures& pictures) const;
  Pictures convert(ScenePictures& pictures) const;

  const PictureDoor* door_;
  std::vector<PictureFile> images_;
  std::vector<bool> is_data_;  // of each file
  GltfMaterial material_;
  Channel metallic_, roughness_;
  int specular_ = -1, joined_ = -1;  // indices of images; -1: none
  std::shared_ptr<Occlusion> occlusion_;
  std::shared_ptr<std::vector<DataCodes>> data_;  // of each file
  ScenePictures pictures_;
};

}  // namespace etak
