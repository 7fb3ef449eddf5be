// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace etak {

/// Adds the time between laps to sums, in seconds. A stopwatch that does not run never reads the clock.
class Stopwatch {
 public:
  explicit Stopwatch(bool running) : running_(running) {
    if (running_) last_ = Clock::now();
  }
  void lap(double& total) {
    if (!running_) return;
    const auto now = Clock::now();
    total += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  bool running_;
  Clock::time_point last_;
};

}  // namespace etak
