// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace etak::cli {

/// Replaces the running `etak` by `etak-image` with the same arguments, and never returns. `etak` must start
/// in milliseconds, so what needs OpenColorIO or OpenImageIO runs there; call it before any input is read.
/// Throws Error at `place` where that program is missing.
///   found      what was asked for, "X is no built-in space"
///   expected   what would do instead
[[noreturn]] void become_image_program(const std::string& place, const std::string& found,
                                       const std::string& expected);

/// The same for another program beside it: `etak-pack` reads and writes PNG, KTX2 and DDS, and links no more
/// than the compressors.
[[noreturn]] void become_companion(const std::string& program, const std::string& place,
                                   const std::string& found, const std::string& expected);

}  // namespace etak::cli
