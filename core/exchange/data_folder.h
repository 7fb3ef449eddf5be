// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace etak {

/// What etak takes a file for, by the ending of its name.
enum class DataFileKind { unknown, page, table, material };
DataFileKind data_file_kind(std::string_view path);  // .yml .yaml | .csv .tsv .txt .dat | .json
bool has_known_kind(std::string_view path);

/// The recognised files below a folder.
///   root         folder the shown paths are relative to, with a '/' at its end; of a tree of the
///                refractiveindex.info database its data folder
///   files        whole paths, sorted byte by byte
///   unreadable   one message per subfolder that could not be read
///   skipped      whole paths, sorted, of what `keep` would have listed but is no file: pipes, sockets and
///                devices
struct Folder {
  std::string root;
  std::vector<std::string> files;
  std::vector<std::string> unreadable;
  std::vector<std::string> skipped;
};

/// Lists `path` on `threads` threads; `keep` says by the name which files are listed (those of a known kind).
/// Hidden entries are left out; links to files are followed; a linked folder is entered only when nothing
/// else led there, so that no file comes twice and no loop arises. Throws Error when `path` itself cannot be
/// read.
Folder list_folder(const std::string& path, unsigned threads,
                   bool (*keep)(std::string_view name) = has_known_kind);

}  // namespace etak
