// SPDX-License-Identifier: Apache-2.0
// No include guard: the formula texts of core/film, after core/math/real_f64.h or real_f32.h in the same namespace.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"  // not every place needs every function
#include "core/film/stack.glsl"
#pragma GCC diagnostic pop
