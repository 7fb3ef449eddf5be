// SPDX-License-Identifier: Apache-2.0
// The row filters for x86-64 with AVX2; see CMakeLists.txt for the flag.
#define ETAK_PNG_FILTERS png_filters_avx2
#include "core/image/files/png_filters_x86.inc"
