// SPDX-License-Identifier: Apache-2.0
// No include guard: every formula text of core/fresnel, after core/math/real_f64.h or real_f32.h in the same
// namespace.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"  // not every place needs every function
#define ETAK_TEXTS
#include "core/fresnel/terms.inc"
#undef ETAK_TEXTS
#pragma GCC diagnostic pop
