// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "core/atlas/pack/pack.h"

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
    const Lap lap{*this, name};
    return act();
  }

  const std::vector<PackStage>& all() const { return stages_; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Lap {
    PackStages& stages;
    const char* name;
    Clock::time_point begin = Clock::now();
    ~Lap() { stages.add(name, std::chrono::duration<double>(Clock::now() - begin).count()); }
  };
  void add(const char* name, double seconds) {
    for (PackStage& stage : stages_)
      if (stage.name == name) {
        stage.seconds += seconds;
        return;
      }
    stages_.push_back({name, seconds});
  }

  const std::function<bool()>& cancelled_;
  std::vector<PackStage> stages_;
};

}  // namespace etak
