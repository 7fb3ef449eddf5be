// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <mutex>

#include "core/atlas/outputs.h"
#include "core/atlas/plan.h"

namespace etak {

/// The progress of one pass over the pages: regions composed and texels written as PNG, in steps of about the
/// same time. Any thread may call region() and written(); the listener is called by one thread at a time.
class PackProgress {
 public:
  using Listener = std::function<void(std::size_t done, std::size_t all)>;

  ///   writes   pages are written, not only composed
  PackProgress(const Listener& listener, const PackingPlan& plan, std::size_t regions,
               const WriteOptions& write, bool writes)
      : listener_(listener), region_steps_(2 * regions) {
    const bool png = std::find(write.formats.begin(), write.formats.end(), "png") != write.formats.end();
    if (!writes || !png) return;
    for (const PlannedPage& page : plan.pages)
      texels_ += texels_of(page) * static_cast<std::size_t>(page.has[0] + page.has[1]);
    // The time that compressing takes against composing, measured on pages of photographs' grain.
    const PngLevel level = write.png_level.value_or(PngLevel::small);
    const std::size_t weight = level == PngLevel::fast ? 1 : level == PngLevel::small ? 4 : 16;
    write_steps_ = weight * region_steps_;
  }

  static std::size_t texels_of(const PlannedPage& page) {
    return static_cast<std::size_t>(page.width) * static_cast<std::size_t>(page.height);
  }

  /// One texture of one region is composed.
  void region() {
    const std::lock_guard guard(lock_);
    ++composed_;
    tell();
  }

  /// So many texels more of level 0 are in a file.
  void written(std::size_t texels) {
    const std::lock_guard guard(lock_);
    written_ = std::min(texels_, written_ + texels);
    tell();
  }

 private:
  void tell() const {
    if (!listener_) return;
    const double share = texels_ == 0 ? 0 : static_cast<double>(written_) / static_cast<double>(texels_);
    const auto steps = static_cast<std::size_t>(share * static_cast<double>(write_steps_));
    listener_(std::min(composed_, region_steps_) + steps, region_steps_ + write_steps_);
  }

  const Listener& listener_;
  const std::size_t region_steps_;
  std::size_t write_steps_ = 0, texels_ = 0;
  std::size_t composed_ = 0, written_ = 0;
  std::mutex lock_;
};

}  // namespace etak
