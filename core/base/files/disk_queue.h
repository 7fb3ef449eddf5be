// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cerrno>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/files/descriptor.h"
#include "core/base/parallel.h"

namespace etak {

/// Brings written files to the disk while others are still being made: to wait for each in turn would cost
/// a large set a fifth of its time.
class DiskQueue {
 public:
  ~DiskQueue() { finish(); }

  void add(Descriptor file, const std::string& name) {
    std::unique_lock lock(lock_);
    // Few descriptors are open at any time.
    room_.wait(lock, [&] { return waiting_.size() < most_waiting; });
    waiting_.emplace_back(std::move(file), name);
    if (thread_.empty() && !start_thread(thread_, [this] { work(); })) {
      // Without a thread of its own the queue brings each file to the disk at once.
      bring_first(lock);
      return;
    }
    added_.notify_one();
  }

  /// Waits until all files are on the disk. Returns name and errno of the first that cannot be written.
  std::optional<std::pair<std::string, int>> finish() {
    {
      const std::lock_guard lock(lock_);
      ended_ = true;
      added_.notify_one();
    }
    for (std::thread& thread : thread_)
      if (thread.joinable()) thread.join();
    return failure_;
  }

 private:
  static constexpr std::size_t most_waiting = 64;

  void work() {
    std::unique_lock lock(lock_);
    for (;;) {
      added_.wait(lock, [&] { return ended_ || !waiting_.empty(); });
      if (waiting_.empty()) return;
      bring_first(lock);
    }
  }

  void bring_first(std::unique_lock<std::mutex>& lock) {
    auto [file, name] = std::move(waiting_.front());
    waiting_.pop_front();
    room_.notify_one();
    lock.unlock();
    const bool good = sys::to_disk(file.get()) && file.close();
    const int error = errno;
    lock.lock();
    if (!good && !failure_) failure_.emplace(name, error);
  }

  std::mutex lock_;
  std::condition_variable added_, room_;
  std::deque<std::pair<Descriptor, std::string>> waiting_;
  std::optional<std::pair<std::string, int>> failure_;
  bool ended_ = false;
  std::vector<std::thread> thread_;  // none or one
};

}  // namespace etak
