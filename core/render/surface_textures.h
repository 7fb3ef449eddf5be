// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/render/scene.h"

namespace etak {

/// Largest side of a texture that a scene shows.
inline constexpr int max_scene_texture = 4096;

/// A texture pair as a scene takes it: pictures of four channels in linear light, shrunk to at most `side`;
/// where one is missing (null), a pixel of the surface's own values. Pictures of three channels get the
/// surface's opacity or gloss. Takes time with large pictures.
std::shared_ptr<const SurfaceTextures> surface_textures(const Image* body, const Image* gloss,
                                                        const SurfaceValues& surface, int side = 1024);

/// A texture's four channels at u, v (0 to 1 from the left upper corner): bilinear, edges repeated.
std::array<double, 4> texel(const Image& texture, double u, double v);

/// The place in a texture that lies on an object: on the quad as seen from the front, on the sphere lat-long
/// with the middle towards +z.
std::array<double, 2> texture_place(Shape shape, const Vec3& position);

/// How a model's parameters follow a texture: what `values` (one number per parameter and channel) are at a
/// texel.
class TexturedValues {
 public:
  TexturedValues(const Model& model, std::vector<double> values);

  /// Diffuse colours come times the opacity.
  const double* at(const std::array<double, 4>& body, const std::array<double, 4>& gloss);

 private:
  const Model& model_;
  std::vector<double> values_;
};

/// Whether a parameter follows the texture. A width does not where the model derives numbers from its
/// parameters.
bool follows_texture(const Model& model, const Parameter& parameter);

}  // namespace etak
