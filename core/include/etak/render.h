// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pictures of a material on a sphere or a square, on the CPU or by OpenGL without a window. Link etak::core;
// GlRunner is in etak::gl, picture files are in etak::textures (PNG) and etak::image_io (others).
//
// ```cpp
// #include <cstdio>
// #include <etak/render.h>
//
// int main() {
//   etak::Scene scene;
//   scene.surface.f0 = {1.0, 0.77, 0.34};
//   scene.surface.gloss = 0.6;
//   etak::complete_from_f0(scene.surface);
//   scene.specular = etak::find_model(etak::default_specular);
//   scene.specular_values = etak::model_values(*scene.specular, scene.surface, {});
//   scene.lights = etak::studio_lights();
//   scene.width = scene.height = 64;            // pixels
//
//   const auto studio =
//       etak::studio_environment(scene.lights.environment, scene.lights.environment_scale, 2);
//   etak::Image picture;                        // linear light: red, green, blue, coverage
//   etak::render_cpu(scene, studio.get(), 2, etak::Precision::f32, picture);
//   const etak::Image8 codes = etak::to_codes(picture, scene.exposure, scene.transfer);
//   const std::string png = etak::png_bytes(codes, {});
//   std::printf("%d x %d, a PNG file of %zu bytes\n", codes.width, codes.height, png.size());
// }
// ```
//
// Units and ranges
//   Scene        states its frame, camera, lights and units in core/render/scene.h; sides are 1 to 16384
//   exposure     linear factor, before the transfer curve to codes
//   threads      the picture is the same for any number
//   Image        rows from the top, `channels` floats a pixel; Image8 the same in 8-bit codes
//
// Errors
//   etak::Error  scenes that validate() refuses, pictures that are broken; GlRunner where there is no OpenGL
//                (GlRunner::open() gives the reason instead)

#include "core/base/error.h"
#include "core/glsl/gl_runner.h"
#include "core/image/files/png.h"
#include "core/image/image.h"
#include "core/image/image_io.h"
#include "core/render/cpu_renderer.h"
#include "core/render/display.h"
#include "core/render/environment.h"
#include "core/render/scene.h"
