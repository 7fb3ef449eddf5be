// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/findings/report.h"
#include "core/judge/settings.h"

namespace etak {

/// A picture of a checked file for the page.
///   label          text below the picture
///   width, height  of the original picture, in texels
///   boxes          of its findings, in texels of the original picture
///   png, heat_png  thumbnail() and heat_map() of the same size, as PNG files; heat_png is empty where there
///                  is no heat map
struct ValidationPicture {
  std::string label;
  int width = 0, height = 0;
  std::vector<PixelBox> boxes;
  std::string png, heat_png;
};

/// The pictures of one checked file for the page.
///   left_out   there are some, and the page has no room for them
struct ValidationPageFile {
  std::vector<ValidationPicture> pictures;
  std::optional<std::array<std::size_t, 256>> f0;  // f0_histogram()
  bool left_out = false;
};

/// What the page says beside the report.
struct ValidationPageOptions {
  std::string version;
  Settings settings;  // zone and transfer are for the histogram, fail_on for the head of the page
};

/// The report as an HTML page, with pictures and the explanations of the rules that have findings. The page
/// is one file without scripts, fonts or links to the network, so that it opens from disk.
///   files   one for each of report.files; a file that has no pictures to show has an empty entry
std::string validation_page(const ValidationReport& report, std::span<const ValidationPageFile> files,
                            const ValidationPageOptions& options);

}  // namespace etak
