// SPDX-License-Identifier: Apache-2.0
// All formula texts of core/light; each uses those above it. There is no include guard: include this behind
// core/fresnel/texts.h in the same namespace.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"  // no including source uses every function
// clang-format off
#include "core/light/lights.glsl"
#include "core/light/area.glsl"
#include "core/light/hemispheres.glsl"
#include "core/light/ambient.glsl"
#include "core/light/transparency.glsl"
#include "core/light/clear_ball.glsl"
#include "core/light/ground.glsl"
#include "core/light/transfer.glsl"
#include "core/light/tone.glsl"
#include "core/light/marks.glsl"
#include "core/light/false_color.glsl"
// clang-format on
#pragma GCC diagnostic pop
