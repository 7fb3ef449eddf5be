// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/texels/page_memory.h"

#include <new>

#include "core/base/files/steady_file.h"
#include "core/base/system.h"
#include "core/image/picture.h"

namespace etak {
namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;

}  // namespace

PageMemory::PageMemory(std::size_t bytes) : size_(bytes) {
  if (bytes == 0) return;
  // Whole huge pages: the kernel aligns such mappings, and a tail in small pages would be touched one by one.
  if (bytes >= huge_page) size_ = (bytes + huge_page - 1) / huge_page * huge_page;
  void* const mapped = sys::map_memory(size_, bytes >= huge_page);
  if (mapped == nullptr) throw std::bad_alloc();
  data_ = static_cast<std::uint8_t*>(mapped);
}

PageMemory::~PageMemory() {
  if (data_ != nullptr) sys::unmap_memory(data_, size_);
}

void FileBytes::load(const std::string& path) {
  size_ = 0;
  const SteadyFile file(path, largest_picture_bytes);
  const std::size_t size = file.size();
  // Past the end lie some zero bytes that a reader's vector loads may touch.
  if (memory_.size() < size + 64) {
    memory_ = PageMemory();  // the old memory is freed first: both at once would count twice
    memory_ = PageMemory(size + 64);
  }
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as characters
  file.read(0, reinterpret_cast<char*>(memory_.data()), size);
  file.check_unchanged();
  size_ = size;
}

}  // namespace etak
