// SPDX-License-Identifier: Apache-2.0
// No include guard: every formula text of core/light, after core/fresnel/texts.h in the same namespace, in
// order of use.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"  // not every place needs every function
// clang-format off
#include "core/light/lights.glsl"
#include "core/light/hemispheres.glsl"
#include "core/light/transparency.glsl"
#include "core/light/transfer.glsl"
#include "core/light/tone.glsl"
#include "core/light/marks.glsl"
// clang-format on
#pragma GCC diagnostic pop
