// SPDX-License-Identifier: Apache-2.0
#include "core/study/made_pages.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/functions.h"
#include "core/study/measure.h"

namespace etak {
namespace {

// Value noise over a page, in [0, 1]: bilinear between random values at the corners of `cells` x `cells`
// cells.
class ValueNoise {
 public:
  ValueNoise(int cells, std::uint64_t seed) : cells_(cells) {
    Random random(seed);
    values_.resize(static_cast<std::size_t>(cells + 2) * static_cast<std::size_t>(cells + 2));
    for (double& value : values_) value = random.uniform();
  }
  double at(int x, int y) const {
    const double u = double(x) / most_page_side * cells_, v = double(y) / most_page_side * cells_;
    const int i = static_cast<int>(u), j = static_cast<int>(v);
    const double s = u - i, t = v - j;
    return (value(i, j) * (1 - s) + value(i + 1, j) * s) * (1 - t) +
           (value(i, j + 1) * (1 - s) + value(i + 1, j + 1) * s) * t;
  }

 private:
  double value(int i, int j) const {
    return values_[static_cast<std::size_t>(j) * static_cast<std::size_t>(cells_ + 2) +
                   static_cast<std::size_t>(i)];
  }
  int cells_;
  std::vector<double> values_;
};

std::uint8_t code(double value) {
  return to_code(static_cast<float>(value));
}

// Stone: four octaves of noise and grain; alpha is 255 everywhere.
Image8 stone_page(int side) {
  const ValueNoise noise[] = {{8, 21}, {32, 22}, {128, 23}, {512, 24}};
  Random grain(25);
  Image8 page(side, side, 4, 255);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      double level = 0.04 * (grain.uniform() - 0.5), share = 0.5;
      for (const ValueNoise& octave : noise) level += share * octave.at(x, y), share /= 2;
      const double tint[] = {0.8, 0.72, 0.6};
      for (std::size_t c = 0; c < 3; ++c) page.at(x, y)[c] = code(tint[c] * level);
    }
  return page;
}

// Sprites: shaded discs on a transparent ground.
Image8 sprite_page(int side) {
  constexpr int cell = 128;
  Image8 page(side, side, 4);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const int column = x / cell, row = y / cell;
      const double u = (x % cell + 0.5) / (cell / 2.0) - 1, v = (y % cell + 0.5) / (cell / 2.0) - 1;
      const double radius = 0.55 + 0.05 * ((column + 3 * row) % 8), r = math::hypot(u, v) / radius;
      const double cover = std::clamp((1 - r) * radius * cell / 2 + 0.5, 0.0, 1.0);
      if (cover == 0) continue;
      const double light = 0.25 + 0.75 * std::sqrt(std::max(0.0, 1 - r * r));
      for (std::size_t c = 0; c < 3; ++c)
        page.at(x, y)[c] = code(light * (0.3 + 0.1 * double((column * (int(c) + 1) + row) % 8)));
      page.at(x, y)[3] = code(cover);
    }
  return page;
}

// F0 and gloss: patches of five materials, each with one colour of F0, and scratches in the gloss.
Image8 material_page(int side) {
  const ValueNoise where(6, 31), scratches(340, 32);
  const std::array<std::array<double, 4>, 5> materials{{{0.22, 0.22, 0.22, 0.4},
                                                        {1.0, 0.86, 0.57, 0.8},
                                                        {0.95, 0.93, 0.88, 0.7},
                                                        {0.22, 0.22, 0.22, 0.75},
                                                        {0.77, 0.78, 0.78, 0.6}}};
  Image8 page(side, side, 4);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const auto which = static_cast<std::size_t>(where.at(x, y) * 4.999);
      const auto pixel = page.at(x, y);
      for (std::size_t c = 0; c < 3; ++c) pixel[c] = code(materials[which][c]);
      pixel[3] = code(materials[which][3] + 0.15 * (scratches.at(x, y) - 0.5));
    }
  return page;
}

}  // namespace

std::vector<MadePage> made_pages(int side) {
  std::vector<MadePage> out;
  out.push_back({"stone", "stone", stone_page(side)});
  out.push_back({"sprites", "sprites", sprite_page(side)});
  out.push_back({"materials", "F0 and gloss", material_page(side)});
  return out;
}

}  // namespace etak
