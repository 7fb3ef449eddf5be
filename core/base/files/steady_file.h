// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/files/file_stamp.h"
#include "core/base/files/input.h"

namespace etak {

/// Bytes that are looked at piece by piece: those of a file, or some in memory.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  virtual std::size_t size() const = 0;

  /// The `count` bytes from byte `at` on, which must be there; they stay until the next call.
  virtual std::string_view view(std::size_t at, std::size_t count) = 0;
};

/// Bytes that the caller holds as long as this lives.
class BytesInMemory : public ByteSource {
 public:
  explicit BytesInMemory(std::string_view bytes) : bytes_(bytes) {}
  std::size_t size() const override { return bytes_.size(); }
  std::string_view view(std::size_t at, std::size_t count) override { return bytes_.substr(at, count); }

 private:
  std::string_view bytes_;
};

/// A file that must stay as it is while it is read, such as a picture that another program may be exporting
/// anew. It is read and never mapped into memory: a mapped file that somebody shortens ends the program.
/// Looked at piece by piece, it costs a window of 256 KiB, whatever its size.
class SteadyFile : public ByteSource {
 public:
  /// Opens by open_input() and throws as that does.
  ///   most   bytes
  SteadyFile(const std::string& path, std::size_t most);

  std::size_t size() const override { return input_.size; }
  const std::string& path() const { return path_; }

  /// Throws Error that names the path where the file cannot be read or has become shorter.
  std::string_view view(std::size_t at, std::size_t count) override;
  void read(std::size_t at, char* to, std::size_t count) const;

  /// How many of the `count` bytes from byte `at` on there were; never throws, for callers written in C. A
  /// file that ends or fails early is reported by check_unchanged(), or by the reader that misses bytes.
  std::size_t read_what_is_there(std::size_t at, char* to, std::size_t count) const noexcept;

  /// The whole file, looked at for changes afterwards.
  std::string all() const;

  /// Throws Error when the file is no longer what was opened: another size, another time of change, or
  /// another file under its name. To be called when everything was read. A second change of the same size
  /// within a tick of the system's clock (some milliseconds) is not seen.
  void check_unchanged() const;

  /// Calls read(), which reads this file. Where it throws and the file has changed, the change is thrown in
  /// place of that, because bytes of two files one after the other look like a damaged one.
  template <class Read>
  auto read_checked(Read read) const {
    try {
      return read();
    } catch (...) {
      check_unchanged();
      throw;
    }
  }

 private:
  std::string path_;
  OpenedInput input_;
  FileStamp stamp_;
  std::string window_;
  std::size_t window_at_ = 0;
};

}  // namespace etak
