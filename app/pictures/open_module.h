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

/// Opens the module `file`, which lies beside the program in a build tree and in lib/etak where etak is installed. It
/// is looked for in no other place, such as the working folder or the search path of the loader: a file of its name there
/// may be anybody's.
///   from_bin   the folder of the installed modules, relative to that of the program
OpenedModule open_module_of_program(const std::string& file, const std::string& from_bin,
                                    const char* function, std::string_view version);

}  // namespace etak
