// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <mutex>

namespace etak {

/// Has work done once, by the thread that needs it first; the others wait for it. Where it throws, the next thread
/// that needs it tries again. std::call_once does the same, but glibc ends the program where an exception passes
/// through it and no memory is left.
class Once {
 public:
  template <class Work>
  void call(const Work& work) {
    if (done_.load(std::memory_order_acquire)) return;
    const std::lock_guard guard(lock_);
    if (done_.load(std::memory_order_relaxed)) return;
    work();
    done_.store(true, std::memory_order_release);
  }

 private:
  std::atomic<bool> done_{false};
  std::mutex lock_;
};

}  // namespace etak
