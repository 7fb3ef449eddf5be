// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace etak {

/// The chunks of a binary glTF, as views into its bytes.
struct GlbParts {
  std::string_view json;
  std::optional<std::string_view> binary;
};

/// Whether the bytes begin as a binary glTF does.
bool is_glb(std::string_view bytes);

/// Takes a binary glTF apart (container version 2): JSON first, then at most one BIN chunk, then unknown
/// ones, which are passed over. Throws Error for any length that does not fit.
GlbParts split_glb(std::string_view bytes, std::string_view file);

/// The binary glTF of these two chunks. Throws Error that names `file` for more than 4 GiB.
std::string joined_glb(std::string json, std::string binary, std::string_view file);

}  // namespace etak
