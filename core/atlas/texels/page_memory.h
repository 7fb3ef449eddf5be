// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace etak {

/// A large run of bytes straight from the kernel, in huge pages where it gives them: first touches of fresh
/// 4 KiB pages cost more than filling them (1.5 against 20 GB/s measured). Zero at first.
class PageMemory {
 public:
  PageMemory() = default;
  explicit PageMemory(std::size_t bytes);
  ~PageMemory();
  PageMemory(PageMemory&& other) noexcept : data_(std::exchange(other.data_, nullptr)), size_(other.size_) {}
  PageMemory& operator=(PageMemory&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }

  std::uint8_t* data() const { return data_; }
  std::size_t size() const { return data_ == nullptr ? 0 : size_; }

 private:
  std::uint8_t* data_ = nullptr;
  std::size_t size_ = 0;
};

/// The whole bytes of a picture file; the memory is used again for the next one.
class FileBytes {
 public:
  /// Throws Error naming the path, also where the file changes while it is read; at most 4 GiB.
  void load(const std::string& path);
  std::string_view view() const {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as characters
    return {reinterpret_cast<const char*>(memory_.data()), size_};
  }

 private:
  PageMemory memory_;
  std::size_t size_ = 0;
};

}  // namespace etak
