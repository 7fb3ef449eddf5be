// SPDX-License-Identifier: Apache-2.0
#include "core/validate/mapped_file.h"

#include <sys/mman.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/input.h"

namespace etak {

namespace {

constexpr std::size_t read_up_to = std::size_t{4} << 20;
constexpr std::size_t largest = std::size_t{1} << 32;
constexpr std::size_t page = 4096;

}  // namespace

MappedFile::MappedFile(const std::string& path) {
  {
    const auto [file, size] = open_input(path, largest);
    void* const at =
        size > read_up_to ? ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.get(), 0) : MAP_FAILED;
    if (at != MAP_FAILED) {
      ::madvise(at, size, MADV_SEQUENTIAL);
      bytes_ = {static_cast<const char*>(at), size};
      mapped_ = true;
    }
  }
  if (!mapped_) {
    read_file(path, read_, largest);
    bytes_ = read_;
  }
  if (bytes_.empty()) throw Error::at(path, "an empty file", "a picture");
}

MappedFile::~MappedFile() {
  if (mapped_) ::munmap(const_cast<char*>(bytes_.data()), bytes_.size());
}

void MappedFile::drop_front(std::size_t count) {
  const std::size_t until = std::min(count, bytes_.size()) / page * page;
  // In pieces: each call costs a walk through the page tables.
  if (!mapped_ || until < dropped_ + (std::size_t{2} << 20)) return;
  ::madvise(const_cast<char*>(bytes_.data()) + dropped_, until - dropped_, MADV_DONTNEED);
  dropped_ = until;
}

}  // namespace etak
