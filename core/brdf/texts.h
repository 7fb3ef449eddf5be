// SPDX-License-Identifier: Apache-2.0
// All formula texts of core/fresnel and core/brdf. There is no include guard: include this behind
// core/math/real_f64.h or real_f32.h in the same namespace, once for each namespace. The order matters,
// because each text uses those above it.
#include "core/fresnel/texts.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"   // no including source uses every function
#pragma GCC diagnostic ignored "-Wunused-parameter"  // entries of one kind share a signature
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
#include "core/brdf/lost_light.glsl"
#include "core/brdf/compensated.glsl"
#define ETAK_TEXTS
#include "core/brdf/models.inc"
#undef ETAK_TEXTS
// clang-format on
#pragma GCC diagnostic pop
