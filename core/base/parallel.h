// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace etak {

/// Starts a thread that runs work(arguments...) and puts it at the end of `threads`. False where the system
/// starts no more threads (a limit on processes, no memory for a stack): the work is then left to the threads
/// that there are.
template <class Work, class... Arguments>
bool start_thread(std::vector<std::thread>& threads, Work&& work, Arguments... arguments) {
  try {
    threads.emplace_back(std::forward<Work>(work), arguments...);
    return true;
  } catch (const std::system_error&) {
    return false;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

/// The number of threads to use, at most 256; 0 stands for all cores.
inline unsigned thread_count(unsigned asked) {
  constexpr unsigned most = 256;
  return std::clamp(asked != 0 ? asked : std::thread::hardware_concurrency(), 1u, most);
}

/// Calls body(begin, end, worker) for consecutive chunks of [0, count) on `threads` threads (the caller is
/// one of them, and the only one where no other can be started). Chunks are handed out in order; which worker
/// gets which is not fixed, so results belong in places named by the index. The exception of the first chunk
/// that throws one, the same for any number of threads, is rethrown after all workers have stopped.
template <class Body>
void parallel_chunks(std::size_t count, unsigned threads, std::size_t chunk, Body body) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::size_t failed_at = count;
  std::mutex failure_lock;
  const auto work = [&](unsigned worker) {
    std::size_t begin = 0;
    try {
      while ((begin = next.fetch_add(chunk)) < count) body(begin, std::min(count, begin + chunk), worker);
    } catch (...) {
      // All chunks before this one have been handed out, so that the first failure is always found.
      const std::lock_guard lock(failure_lock);
      if (begin < failed_at) {
        failed_at = begin;
        failure = std::current_exception();
      }
      next = count;
    }
  };
  const std::size_t useful = std::max<std::size_t>(1, (count + chunk - 1) / chunk);
  std::vector<std::thread> helpers;
  for (unsigned i = 1; i < std::min<std::size_t>(threads, useful); ++i)
    if (!start_thread(helpers, work, i)) break;
  work(0);
  for (auto& helper : helpers) helper.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace etak
