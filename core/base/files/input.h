// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/files/descriptor.h"

namespace etak {

// The one door to everything that is read. What may be opened:
//   regular files   always
//   pipes           only those that the user named (accept_input): standard input, /dev/fd/N as the shell's
//                   <(...) gives it, named pipes. A pipe can be read once, so its bytes are kept in memory
//                   from the first look on, and it can be opened as often as a file
//   anything else   never: folders, sockets, other devices. A pipe that another file names, or that lies in
//                   a folder, is refused as well, because nobody promised that something writes to it

/// How paths and messages call standard input.
inline constexpr std::string_view stdin_name = "<stdin>";

/// Takes `typed` as an input that the user named, and returns the path to open it by: "<stdin>" for "-",
/// /dev/stdin and /dev/fd/0, "<fd 63>" for /dev/fd/63, else `typed` itself, on Windows with '/' for '\'. Names that such
/// an input holds are thereby relative to the working folder. Throws Error when standard input is named a second time.
std::string accept_input(const std::string& typed);

/// What accept_input() was given.
std::vector<std::string> accepted_inputs();

/// Forgets the names that accept_input() was called with, where a process reads several command lines one after another.
void forget_inputs();

/// The path of accept_input() as it is typed: "-" for "<stdin>", "/dev/fd/63" for "<fd 63>".
std::string typed_input(const std::string& path);

/// Whether `path` is an accepted pipe, or standard input or a descriptor whatever lies behind it: its name
/// tells no kind and it lies in no folder.
bool is_pipe_input(const std::string& path);

/// A remark about entries that a search of a folder has left out, because they are no regular files; empty
/// where `skipped` is.
std::string skipped_remark(const std::vector<std::string>& skipped);

/// How long to wait for the first byte of a pipe, in seconds (default 60); for standard input there is no
/// limit.
void set_input_timeout(double seconds);

/// A file opened for reading at its first byte, its size in bytes, and what was known of it when it was opened.
struct OpenedInput {
  Descriptor file;
  std::size_t size = 0;
  sys::FileInfo info = {};
};

/// What a message says of a file that Git LFS has left in the place of a large one.
inline constexpr std::string_view git_lfs_pointer = "is a pointer of Git LFS and not the file itself";

/// Whether a search has seen just before that a path leads to a regular file. Else it is looked at before it is
/// opened, because the writer of a pipe notices that it is opened.
enum class SeenAsFile { no, yes };

/// Opens `path`. Throws Error that names it when it cannot be opened, is none of the above, holds more than
/// `most` bytes (a pipe is not read further than that), is a pipe that nothing came from in time, or is a
/// pointer of Git LFS.
OpenedInput open_input(const std::string& path, std::size_t most, SeenAsFile seen = SeenAsFile::no);

/// Hands all bytes of a file to `take`, piece by piece; false where it cannot be read to its end.
///   info   what was known of the file before its bytes were read
bool take_bytes(const std::string& path, sys::FileInfo& info, SeenAsFile seen,
                const std::function<void(std::string_view)>& take);

/// The first `count` bytes, fewer where the file is shorter; of a pipe no more is read. Throws as
/// open_input().
std::string read_head(const std::string& path, std::size_t count);

}  // namespace etak
