// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace etak {

/// What tells one state of a file from another: the file itself, its size, and its time of change.
struct FileStamp {
  std::uint64_t device = 0, inode = 0, size = 0;
  std::int64_t seconds = 0, nanoseconds = 0;
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// The stamp of the file behind `path`; zeros where there is none, and for the bytes of a pipe, which are
/// kept in memory and do not change.
FileStamp stamp_of(const std::string& path);

}  // namespace etak
