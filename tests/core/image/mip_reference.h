// SPDX-License-Identifier: Apache-2.0
// A plain mip chain for comparison: computed in double from level 0, with areas as intersections of
// intervals.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/color/srgb.h"
#include "core/image/image.h"

namespace etak::test {

/// Random codes that are the same on every machine.
struct Noise {
  std::uint64_t state = 1;
  std::uint32_t next() {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::uint32_t>(state >> 33);
  }
  std::uint8_t code() { return static_cast<std::uint8_t>(next() >> 8); }
};

inline Image8 noise_picture(int width, int height, std::uint64_t seed) {
  Noise noise{seed};
  Image8 out(width, height, 4);
  for (auto& code : out.values) code = noise.code();
  return out;
}

struct ReferenceLevel {
  int width = 0, height = 0;
  // Linear R, G, B of texture A, opacity as a code, linear R, G, B of texture B, and 1/e.
  std::vector<std::array<double, 8>> texels;
};

inline ReferenceLevel reference_base(const Image8& a, const Image8& b) {
  ReferenceLevel out{a.width, a.height, {}};
  for (std::size_t i = 0; i < a.values.size(); i += 4) {
    std::array<double, 8> t{};
    for (std::size_t c = 0; c < 3; ++c) {
      t[c] = srgb_decode(a.values[i + c] / 255.0);
      t[4 + c] = srgb_decode(b.values[i + c] / 255.0);
    }
    t[3] = a.values[i + 3];
    t[7] = std::pow(2.0, -12 * (b.values[i + 3] / 255.0));
    out.texels.push_back(t);
  }
  return out;
}

inline ReferenceLevel reference_next(const ReferenceLevel& above, bool weigh_by_opacity) {
  ReferenceLevel out{std::max(1, above.width / 2), std::max(1, above.height / 2), {}};
  const auto overlap = [](int old_index, double begin, double end) {
    return std::max(0.0, std::min(end, old_index + 1.0) - std::max(begin, double(old_index)));
  };
  const double step_x = double(above.width) / out.width, step_y = double(above.height) / out.height;
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      std::array<double, 8> plain{};
      double area = 0, opaque[3] = {}, bright = 0, bright_inverse = 0;
      for (int v = static_cast<int>(y * step_y);
           v < std::min(above.height, static_cast<int>((y + 1) * step_y) + 1); ++v)
        for (int u = static_cast<int>(x * step_x);
             u < std::min(above.width, static_cast<int>((x + 1) * step_x) + 1); ++u) {
          const double share =
              overlap(u, x * step_x, (x + 1) * step_x) * overlap(v, y * step_y, (y + 1) * step_y);
          const auto& t = above.texels[static_cast<std::size_t>(v) * static_cast<std::size_t>(above.width) +
                                       static_cast<std::size_t>(u)];
          for (std::size_t c = 0; c < 8; ++c) plain[c] += share * t[c];
          for (std::size_t c = 0; c < 3; ++c) opaque[c] += share * t[3] * t[c];
          const double luminance = 0.2126 * t[4] + 0.7152 * t[5] + 0.0722 * t[6];
          bright += share * luminance;
          bright_inverse += share * luminance * t[7];
          area += share;
        }
      std::array<double, 8> t{};
      for (std::size_t c = 0; c < 8; ++c) t[c] = plain[c] / area;
      if (weigh_by_opacity && plain[3] > 0)
        for (std::size_t c = 0; c < 3; ++c) t[c] = opaque[c] / plain[3];
      if (bright > 0) t[7] = bright_inverse / bright;
      out.texels.push_back(t);
    }
  return out;
}

/// The four codes of texture A, then those of texture B, rounded half up.
inline std::array<int, 8> reference_codes(const std::array<double, 8>& t) {
  std::array<int, 8> out{};
  for (const std::size_t c : {0, 1, 2, 4, 5, 6}) out[c] = static_cast<int>(255 * srgb_encode(t[c]) + 0.5);
  out[3] = static_cast<int>(t[3] + 0.5);
  out[7] = static_cast<int>(std::max(0.0, 255 * (-std::log2(t[7]) / 12)) + 0.5);
  return out;
}

}  // namespace etak::test
