// SPDX-License-Identifier: Apache-2.0
// No include guard: every formula text of core/light, after core/fresnel/texts.h in the same namespace.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"  // not every place needs every function
#include "core/light/hemispheres.glsl"
#include "core/light/lights.glsl"
#include "core/light/marks.glsl"
#include "core/light/transfer.glsl"
#include "core/light/transparency.glsl"
#pragma GCC diagnostic pop
