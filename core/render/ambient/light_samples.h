// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/image/image.h"
#include "core/math/mat3.h"

namespace etak {

/// An environment as refined pictures see it. Samples of a wide lobe (lobe_samples.h) would blur what is small and bright,
/// or see it from below the horizon; so they see light up to four times the mean luminance, and the rest comes as directional
/// lights.
struct LightSamples {
  static constexpr int tile = 322;
  Image stack;       // stacked() maps of the levels of samples, from sharpest_sample to dullest_sample
  Image irradiance;  // as that of class Environment
  struct Bright {
    Vec3 from, irradiance;  // where it comes from, a unit vector; on a plane that faces it
  };
  std::vector<Bright> bright;

  Vec3 irradiance_at(const Vec3& n) const;
};
inline constexpr int bright_count = 128;

///   lat_long       a map of radiance, as class Environment says
///   bright_apart   whether `stack` and `irradiance` are without the bright part; else there is none
LightSamples light_samples(const Image& lat_long, bool bright_apart, unsigned threads);

}  // namespace etak
