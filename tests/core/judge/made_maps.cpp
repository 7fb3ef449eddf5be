// SPDX-License-Identifier: Apache-2.0
#include "tests/core/judge/made_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "tests/core/judge/corpus.h"

namespace etak::test {
namespace {

float height_at(const Heights& h, int x, int y) {
  return h.at((x + h.width) % h.width, (y + h.height) % h.height)[0];
}

// Smoothed random values on grids of 1/2, 1/4, ... of the side.
Heights noise(int size, Random& random) {
  Heights out(size, size, 1);
  for (int cell = 32; cell >= 4; cell /= 2) {
    const int cells = size / cell;
    std::vector<float> grid(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
    for (float& value : grid) value = static_cast<float>(random.between(-1, 1));
    const auto at = [&](int x, int y) {
      return grid[static_cast<std::size_t>(y % cells) * static_cast<std::size_t>(cells) +
                  static_cast<std::size_t>(x % cells)];
    };
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const auto smooth = [](float t) { return t * t * (3 - 2 * t); };
        const float u = smooth(static_cast<float>(x % cell) / static_cast<float>(cell)),
                    v = smooth(static_cast<float>(y % cell) / static_cast<float>(cell));
        const float top = at(x / cell, y / cell) * (1 - u) + at(x / cell + 1, y / cell) * u,
                    low = at(x / cell, y / cell + 1) * (1 - u) + at(x / cell + 1, y / cell + 1) * u;
        out.at(x, y)[0] += 0.3f * static_cast<float>(cell) * (top * (1 - v) + low * v);
      }
  }
  return out;
}

// Bricks with bevels of 5 texels, each a little askew (tilt 0: all of them flat).
Heights bricks(int size, Random& random, double tilt) {
  Heights out(size, size, 1);
  const int width = 43, height = 21, bevel = 5;
  std::map<std::array<int, 2>, std::array<double, 2>> tilts;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const int row = y / height, shifted = x + (row % 2) * (width / 2);
      const int u = shifted % width, v = y % height;
      auto [entry, is_new] = tilts.try_emplace({shifted / width, row});
      if (is_new) entry->second = {random.between(-tilt, tilt), random.between(-tilt, tilt)};
      const int edge = std::min({u, width - 1 - u, v, height - 1 - v, bevel});
      out.at(x, y)[0] = static_cast<float>(0.8 * edge + entry->second[0] * u + entry->second[1] * v);
    }
  return out;
}

// Round bumps of 4 to 8 texels.
Heights bumps(int size, Random& random) {
  Heights out(size, size, 1);
  for (int i = 0; i < size * size / 120; ++i) {
    const int x0 = random.below(size), y0 = random.below(size);
    const double radius = random.between(4, 8), high = random.between(-0.5, 0.9) * radius;
    for (int y = -20; y <= 20; ++y)
      for (int x = -20; x <= 20; ++x)
        out.at((x0 + x + size) % size, (y0 + y + size) % size)[0] +=
            static_cast<float>(high * std::exp(-(x * x + y * y) / (radius * radius)));
  }
  return out;
}

// Quantises the cosines of an 8 x 8 block as JPEG does: ITU-T T.81, annex K.
void quantise(std::array<double, 64>& block, bool chroma, int quality) {
  constexpr std::array<int, 64> luma_steps{
      16, 11,  10,  16, 24, 40, 51, 61, 12,  12,  14,  19,  26, 58, 60, 55,  14,  13,  16,  24, 40, 57,
      69, 56,  14,  17, 22, 29, 51, 87, 80,  62,  18,  22,  37, 56, 68, 109, 103, 77,  24,  35, 55, 64,
      81, 104, 113, 92, 49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98,  112, 100, 103, 99};
  const double scale = quality < 50 ? 5000.0 / quality : 200.0 - 2 * quality;
  static const auto basis = [] {
    std::array<std::array<double, 8>, 8> out{};
    for (std::size_t u = 0; u < 8; ++u)
      for (std::size_t x = 0; x < 8; ++x)
        out[u][x] =
            (u == 0 ? std::sqrt(0.125) : 0.5) *
            std::cos((2.0 * static_cast<double>(x) + 1) * static_cast<double>(u) * std::numbers::pi / 16);
    return out;
  }();
  std::array<double, 64> half{}, cosines{};
  for (std::size_t y = 0; y < 8; ++y)
    for (std::size_t u = 0; u < 8; ++u)
      for (std::size_t x = 0; x < 8; ++x) half[8 * y + u] += basis[u][x] * (block[8 * y + x] - 128);
  for (std::size_t v = 0; v < 8; ++v)
    for (std::size_t u = 0; u < 8; ++u) {
      for (std::size_t y = 0; y < 8; ++y) cosines[8 * v + u] += basis[v][y] * half[8 * y + u];
      constexpr std::array<int, 4> chroma_corner{17, 18, 24, 47};  // of its table; 99 beyond
      const int table = !chroma ? luma_steps[8 * v + u] : u + v < 4 ? chroma_corner[u + v] : 99;
      const double step = std::max(1.0, std::floor((table * scale + 50) / 100));
      cosines[8 * v + u] = step * std::round(cosines[8 * v + u] / step);
    }
  half.fill(0);
  for (std::size_t v = 0; v < 8; ++v)
    for (std::size_t x = 0; x < 8; ++x)
      for (std::size_t u = 0; u < 8; ++u) half[8 * v + x] += basis[u][x] * cosines[8 * v + u];
  for (std::size_t y = 0; y < 8; ++y)
    for (std::size_t x = 0; x < 8; ++x) {
      block[8 * y + x] = 128;
      for (std::size_t v = 0; v < 8; ++v) block[8 * y + x] += basis[v][y] * half[8 * v + x];
    }
}

}  // namespace

