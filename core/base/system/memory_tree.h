// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace etak::sys {

// What the host of a program without an operating system (WebAssembly) does with the tree of files in memory, which
// memory_nodes.h describes: before a run it puts files there, and afterwards it takes what the program wrote.

/// Removes all files and folders, closes all descriptors, and empties the three standard streams.
void empty_tree();

/// Makes a file, and the folders on the way to it, for the host to fill. A path begins at the root, with or without a
/// slash. Returns where its bytes go; null where a file is in the way.
char* put_file(const std::string& path, std::size_t size);

/// The bytes that the program reads from standard input: where the host writes them.
char* put_standard_input(std::size_t size);

/// What the program has written to standard output or standard error.
const std::string& written_to(int descriptor);

/// The files that the program has written, by their paths from the root, without a slash before them.
struct WrittenFile {
  std::string path;
  const std::string* bytes = nullptr;  // until the tree changes
};
std::vector<WrittenFile> written_files();

}  // namespace etak::sys
