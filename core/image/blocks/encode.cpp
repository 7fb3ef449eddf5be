// SPDX-License-Identifier: Apache-2.0
#include "core/image/blocks/encode.h"

namespace etak {

void encode_blocks(std::span<const BlockSource> blocks, const BlockEncoding& how, std::uint8_t* bytes,
                   float* errors) {
#ifdef ETAK_PNG_X86_64
  static const bool avx2 = (__builtin_cpu_init(), __builtin_cpu_supports("avx2") != 0);
  if (avx2) return encode_blocks_avx2(blocks, how, bytes, errors);
#endif
  encode_blocks_portable(blocks, how, bytes, errors);
}

}  // namespace etak
