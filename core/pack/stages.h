// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/pack/pack.h"

namespace etak {

/// Times the stages of one call of pack(), and ends it between them where that is asked for.
class PackStages {
 public:
  explicit PackStages(const std::function<bool()>& cancelled) : cancelled_(cancelled) {}

  /// Throws PackCancelled.
  void stop_if_cancelled() const {
    if (cancelled_ && cancelled_()) throw PackCancelled();
  }

  /// What `act` returns; its time is added to that of the stage.
  template <class Act>
  auto timed(const char* name, Act act) {
    stop_if_cancelled();
    const Lap lap{stages_, stage(name)};
    return act();
  }

  const std::vector<PackStage>& all() const { return stages_; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Lap {
    std::vector<PackStage>& stages;
    std::size_t at;
    Clock::time_point begin = Clock::now();
    ~Lap() { stages[at].seconds += std::chrono::duration<double>(Clock::now() - begin).count(); }
  };
  std::size_t stage(std::string_view name) {
    const auto found = std::ranges::find(stages_, name, &PackStage::name);
    if (found != stages_.end()) return static_cast<std::size_t>(found - stages_.begin());
    stages_.push_back({std::string(name), 0});
    return stages_.size() - 1;
  }

  const std::function<bool()>& cancelled_;
  std::vector<PackStage> stages_;
};

}  // namespace etak
