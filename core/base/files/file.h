// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace etak {

/// Largest text file any reader of etak takes: the largest real page is under 1 MB, so more is a mistake.
inline constexpr std::size_t max_text_bytes = std::size_t{256} << 20;

/// Reads a whole file into `out` (its capacity is reused): a regular file, or a pipe that the user named (see
/// input.h). Throws Error naming the path when it cannot be opened, is anything else, holds more than `most`
/// bytes, or more than there is memory for.
void read_file(const std::string& path, std::string& out, std::size_t most = max_text_bytes);
std::string read_file(const std::string& path, std::size_t most = max_text_bytes);

/// Writes `bytes` so that a reader sees the old file or the new one and never a part (output_file.h). Throws
/// Error when `path` exists and `overwrite` is false, or on any failure; nothing is left then.
void write_file(const std::string& path, std::string_view bytes, bool overwrite);

}  // namespace etak
