// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/validate/finding.h"
#include "core/validate/settings.h"

namespace etak {

/// A picture of a checked file for the page.
///   label          below it
///   width, height  of the original, in whose texels the boxes are
///   boxes          of its findings
///   png, heat_png  thumbnail() and heat_map() of the same size, as PNG files; no heat map: empty
struct ValidationPicture {
  std::string label;
  int width = 0, height = 0;
  std::vector<PixelBox> boxes;
  std::string png, heat_png;
};

struct ValidationPageFile {
  std::vector<ValidationPicture> pictures;
  std::optional<std::array<std::size_t, 256>> f0;  // f0_histogram()
};

struct ValidationPageOptions {
  std::string version;
  Settings settings;  // zone and transfer for the histogram, fail_on for the head
};

/// The report as one HTML page that works from disk: pictures are inside, so are the explanations of the
/// rules that occur; no script, no font, nothing from a network.
///   files   one for each of report.files, without pictures where there are none to show
std::string validation_page(const ValidationReport& report, std::span<const ValidationPageFile> files,
                            const ValidationPageOptions& options);

}  // namespace etak
