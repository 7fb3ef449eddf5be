// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/pages/f0/report.h"

namespace etak {

/// What the parts of the F0 page share.
class F0PageContext {
 public:
  explicit F0PageContext(const F0Options& options);

  const F0Options& options() const { return options_; }

  /// 8-bit sRGB of the result's F82; none for reflectance data and for spaces etak cannot turn into sRGB.
  std::optional<Srgb8> edge_codes(const F0Result& result) const;

 private:
  const F0Options& options_;
  std::optional<Mat3> to_srgb_;  // from the options' space
};

/// The materials of one class, sorted by name.
struct F0PageGroup {
  std::string material_class, title;
  std::vector<const MaterialReport*> members;
};

/// `prefix` and `text` with everything but letters, digits, '-' and '_' made '-': the id of an element.
std::string anchor(std::string_view prefix, std::string_view text);

/// The result of the preferred dataset.
const F0Result& preferred_result(const MaterialReport& report);

/// "255 226 155"
std::string codes_text(const Srgb8& codes);

/// Largest CIEDE2000 difference between the preferred dataset and any other; 0 for one dataset or a refused
/// one.
double largest_difference(const MaterialReport& report);

/// Short names of the flags of `result`, each linked to its explanation; the reason of a refusal behind them.
void append_flags(std::string& out, const F0Result& result);

/// Every F0's luminance as a dot on a line, in lanes of conductors, semiconductors and dielectrics; the
/// forbidden zone shaded. Surfaces have no F0 and no dot.
void append_luminance_strip(std::string& out, std::span<const F0PageGroup> groups);

/// One row per material, one <tbody> per class.
void append_summary_table(std::string& out, std::span<const F0PageGroup> groups,
                          const F0PageContext& context);

/// Swatches, plots, datasets, spread and sources of one material.
void append_card(std::string& out, const MaterialReport& report, const F0PageContext& context);

}  // namespace etak
