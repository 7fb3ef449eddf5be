// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/scene/gltf.h"
#include "core/validate/files.h"
#include "core/validate/target.h"

namespace etak {

/// Pictures of a document, loaded when first asked for.
class ScenePictures {
 public:
  explicit ScenePictures(const std::vector<GltfImage>& images);
  const Image8& codes(int image);
  const TextureHeader& header(int image);

 private:
  void load(int image);
  const std::vector<GltfImage>& images_;
  std::vector<Image8> codes_;
  std::vector<TextureHeader> headers_;
};

/// A material as the rules see it: diffuse + alpha, F0 + gloss (as 1 - roughness, so that what clips is the
/// file and not the conversion), and the metallic channel, all of the size of its largest texture. metallic
/// is empty for the specular-glossiness model.
LoadedPictures convert_material(const GltfMaterial& material, ScenePictures& pictures);

/// A base colour and a metal-rough file as a material; either path may be empty.
struct MetalRoughSet {
  std::vector<GltfImage> images;
  GltfMaterial material;
};
MetalRoughSet metal_rough_set(const CheckTarget& target);

}  // namespace etak