Image8 normals_of(const Heights& h, double strength) {
  Image8 out(h.width, h.height, 3);
  each_texel(out, [&](auto texel, int x, int y) {
    const double right = strength * (height_at(h, x + 1, y) - height_at(h, x - 1, y)) / 2,
                 down = strength * (height_at(h, x, y + 1) - height_at(h, x, y - 1)) / 2;
    const double length = std::sqrt(right * right + down * down + 1);
    const std::array<double, 3> n{-right / length, down / length, 1 / length};
    for (std::size_t c = 0; c < 3; ++c) texel[c] = to_byte(127.5 + 127.5 * n[c]);
  });
  return out;
}

Image8 grey_of(const Heights& h) {
  const auto [least, most] = std::ranges::minmax(h.values);
  Image8 out(h.width, h.height, 1);
  for (std::size_t i = 0; i < out.values.size(); ++i)
    out.values[i] = to_byte(255 * (h.values[i] - least) / std::max(most - least, 1e-6f));
  return out;
}

Heights surface(int kind, std::uint64_t seed, int size) {
  Random random(seed);
  if (kind == 0) return noise(size, random);
  if (kind == 1) return bricks(size, random, 0.15);
  if (kind == 2) return bumps(size, random);
  return bricks(size, random, 0);
}

Image8 halved(const Image8& large) {
  Image8 out(large.width / 2, large.height / 2, large.channels);
  each_texel(out, [&](auto texel, int x, int y) {
    for (std::size_t c = 0; c < texel.size(); ++c)
      texel[c] = to_byte((large.at(2 * x, 2 * y)[c] + large.at(2 * x + 1, 2 * y)[c] +
                          large.at(2 * x, 2 * y + 1)[c] + large.at(2 * x + 1, 2 * y + 1)[c]) /
                         4.0);
  });
  return out;
}
Image8 through_jpeg(const Image8& image, int quality, bool subsampled) {
  std::array<Pixels<double>, 3> planes;
  for (auto& plane : planes) plane = Pixels<double>(image.width, image.height, 1);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto t = image.at(x, y);
      planes[0].at(x, y)[0] = 0.299 * t[0] + 0.587 * t[1] + 0.114 * t[2];
      planes[1].at(x, y)[0] = 128 - 0.168736 * t[0] - 0.331264 * t[1] + 0.5 * t[2];
      planes[2].at(x, y)[0] = 128 + 0.5 * t[0] - 0.418688 * t[1] - 0.081312 * t[2];
    }
  for (std::size_t p = 0; p < 3; ++p) {
    const int step = p > 0 && subsampled ? 2 : 1;
    Pixels<double> part(image.width / step, image.height / step, 1);
    const auto each = [&](auto act) {
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) act(planes[p].at(x, y)[0], part.at(x / step, y / step)[0]);
    };
    each([&](double whole, double& mean) { mean += std::round(whole) / (step * step); });
    for (int y = 0; y + 8 <= part.height; y += 8)
      for (int x = 0; x + 8 <= part.width; x += 8) {
        std::array<double, 64> block{};
        for (int i = 0; i < 64; ++i) block[static_cast<std::size_t>(i)] = part.at(x + i % 8, y + i / 8)[0];
        quantise(block, p > 0, quality);
        for (int i = 0; i < 64; ++i)
          part.at(x + i % 8, y + i / 8)[0] =
              std::clamp(std::round(block[static_cast<std::size_t>(i)]), 0.0, 255.0);
      }
    each([](double& whole, double mean) { whole = mean; });
  }
  Image8 out = image;
  each_texel(out, [&](auto t, int x, int y) {
    const double luma = planes[0].at(x, y)[0], blue = planes[1].at(x, y)[0] - 128,
                 red = planes[2].at(x, y)[0] - 128;
    t[0] = to_byte(luma + 1.402 * red);
    t[1] = to_byte(luma - 0.344136 * blue - 0.714136 * red);
    t[2] = to_byte(luma + 1.772 * blue);
  });
  return out;
}

}  // namespace etak::test
