// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace etak {

/// Bytes that the name of a material may have in the files of materials, manifests and projects. Every list,
/// tree and message that shows a name lays it out whole, and no person reads a longer one.
inline constexpr std::size_t most_name_bytes = 1000;

}  // namespace etak
