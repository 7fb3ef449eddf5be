// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace etak {

/// The bytes of a file without a copy in memory, so that a pair of 100 MB files costs what is being looked
/// at. A file that somebody shortens meanwhile ends the program, as with every mapping: small files are
/// therefore read.
class MappedFile {
 public:
  /// Throws Error naming the path: cannot be opened, no regular file, empty.
  explicit MappedFile(const std::string& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view bytes() const { return bytes_; }

  /// The first `count` bytes will hardly be asked for again: their memory is given back (and read again if
  /// they are).
  void drop_front(std::size_t count);

 private:
  std::string read_;
  std::string_view bytes_;
  bool mapped_ = false;
  std::size_t dropped_ = 0;
};

}  // namespace etak
