// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/image.h"
#include "core/image/picture.h"
#include "core/judge/finding.h"
#include "core/judge/rule.h"
#include "core/judge/settings.h"
#include "core/judge/target.h"
#include "core/validate/files/load.h"

namespace etak {

// How findings of a rule are undone in the texels. Each rule that can be repaired has a file in this folder
// and a row in repairs.inc. A repair sees the pictures of one target and a finding, and changes texels;
// repair_files.h checks the result by all rules and keeps it only where the finding is gone.

/// A picture of a target while it is repaired: codes of 8 bits (most 255) or of 16 (most 65535).
struct RepairPicture {
  TargetFile file;
  PictureHeader header;  // of the file
  Image16 codes;
  int most = 255;

  /// How many channels hold colour: 1 or 3.
  std::size_t colour_channels() const { return codes.channels >= 3 ? 3 : 1; }
  /// A code as a fraction of full scale, and back: rounded and clamped.
  double value(std::uint16_t code) const { return static_cast<double>(code) / most; }
  std::uint16_t code(double value) const {
    return static_cast<std::uint16_t>(std::lround(most * std::clamp(value, 0.0, 1.0)));
  }
  std::span<std::uint16_t> texel(std::size_t i) {
    const auto channels = static_cast<std::size_t>(codes.channels);
    return {codes.values.data() + i * channels, channels};
  }
  /// Puts each code of the colour channels through `curve`, from fraction to fraction.
  void put_through(const std::function<double(double)>& curve);
};

/// The files and the finding that a repair works on.
///   pictures   those files of the target that are pictures of codes
///   finding    that it is to undo
///   seen()     the pictures as the rules see them, in 8 bits and of one size
///   marks()    of a kind of region on them: 0 nothing, 1 its condition is met, 2 on a plateau
class RepairBench {
 public:
  RepairBench(std::span<RepairPicture> pictures_, const CheckTarget& target_, const Settings& settings_,
              const Finding& finding_, const Pictures& seen)
      : pictures(pictures_), target(target_), settings(settings_), finding(finding_), seen_(seen) {}

  std::span<RepairPicture> pictures;
  const CheckTarget& target;
  const Settings& settings;
  const Finding& finding;

  const Pictures& seen() const { return seen_; }
  Image8 marks(RegionKind kind) const;

  /// The picture of one of these roles; null: there is none.
  RepairPicture* with_role(std::initializer_list<FileRole> roles) const;
  /// The picture that the finding names; null: it is no picture.
  RepairPicture* named() const;

 private:
  const Pictures& seen_;
};

/// The outcome of a repair.
///   what   that was done, as a clause without a subject: "undid the second sRGB encoding"; empty: nothing
///          was
///   left   why some or all of it was left; empty: all was done
struct RepairOutcome {
  std::string what, left = {};
};

/// A row of the table of repairs.
struct Repair {
  std::string_view rule;  // "ETK402"
  RepairOutcome (*apply)(const RepairBench&);
};

/// Every repair, in the order in which they are tried: what happened to a whole picture is undone before
/// single texels are.
std::span<const Repair* const> repairs();
/// The repair of a rule; null: there is none.
const Repair* find_repair(std::string_view rule);

/// Texels of one region with the border that erosion took from it.
///   texels   indices y * width + x
///   mean     of the first three channels, or of one that stands for all of them, as fractions of full scale
///   linear   the same of the values behind the curve of the settings
struct RepairRegion {
  std::vector<std::size_t> texels;
  std::array<double, 3> mean{}, linear{};
};

/// The regions that marks show: connected plateaus, grown over texels that meet the condition and lie within
/// 4 codes of the plateau's own. Softer edges stay out.
///   of   the picture of the size of the marks that tells which texels are alike
std::vector<RepairRegion> regions_to_repair(const RepairBench& bench, const Image8& marks, const Image8& of);

/// The channels of a picture that hold metallic: [first, last), empty where the set's picture holds none.
std::array<std::size_t, 2> metallic_channels(const RepairPicture& picture);

/// Why a picture of the set cannot be repaired by regions that were found on pictures of one size; empty: it
/// can.
std::string wrong_size(const RepairPicture& picture, const Image8& marks);

}  // namespace etak
