// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "core/render/scene.h"

namespace etak {

/// The largest side of a texture in a scene, in texels.
inline constexpr int max_scene_texture = 4096;

/// Pictures in linear light that are laid over a surface; null: none.
///   body        diffuse colour and, where there is a fourth channel, opacity
///   gloss       F0 and, where there is a fourth channel, gloss
///   emission    three channels, of at least 0
///   occlusion   one channel, 0 to 1
struct SurfacePictures {
  const Image *body = nullptr, *gloss = nullptr, *emission = nullptr, *occlusion = nullptr;
};

/// The textures of a scene, which hold what the pictures do. Large pictures take time. Throws Error for pictures of
/// fewer channels than said above and for a `side` outside of 1..max_scene_texture.
///   side   larger pictures are shrunk to this, in texels
std::shared_ptr<const SurfaceTextures> surface_textures(const SurfacePictures& pictures, int side = 1024);

/// Adds the textures with half the sides, with those of half of these, and so on to a few texels. Each texel is the mean of
/// up to four.
void add_halves(SurfaceTextures& textures);

/// The textures of a scene, or the half of them whose texels are about as large as a pixel in the middle of the object. CPU
/// and GPU draw with the same ones, so that textures that repeat often, or are seen from far away, do not flicker.
std::shared_ptr<const SurfaceTextures> textures_for_pixels(const Scene& scene);

/// Emission and occlusion as one texture, in the size of the larger picture; each is 1 where its picture is null.
Image emission_texture(const Image* emission, const Image* occlusion);

/// The textures that have texels, by the names of their samplers in shaders.
std::vector<std::pair<const char*, const Image*>> samplers_of(const SurfaceTextures& textures);

/// The channels of a texture at u, v (0 to 1 from the top left corner), bilinear with repeated edges.
std::array<double, 4> texel(const Image& texture, double u, double v);

/// The u and v of a position on an object. The quad shows the texture as it is when seen from the front; on
/// the sphere it lies in latitude and longitude, with its middle at +z.
std::array<double, 2> texture_place(Shape shape, const Vec3& position);

/// What the surface sends out by itself at a place in its textures (u and v) and, as the fourth number, the share of the
/// light of hemispheres and environment that reaches it there.
std::array<double, 4> emission_at(const Scene& scene, const std::array<double, 2>& place);

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
