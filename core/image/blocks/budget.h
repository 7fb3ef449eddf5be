// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/color/delta_e.h"
#include "core/color/gloss.h"
#include "core/image/blocks/astc_door.h"
#include "core/image/material_pair.h"

namespace etak {

/// What compression may change of a material: the 99th percentile over the texels that it reads, level by level.
///   diffuse, f0   CIEDE2000
///   gloss         percent of the exponent
///   alpha         percent of coverage; of materials with a mask no texel may change sides, whatever this says
struct BlockBudget {
  double diffuse = 1, f0 = 1, gloss = 10, alpha = 0.5;
  friend bool operator==(const BlockBudget&, const BlockBudget&) = default;
};

/// Differences of many texels, counted by how much of each is read: the same for any order in which they are added.
class TexelSpread {
 public:
  /// `unit` is the width of the bins, by which a percentile is exact.
  explicit TexelSpread(double unit) : unit_(unit), bins_(bin_count) {}
  ///   share   how much of the texel is read, above 0; the same unit for all
  void add(double difference, std::uint8_t share = 1);
  void add(const TexelSpread& other);
  std::uint64_t count() const { return count_; }
  double largest() const { return largest_; }
  /// The least difference, rounded up to a whole bin, that 99 % of the texels do not exceed.
  double percentile_99() const;
  /// How many texels have a difference above this one, a whole number of bins.
  std::uint64_t above(double difference) const;

 private:
  static constexpr std::size_t bin_count = 2000;
  double unit_, largest_ = 0;
  std::uint64_t count_ = 0;
  std::vector<std::uint64_t> bins_;
};

/// Measures differences of texels in units of shading, for one texture.
class BlockMeasure {
 public:
  BlockMeasure(Texture texture, GlossForm gloss, const BlockBudget& budget);

  /// Of the three colour channels: CIEDE2000.
  double colour(const std::array<std::uint8_t, 4>& from, const std::array<std::uint8_t, 4>& to) const;
  /// Of the fourth channel: percent of the exponent, or of coverage.
  ///   cutoff   of a mask: the least code that is covered; below 0: no mask
  double fourth(std::uint8_t from, std::uint8_t to, int cutoff) const;

  double colour_budget() const { return colour_budget_; }
  double fourth_budget() const { return fourth_budget_; }
  /// Sets the weights of a block's channels and of their pairs: its errors are then squares of how many budgets they are, for
  /// small ones around the mean of its texels that count.
  void weigh(AnyBlock& block) const;
  /// How squared errors of a texel count in budgets, for small ones. May be called from any thread.
  TexelForm form_of(const std::array<std::uint8_t, 4>& texel) const;

 private:
  using Code = std::array<std::uint8_t, 4>;
  TexelForm form_around(const Code& texel) const;  // of its colour, in CIEDE2000
  Lab lab(const std::array<std::uint8_t, 4>& code) const {
    return to_lab(LinearRgb{linear_[code[0]], linear_[code[1]], linear_[code[2]]});
  }

  bool is_gloss_;
  double colour_budget_, fourth_budget_;
  std::array<double, 256> linear_{}, exponent_log2_{};
};

}  // namespace etak
