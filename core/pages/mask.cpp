// SPDX-License-Identifier: Apache-2.0
#include "core/pages/mask.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace etak {
namespace {

constexpr std::array<std::uint8_t, 3> stripe{255, 64, 64}, between{176, 0, 0};
constexpr std::array<std::uint8_t, 3> yellow{255, 216, 0}, dot{90, 70, 0};

// Stripes are 4 texels wide and dots lie 4 texels apart, so that both are visible at half the picture's size.
std::array<std::uint8_t, 3> plateau_color(int x, int y) {
  return ((x + y) / 4) % 2 == 0 ? stripe : between;
}
std::array<std::uint8_t, 3> transition_color(int x, int y) {
  return x % 4 < 2 && y % 4 < 2 ? dot : yellow;
}

}  // namespace

Image8 mask_picture(const Image8& picture, const Image8& marks) {
  assert(picture.width == marks.width && picture.height == marks.height && marks.channels == 1);
  Image8 out(picture.width, picture.height, 3);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const std::uint8_t mark = marks.at(x, y)[0];
      const auto from = picture.at(x, y);
      const auto to = out.at(x, y);
      if (mark == 0)
        for (std::size_t c = 0; c < 3; ++c)
          to[c] = static_cast<std::uint8_t>(from[picture.channels >= 3 ? c : 0] / 4);
      else
        std::ranges::copy(mark == 2 ? plateau_color(x, y) : transition_color(x, y), to.begin());
    }
  return out;
}

Image8 box_marks(int width, int height, int x, int y, int box_width, int box_height) {
  Image8 out(width, height, 1);
  const int left = std::clamp(x, 0, width), right = std::clamp(x + box_width, left, width);
  for (int row = std::max(y, 0); row < std::min(y + box_height, height) && left < right; ++row)
    std::fill_n(out.at(left, row).data(), right - left, std::uint8_t{2});
  return out;
}

}  // namespace etak
