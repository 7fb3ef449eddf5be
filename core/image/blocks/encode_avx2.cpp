// SPDX-License-Identifier: Apache-2.0
// The encoders with eight blocks at a time, for x86-64 with AVX2; see CMakeLists.txt for the flag.
#define ETAK_ENCODE_BLOCKS encode_blocks_avx2
#define ETAK_BLOCK_LANES 8
#include "core/image/blocks/encode_lanes.inc"
