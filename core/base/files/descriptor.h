// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

#include "core/base/system.h"

namespace etak {

/// An open file or folder, closed with the object.
class Descriptor {
 public:
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  ~Descriptor() { (void)close(); }
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  int get() const { return fd_; }
  explicit operator bool() const { return fd_ >= 0; }
  /// From here on the caller closes it.
  int release() { return std::exchange(fd_, -1); }
  /// False where the system says that what was written may be lost; nothing is open then either.
  bool close() {
    const int fd = std::exchange(fd_, -1);
    return fd < 0 || sys::close_file(fd);
  }

 private:
  int fd_;
};

/// Whether the name in `folder` stands for the file or folder that is open. Makes system calls only, so that
/// a handler of signals may call it too.
inline bool stands_for(int folder, const char* name, int open) {
  sys::FileInfo named, opened;
  return sys::file_info_in(folder, name, named) && sys::file_info(open, opened) &&
         named.device == opened.device && named.number == opened.number;
}

/// Writes all of `bytes`, however often the system stops in between; errno tells why not.
inline bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const std::ptrdiff_t wrote = sys::write(fd, bytes.data(), bytes.size());
    if (wrote < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(wrote));
  }
  return true;
}

/// Reads the bytes of a file from `at` on until `out` is full or the file ends, however often the system stops in
/// between. Returns how many were read; where they are fewer and errno has changed, it tells why.
inline std::size_t read_all_at(int file, std::span<char> out, std::size_t at) noexcept {
  std::size_t there = 0;
  while (there < out.size()) {
    const std::ptrdiff_t got = sys::read_at(file, out.data() + there, out.size() - there, at + there);
    if (got <= 0) break;
    there += static_cast<std::size_t>(got);
  }
  return there;
}

}  // namespace etak
