// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "core/image/image.h"
#include "core/math/mat3.h"

namespace etak {

/// Light from all directions as an octahedral map with levels, each of which holds the means over four texels of the
/// one before, weighted by their solid angles. Unlike a latitude-longitude map it has no poles, where texels are narrow,
/// and it is looked up without trigonometry, which CPU and GPU would round differently. core/light/refined.glsl says
/// where a direction lies in the picture of all levels.
class LightMap {
 public:
  LightMap() = default;

  ///   radiance   from a direction; called by all threads
  ///   side       of level 0 in texels, a power of 2
  LightMap(const std::function<Vec3(const Vec3&)>& radiance, int side, unsigned threads);

  const Image& picture() const { return picture_; }
  int side() const { return side_; }
  int last_level() const;  // it has one texel

 private:
  Image picture_;
  int side_ = 0;
};

/// An environment in the forms from which refined pictures are drawn: whole, for narrow lobes; and for wide lobes in two
/// parts, since samples of a wide lobe would miss a small bright source or blur it. The dim part is the light up to
/// the mean luminance, the rest is the bright part, which is as good as so many directional lights.
struct RefinedLight {
  LightMap whole, dim;
  // A column for each directional light, no column where nothing is bright. Row 0: where it comes from; row 1: its
  // irradiance, red, green and blue.
  Image bright;
  static constexpr int bright_count = 256;
};

///   lat_long   as class Environment says
RefinedLight refined_light(const Image& lat_long, unsigned threads);

}  // namespace etak
