// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/file.h"

#include <cerrno>

#include "core/base/error.h"
#include "core/base/files/between_files.h"
#include "core/base/files/input.h"
#include "core/base/files/output_file.h"
#include "core/base/memory.h"

namespace etak {
namespace {

std::string too_large(std::size_t most) {
  return "at most " + std::to_string(most >> 20) + " MiB of text";
}

// Reads up to `wanted` bytes behind the present end of `out`; returns how many came.
std::size_t read_some(int fd, std::string& out, std::size_t wanted, const std::string& path) {
  const std::size_t old = out.size();
  out.resize(old + wanted);
  const std::ptrdiff_t got = sys::read(fd, out.data() + old, wanted);
  if (got < 0) throw Error::at(path, "cannot be read: " + reason_of(errno));
  out.resize(old + static_cast<std::size_t>(got));
  return static_cast<std::size_t>(got);
}

}  // namespace

void read_file(const std::string& path, std::string& out, std::size_t most) {
  BetweenFiles::call();
  out.clear();
  const OpenedInput opened = open_input(path, most);
  const std::size_t size = opened.size;
  const auto read_all = [&] {
    // One byte more than the size, so that the usual file ends in a single short read.
    while (read_some(opened.file.get(), out, (out.size() < size ? size - out.size() : 0) + 1, path) != 0) {
      if (out.size() > most) throw Error::at(path, "grew while it was read", too_large(most));
      if (out.size() == size) break;
    }
  };
  with_memory_for(
      path, [&] { return "its " + mebibytes(size); }, read_all);
}

std::string read_file(const std::string& path, std::size_t most) {
  std::string out;
  read_file(path, out, most);
  return out;
}

void write_file(const std::string& path, std::string_view bytes, bool overwrite) {
  OutputFile(path, bytes, overwrite).commit();
}

}  // namespace etak
