// SPDX-License-Identifier: Apache-2.0
#include "core/validate/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/base/error.h"
#include "core/base/file.h"

namespace etak {

namespace {

constexpr std::size_t read_up_to = std::size_t{4} << 20;
constexpr std::size_t page = 4096;

}  // namespace

MappedFile::MappedFile(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) throw Error::at(path, "cannot be opened: " + std::string(std::strerror(errno)));
  struct stat about {};
  const bool known = ::fstat(file, &about) == 0;
  const bool large = known && S_ISREG(about.st_mode) && about.st_size > static_cast<off_t>(read_up_to);
  if (large) {
    const auto size = static_cast<std::size_t>(about.st_size);
    void* const at = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    if (at != MAP_FAILED) {
      ::madvise(at, size, MADV_SEQUENTIAL);
      bytes_ = {static_cast<const char*>(at), size};
      mapped_ = true;
    }
  }
  ::close(file);
  if (!mapped_) {
    read_file(path, read_, std::size_t{1} << 32);
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
