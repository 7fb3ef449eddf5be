// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/render/environment.h"
#include "core/render/scene.h"

namespace etak {

// The light of an environment on a sphere, as the models themselves reflect it, and how far the moving picture's term
// for it is off.

/// A picture of ambient light, and an estimate of its own error.
struct AmbientTruth {
  Image picture;  // three channels; black where sphere_pixels() is false
  Image
      halves;  // the same from half of the samples, so that its difference from `picture` is the standard error
};

/// The light of `environment` alone, integrated over f_r nl of each scene's models at the middle of each pixel. The
/// scenes have the same size and gloss and are seen from the front; their directions are drawn once for all of them, by
/// the cosine, by two widths of GGX's lobe and by the environment, with the balance heuristic.
///   samples   for each pixel
std::vector<AmbientTruth> ambient_truths(std::span<const Scene> scenes, const Environment& environment,
                                         std::size_t samples, unsigned threads);

/// Errors of a picture in CIEDE2000 over sphere_pixels(), where the brightest pixel of the reference is white.
struct AmbientDifference {
  double mean = 0, p99 = 0, largest = 0;
  double noise = 0;  // the reference's own standard error, mean
};
AmbientDifference ambient_difference(const AmbientTruth& truth, const Image& shown);

}  // namespace etak
