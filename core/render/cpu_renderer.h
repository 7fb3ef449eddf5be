// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

#include "core/image/image.h"
#include "core/render/environment.h"
#include "core/render/scene.h"

namespace etak {

enum class Precision { f32, f64 };

/// Called when rows of a picture are done.
///   rows     how many rows
///   worker   the index of the thread that drew them; 0 is the caller's
using RowsDone = std::function<void(std::size_t rows, unsigned worker)>;

/// Draws `scene` as struct Scene states, but without exposure and transfer: the picture holds linear
/// radiance. Throws Error for scenes that validate() refuses.
///   environment   its prefiltered light is added to that of lights and hemispheres; null: none
///   threads       the picture is the same for any number
///   precision     f32: by the vector loops of the models; f64: by their reference
///   picture       resized where it does not have the size of the scene. It gets four channels: red, green
///                 and blue over the background, and the object's coverage, by which no colour is multiplied
///   rows_done     is called by any thread
void render_cpu(const Scene& scene, const Environment* environment, unsigned threads, Precision precision,
                Image& picture, const RowsDone& rows_done = {});

/// Draws in f32 as 8-bit codes for a display: to_codes() of render_cpu()'s picture with the scene's exposure and
/// transfer, but without a picture of floats in memory. For drawing many frames.
void render_cpu_codes(const Scene& scene, const Environment* environment, unsigned threads, Image8& picture);

}  // namespace etak
