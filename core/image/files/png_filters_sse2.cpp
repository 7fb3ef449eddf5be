// SPDX-License-Identifier: Apache-2.0
// The row filters for any x86-64: SSE2 is part of it.
#define ETAK_PNG_FILTERS png_filters_sse2
#include "core/image/files/png_filters_x86.inc"
