// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace etak {

/// The recognised files below a folder.
///   root         folder the shown paths are relative to, with a '/' at its end; of a tree of the
///                refractiveindex.info database its data folder
///   files        whole paths, sorted byte by byte
///   linked       those of them, sorted, that may be links or were found through one
///   unreadable   one message per subfolder that could not be read
///   skipped      whole paths, sorted, of what `keep` would have listed but is no file: pipes, sockets and
///                devices
///   hiding       folders that hold hidden entries, with '/' at the end
struct Folder {
  std::string root;
  std::vector<std::string> files;
  std::vector<std::string> linked;
  std::vector<std::string> unreadable;
  std::vector<std::string> skipped;
  std::vector<std::string> hiding;
};

/// Whether a file's name is that of a page, a table or a material file.
bool is_material_file_name(std::string_view path);

/// Lists `path` on `threads` threads; `keep` says by the name which files are listed.
/// Hidden entries are left out; links to files are followed; a linked folder is entered only when nothing
/// else led there, so that no file comes twice and no loop arises. Throws Error when `path` itself cannot be
/// read.
Folder list_folder(const std::string& path, unsigned threads,
                   bool (*keep)(std::string_view name) = is_material_file_name);

}  // namespace etak
