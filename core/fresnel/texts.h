// SPDX-License-Identifier: Apache-2.0
// No include guard: every formula text of core/fresnel, after core/math/real_f64.h or real_f32.h in the same
// namespace. The order is the meaning: each text uses those above it.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"  // not every place needs every function
// clang-format off
#include "core/fresnel/conductor.glsl"
#include "core/fresnel/dielectric.glsl"
#include "core/fresnel/schlick.glsl"
#include "core/fresnel/schueler.glsl"
#include "core/fresnel/f82.glsl"
#include "core/fresnel/spherical_gaussian.glsl"
#include "core/fresnel/lazanyi.glsl"
#include "core/fresnel/gulbrandsen.glsl"
#include "core/fresnel/from_f0.glsl"
#include "core/fresnel/by_f0.glsl"
// clang-format on
#pragma GCC diagnostic pop
