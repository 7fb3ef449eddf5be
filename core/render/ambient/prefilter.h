// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/image/image.h"
#include "core/math/mat3.h"

namespace etak {

// Latitude-longitude maps of radiance, as class Environment says, seen through round lobes and as irradiance.

/// `map`, or the same with `width` columns where it has more.
Image at_most(const Image& map, int width);

/// The irradiance on planes of all normals, 64 columns wide.
Image irradiance_of(const Image& map, unsigned threads);

/// The mean radiance through the round lobe (round_lobe.h) of a gloss; above 1 for lobes that are narrower than that of 1.
///   widest   columns of the result at most, a power of 2
///   most     columns of `map` that are read at most
Image lobe_map(const Image& map, double gloss, double widest, unsigned threads, int most);

/// Maps below each other, as octahedral maps (octahedral_place() of core/light/ambient.glsl), each with a border of one
/// texel that continues it.
///   tile   columns and rows of a map with its border
Image stacked(const std::vector<const Image*>& levels, int tile, unsigned threads);

/// The value in direction `r`, of any length but 0, of a picture of stacked(), linear between its maps.
///   level   place in the stack, from 0
Vec3 in_stack(const Image& stack, int tile, const Vec3& r, double level);

}  // namespace etak
