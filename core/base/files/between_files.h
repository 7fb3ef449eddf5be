// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <type_traits>
#include <utility>

namespace etak {

/// While an object of this class lives, read_file(), the search of a folder and the walk through a list of files call a
/// function before each file, in its thread, so that work on many files can be ended between two of them: by an exception that is no Error, because an
/// Error is told of the one file, and the work goes on.
class BetweenFiles {
 public:
  ///   called   must live as long as this
  explicit BetweenFiles(const std::function<void()>& called) : before_(std::exchange(current(), &called)) {}
  ~BetweenFiles() { current() = before_; }
  BetweenFiles(const BetweenFiles&) = delete;
  BetweenFiles& operator=(const BetweenFiles&) = delete;

  /// For those who read files.
  static void call() {
    if (current() != nullptr) (*current())();
  }

 private:
  static const std::function<void()>*& current() {
    thread_local const std::function<void()>* called = nullptr;
    static_assert(std::is_trivially_destructible_v<decltype(called)>);
    return called;
  }
  const std::function<void()>* before_;
};

}  // namespace etak
