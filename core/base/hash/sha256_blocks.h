// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace etak {

/// The inside of SHA-256 (FIPS 180-4, 4.2.2 and 6.2.2), for sha256.cpp and its tests: `blocks` blocks of 64
/// bytes into `state`.
extern const std::array<std::uint32_t, 64> sha256_constants;
void sha256_blocks_plain(std::array<std::uint32_t, 8>& state, const std::uint8_t* bytes, std::size_t blocks);

/// The blocks by the processor's own instructions; only where has_sha256_x86().
void sha256_blocks_x86(std::array<std::uint32_t, 8>& state, const std::uint8_t* bytes, std::size_t blocks);
bool has_sha256_x86();

}  // namespace etak
