// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>

namespace etak::rects {

// Eight numbers at a time through the compiler's vector types: plain C++ wherever these have no registers.
// Only for use inside one function; LANES_FUNCTION compiles it for AVX2 too and picks at run time.

using Lanes [[gnu::vector_size(32)]] = int;
inline constexpr int lane_count = 8;

// Not under the thread sanitizer, which is not ready yet when the choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define LANES_FUNCTION __attribute__((target_clones("default", "avx2")))
#else
#define LANES_FUNCTION
#endif

}  // namespace etak::rects
