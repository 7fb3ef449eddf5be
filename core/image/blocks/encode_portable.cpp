// SPDX-License-Identifier: Apache-2.0
// The encoders with four blocks at a time, for every processor; encode.cpp chooses at run time.
#define ETAK_ENCODE_BLOCKS encode_blocks_portable
#define ETAK_BLOCK_LANES 4
#include "core/image/blocks/encode_lanes.inc"
