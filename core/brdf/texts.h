// SPDX-License-Identifier: Apache-2.0
// No include guard: every formula text of core/fresnel and core/brdf, after core/math/real_f64.h or real_f32.h
// in the same namespace. The order is the meaning: each text uses those above it.
#include "core/fresnel/texts.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"   // not every place needs every function
#pragma GCC diagnostic ignored "-Wunused-parameter"  // entries of one kind have one signature
// clang-format off
#include "core/brdf/geometry.glsl"
#include "core/brdf/gloss.glsl"
#include "core/brdf/d_ggx.glsl"
#include "core/brdf/d_beckmann.glsl"
#include "core/brdf/d_phong.glsl"
#include "core/brdf/d_abc.glsl"
#include "core/brdf/d_sgd.glsl"
#include "core/brdf/g_cook_torrance.glsl"
#include "core/brdf/g_simple.glsl"
#include "core/brdf/g_smith_ggx.glsl"
#include "core/brdf/g_smith_beckmann.glsl"
#include "core/brdf/microfacet.glsl"
#define ETAK_TEXTS
#include "core/brdf/models.inc"
#undef ETAK_TEXTS
// clang-format on
#pragma GCC diagnostic pop
