// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

#include "core/image/image.h"
#include "core/render/environment.h"
#include "core/render/scene.h"

namespace etak {

enum class Precision { f32, f64 };

/// Called when rows of a picture are done: how many, and by which worker (0 is the caller).
using RowsDone = std::function<void(std::size_t rows, unsigned worker)>;

/// Draws `scene` as struct Scene says, up to exposure and transfer: the picture holds linear radiance.
///   picture       resized where it has not the scene's size; red, green, blue over the background, and as
///                 fourth channel the object's coverage. No colour is multiplied by it
///   environment   adds its prefiltered light to lights and hemispheres; null: none
///   threads       the picture is the same for any number
///   precision     f32: the models' vector loops; f64: their reference
/// Throws Error for scenes that validate() refuses.
void render_cpu(const Scene& scene, const Environment* environment, unsigned threads, Precision precision,
                Image& picture, const RowsDone& rows_done = {});

/// The same in f32 as a display shows it: to_codes() of that picture, with the scene's exposure and transfer,
/// without the picture of floats between. For frames one after the other.
void render_cpu_codes(const Scene& scene, const Environment* environment, unsigned threads, Image8& picture);

}  // namespace etak
