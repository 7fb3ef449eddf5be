// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/pages/f0/report.h"

namespace etak {

/// Values that all parts of the F0 page use. The options must outlive it.
class F0PageContext {
 public:
  explicit F0PageContext(const F0Options& options);

  const F0Options& options() const { return options_; }

  /// F82 of a result in 8-bit sRGB. None for reflectance data, which have no F82, and for custom spaces,
  /// whose conversion to sRGB is not known.
  std::optional<Srgb8> edge_codes(const F0Result& result) const;

 private:
  const F0Options& options_;
  std::optional<Mat3> to_srgb_;  // from the linear space of the options
};

/// The materials of one class, sorted by name.
struct F0PageGroup {
  std::string material_class, title;
  std::vector<const MaterialReport*> members;
};

/// The id of an HTML element: `prefix`, then `text` with '-' in place of each character that is no letter,
/// digit or '_'.
std::string anchor(std::string_view prefix, std::string_view text);

/// The result of the preferred dataset.
const F0Result& preferred_result(const MaterialReport& report);

/// "255 226 155"
std::string codes_text(const Srgb8& codes);

/// Largest CIEDE2000 difference between F0 of the preferred dataset and of any other; 0 where there is no
/// other or the preferred one was refused.
double largest_difference(const MaterialReport& report);

/// The CSS background of a disc that shows a smooth sphere of a dataset under light that is the same from all
/// sides: F0 in the middle, F at the angle of each ring, white at the rim. The flat colour of F0 for
/// reflectance data, whose sphere looks the same everywhere, and where F cannot be computed.
std::string ball_paint(const Material& material, const Dataset& dataset, const F0Result& result,
                       const F0Options& options);

/// Short names of the flags of `result`, each with a link to its explanation, then the reason of a refusal.
void append_flags(std::string& out, const F0Result& result);

/// An SVG with a dot for every material at the luminance of its F0, over a bar of its band, in one lane each for conductors,
/// semiconductors and dielectrics. The forbidden zone is shaded. Surfaces have no F0 and therefore no dot.
///   page   address of the F0 page that the dots lead to; empty: the page that the SVG is in
void append_luminance_strip(std::string& out, std::span<const F0PageGroup> groups,
                            std::string_view page = {});

/// The materials by their classes, in the order of the page.
std::vector<F0PageGroup> page_groups(std::span<const MaterialReport> materials);

/// One row per material, one <tbody> per class.
void append_summary_table(std::string& out, std::span<const F0PageGroup> groups,
                          const F0PageContext& context);

/// Swatches, plots, datasets, spread and sources of one material.
void append_card(std::string& out, const MaterialReport& report, const F0PageContext& context);

}  // namespace etak
