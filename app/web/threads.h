// SPDX-License-Identifier: Apache-2.0
// Put before every source by toolchain.cmake. Debian's libc++ for WebAssembly is built without threads: this gives the
// names that etak uses. No thread can be started, so the caller does all work itself (start_thread() of
// core/base/parallel.h answers false), and locks are empty.
#pragma once
#ifdef __cplusplus
#include <chrono>
#include <functional>
#include <mutex>
#include <system_error>

namespace std {

class mutex {
 public:
  void lock() {}
  bool try_lock() { return true; }
  void unlock() {}
};

class thread {
 public:
  struct id {
    friend bool operator==(id, id) = default;
  };
  thread() = default;
  template <class Work, class... Arguments>
  explicit thread(Work&&, Arguments&&...) {
    throw system_error(make_error_code(errc::resource_unavailable_try_again));
  }
  bool joinable() const { return false; }
  void join() {}
  void detach() {}
  static unsigned hardware_concurrency() { return 1; }
};

template <>
struct hash<thread::id> {
  size_t operator()(thread::id) const { return 0; }
};

namespace this_thread {
inline thread::id get_id() {
  return {};
}
inline void yield() {}
template <class Duration>
void sleep_for(Duration) {}
}  // namespace this_thread

template <class... Mutexes>
struct scoped_lock {
  explicit scoped_lock(Mutexes&...) {}
};

class condition_variable {
 public:
  void notify_one() {}
  void notify_all() {}
  template <class Lock>
  void wait(Lock&) {}
  template <class Lock, class Done>
  void wait(Lock&, Done) {}
  template <class Lock, class Duration, class Done>
  bool wait_for(Lock&, Duration, Done done) {
    return done();
  }
};

}  // namespace std
#endif
