// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace etak {

/// Calls body(begin, end, worker) for consecutive chunks of [0, count) on `threads` threads (the caller is
/// one of them). Chunks are handed out in order; which worker gets which is not fixed, so results belong in
/// places named by the index. The first exception is rethrown after all workers have stopped.
template <class Body>
void parallel_chunks(std::size_t count, unsigned threads, std::size_t chunk, Body body) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_lock;
  const auto work = [&](unsigned worker) {
    try {
      for (std::size_t begin; (begin = next.fetch_add(chunk)) < count;)
        body(begin, std::min(count, begin + chunk), worker);
    } catch (...) {
      const std::lock_guard lock(failure_lock);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  const std::size_t useful = std::max<std::size_t>(1, (count + chunk - 1) / chunk);
  std::vector<std::thread> helpers;
  for (unsigned i = 1; i < std::min<std::size_t>(threads, useful); ++i) helpers.emplace_back(work, i);
  work(0);
  for (auto& helper : helpers) helper.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace etak
