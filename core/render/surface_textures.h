// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/render/scene.h"

namespace etak {

/// The largest side of a texture in a scene, in texels.
inline constexpr int max_scene_texture = 4096;

/// The textures of a scene, made from pictures in linear light. Large pictures take time. Throws Error for
/// pictures of fewer than three channels and for a `side` outside of 1..max_scene_texture.
///   body      diffuse colour and opacity; null: one texel with the surface's values
///   gloss     F0 and gloss; null: one texel with the surface's values
///   surface   its opacity or gloss is the fourth channel of pictures that have three
///   side      larger pictures are shrunk to this, in texels
std::shared_ptr<const SurfaceTextures> surface_textures(const Image* body, const Image* gloss,
                                                        const SurfaceValues& surface, int side = 1024);

/// The four channels of a texture at u, v (0 to 1 from the top left corner), bilinear with repeated edges.
std::array<double, 4> texel(const Image& texture, double u, double v);

/// The u and v of a position on an object. The quad shows the texture as it is when seen from the front; on
/// the sphere it lies in latitude and longitude, with its middle at +z.
std::array<double, 2> texture_place(Shape shape, const Vec3& position);

/// The values of a model's parameters at a texel.
class TexturedValues {
 public:
  ///   values   of all parameters; those that follow the texture are replaced
  TexturedValues(const Model& model, std::vector<double> values);

  /// The values at a texel, valid until the next call. Diffuse colours are multiplied by the opacity.
  ///   body    diffuse colour and opacity of the texel
  ///   gloss   F0 and gloss of the texel
  const double* at(const std::array<double, 4>& body, const std::array<double, 4>& gloss);

 private:
  const Model& model_;
  std::vector<double> values_;
};

/// Whether the value of a parameter comes from the texture: diffuse colours, F0, and widths. In models that
/// derive numbers from their parameters, widths do not follow the texture.
bool follows_texture(const Model& model, const Parameter& parameter);

/// Whether the width of the model's lobe comes from the texture.
bool width_follows_texture(const Model& model);

}  // namespace etak
