// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSize>
#include <algorithm>
#include <array>
#include <cmath>

namespace etak {

/// Milliseconds that a frame should take at most while the user drags.
inline constexpr double fluid_ms = 33;

/// Chooses the share of its width and height that a view is drawn with while the user drags, by the times of
/// the frames before, so that frames take fluid_ms at most where that is possible.
class FrameShare {
 public:
  /// The shares run from the whole picture to a sixteenth of its pixels, which is enlarged.
  static constexpr std::array shares{1.0, 0.75, 0.5, 0.375, 0.25};

  double next() const {
    const double whole_ms = whole_.least();
    // A frame takes a time for each of its pixels, and one that does not depend on how many are drawn.
    double by_pixel_ms = whole_ms, fixed_ms = 0;
    if (part_share_ > 0) {
      const double part = part_share_ * part_share_;
      by_pixel_ms = std::max(0.0, (whole_ms - part_.least()) / (1 - part));
      fixed_ms = std::max(0.0, part_.least() - by_pixel_ms * part);
    }
    for (const double share : shares)
      if (fixed_ms + by_pixel_ms * share * share <= wanted_ms) return share;
    return shares.back();
  }

  /// Notes the time of a frame.
  void took(double share, double ms) {
    if (share == 1) {
      whole_.add(ms);
    } else {
      if (share != part_share_) part_ = {};
      part_share_ = share;
      part_.add(ms);
    }
  }

  /// Pixels of a picture of `whole` that is drawn with a share.
  static QSize size(const QSize& whole, double share) {
    const auto side = [&](int length) { return std::max(1, static_cast<int>(std::ceil(length * share))); };
    return {side(whole.width()), side(whole.height())};
  }

 private:
  // Times differ from frame to frame, so that the one that is aimed at is below the one that is allowed.
  static constexpr double wanted_ms = 0.85 * fluid_ms;

  // The times of the last two frames of a size. The less of them counts: a frame during which another program had
  // the processors says nothing of the next one.
  struct LastTwo {
    double last_ms = 0, before_ms = 0;
    void add(double ms) {
      before_ms = last_ms > 0 ? last_ms : ms;
      last_ms = ms;
    }
    double least() const { return std::min(last_ms, before_ms); }
  };

  LastTwo whole_, part_;
  double part_share_ = 0;  // of the last frame that was not drawn whole; 0: there was none
};

}  // namespace etak
