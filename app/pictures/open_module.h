// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace etak {

/// A module of doors.h that was looked for.
///   table   what the module's function returned; null: `fault` says why
struct OpenedModule {
  const void* table = nullptr;
  std::string fault;
};

/// Opens a module, which is never closed, and calls its function without parameters.
///   candidates   absolute paths, of which the first that may be read is taken
///   function     its name; it returns a pointer to a table that begins with a PictureDoors
///   version      of the program
OpenedModule open_module(std::span<const std::string> candidates, const char* function,
                         std::string_view version);

}  // namespace etak
