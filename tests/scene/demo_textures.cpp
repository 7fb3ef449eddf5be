// SPDX-License-Identifier: Apache-2.0
#include "tests/scene/demo_textures.h"

#include <array>
#include <cmath>
#include <functional>

#include "core/color/srgb.h"
#include "tests/scene/noise.h"

namespace etak::demo {
namespace {

using Rgb = std::array<double, 3>;

Rgb mixed(const Rgb& from, const Rgb& to, double t) {
  Rgb out;
  for (std::size_t c = 0; c < 3; ++c) out[c] = from[c] + t * (to[c] - from[c]);
  return out;
}

Image8 drawn(int side, const std::function<Rgb(double u, double v)>& linear) {
  Image8 out(side, side, 3);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Rgb colour = linear((x + 0.5) / side, (y + 0.5) / side);
      for (std::size_t c = 0; c < 3; ++c) out.at(x, y)[c] = srgb_u8(colour[c]);
    }
  return out;
}

Image8 drawn_grey(int side, const std::function<double(double u, double v)>& value) {
  Image8 out(side, side, 1);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      out.at(x, y)[0] = to_code(static_cast<float>(value((x + 0.5) / side, (y + 0.5) / side)));
  return out;
}

// Late wood's share: rises slowly through a ring and falls off at its end.
double late_wood(double u, double v) {
  const double across = 9 * v + 1.3 * octaves(u, v, 2, 3, 3, 11) + 0.05 * noise(u, v, 24, 96, 17);
  const double ring = across - std::floor(across);
  return ring * ring * (1 - step_between(0.9, 1, ring));
}

double stone_height(double u, double v) {
  const double base = octaves(u, v, 5, 5, 6, 31), pits = noise(u, v, 37, 37, 53);
  return 0.5 + 0.6 * base - 0.25 * step_between(0.35, 0.6, pits);
}

}  // namespace

Image8 wood_colour() {
  return drawn(512, [](double u, double v) {
    const Rgb early{0.46, 0.25, 0.105}, late{0.17, 0.068, 0.022};
    const double fibre = noise(u, v, 16, 220, 23);
    Rgb colour = mixed(early, late, late_wood(u, v));
    for (double& c : colour) c *= 1 + 0.12 * fibre + 0.1 * octaves(u, v, 3, 3, 2, 29);
    return colour;
  });
}

Image8 wood_gloss() {
  return drawn_grey(512, [](double u, double v) {
    return 0.38 + 0.14 * late_wood(u, v) + 0.05 * noise(u, v, 16, 220, 23);
  });
}

Image8 worn_gloss() {
  // Scratches: short straight strokes at random places, angles and lengths, repeated over the edges.
  struct Stroke {
    double u, v, du, dv, length, depth;
  };
  std::array<Stroke, 90> strokes;
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    const double du = 2 * random_at(i, 2, 41) - 1, dv = 2 * random_at(i, 3, 41) - 1;
    const double size = std::sqrt(du * du + dv * dv) + 1e-3;
    strokes[i] = {random_at(i, 0, 41),
                  random_at(i, 1, 41),
                  du / size,
                  dv / size,
                  0.05 + 0.3 * random_at(i, 4, 41),
                  0.1 + 0.25 * random_at(i, 5, 41)};
  }
  return drawn_grey(256, [&](double u, double v) {
    double gloss = 0.82 + 0.16 * octaves(u, v, 4, 4, 4, 43);
    for (const Stroke& s : strokes) {
      const auto wrapped = [](double d) { return d - std::floor(d + 0.5); };
      const double x = wrapped(u - s.u), y = wrapped(v - s.v);
      const double along = x * s.du + y * s.dv, across = std::abs(x * s.dv - y * s.du);
      if (std::abs(along) < s.length / 2) gloss -= s.depth * (1 - step_between(0.001, 0.005, across));
    }
    return gloss < 0.25 ? 0.25 : gloss;
  });
}

Image8 stained_gloss() {
  return drawn_grey(256, [](double u, double v) {
    const double stain = step_between(0, 0.25, octaves(u, v, 3, 3, 5, 61));
    return 0.74 - 0.34 * stain + 0.05 * noise(u, v, 64, 64, 67);
  });
}

Image8 stone_colour(bool wet) {
  return drawn(512, [=](double u, double v) {
    const Rgb pale{0.42, 0.39, 0.34}, dark{0.16, 0.13, 0.105}, rust{0.34, 0.19, 0.09};
    Rgb colour = mixed(dark, pale, step_between(0.1, 0.95, stone_height(u, v)));
    colour = mixed(colour, rust, 0.5 * step_between(0.05, 0.4, octaves(u, v, 4, 4, 4, 71)));
    const double grain = noise(u, v, 150, 150, 73);
    for (double& c : colour) {
      c *= 1 + 0.25 * grain;
      // Water in the pores sends light deeper: each bounce inside takes its share again.
      if (wet) c = c * (0.35 + 0.55 * c);
    }
    return colour;
  });
}

Image8 stone_gloss(bool wet) {
  return drawn_grey(512, [=](double u, double v) {
    const double height = stone_height(u, v);
    if (!wet) return 0.16 + 0.08 * height + 0.03 * noise(u, v, 90, 90, 79);
    const double standing = 1 - step_between(0.35, 0.65, height);  // water stands in what is low
    return 0.72 + 0.24 * standing;
  });
}

Image8 stone_normals() {
  constexpr int side = 512;
  Image8 out(side, side, 3);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double u = (x + 0.5) / side, v = (y + 0.5) / side, d = 1.0 / side;
      const double relief = 0.018;  // of the texture's side
      const double du = (stone_height(u + d, v) - stone_height(u - d, v)) / (2 * d) * relief;
      const double dv = (stone_height(u, v + d) - stone_height(u, v - d)) / (2 * d) * relief;
      const double length = std::sqrt(du * du + dv * dv + 1);
      const std::array n{-du / length, dv / length, 1 / length};  // v runs down, +y up
      for (std::size_t c = 0; c < 3; ++c) out.at(x, y)[c] = to_code(static_cast<float>((n[c] + 1) / 2));
    }
  return out;
}

Image8 leaf() {
  constexpr int side = 256;
  Image8 out(side, side, 4);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double u = (x + 0.5) / side, v = (y + 0.5) / side, across = std::abs(u - 0.5);
      // Half width along the leaf, with teeth.
      const double along = (v - 0.06) / 0.88, teeth = v * 14 - std::floor(v * 14);
      double half = along <= 0 || along >= 1 ? 0 : 1.15 * along * (1 - along) * (1.25 - 0.5 * along);
      half -= 0.03 * (1 - teeth) * (half > 0.03 ? 1 : 0);
      const bool stalk = v > 0.9 && across < 0.012;
      const double opacity = stalk ? 1 : 1 - step_between(-0.004, 0.004, across - half);
      const double rib = 1 - step_between(0.004, 0.012, across);
      const double side_rib = (v - across) * 11 - std::floor((v - across) * 11);
      const double inside =
          step_between(0.008, 0.06, half - across);  // ribs end before the edge, where hidden texels begin
      Rgb colour = mixed({0.045, 0.16, 0.02}, {0.16, 0.3, 0.06},
                         inside * (rib + 0.35 * (1 - step_between(0, 0.16, side_rib))));
      for (double& c : colour) c *= 1 + 0.4 * octaves(u, v, 5, 5, 3, 83);
      for (std::size_t c = 0; c < 3; ++c)
        out.at(x, y)[c] = srgb_u8(colour[c]);  // goes on under alpha 0, where filters reach it
      out.at(x, y)[3] = to_code(static_cast<float>(half > 0 || stalk ? opacity : 0));
    }
  return out;
}

Image8 metal_rough(const Image8& gloss, bool metal) {
  Image8 out(gloss.width, gloss.height, 3);
  for (std::size_t i = 0; i < gloss.values.size(); ++i) {
    out.values[3 * i] = 255;
    out.values[3 * i + 1] = static_cast<std::uint8_t>(255 - gloss.values[i]);
    out.values[3 * i + 2] = metal ? 255 : 0;
  }
  return out;
}

Image8 one_colour(int side, const std::array<std::uint8_t, 3>& codes) {
  Image8 out(side, side, 3);
  for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] = codes[i % 3];
  return out;
}

Image8 encoded_again(const Image8& picture) {
  Image8 out = picture;
  for (std::uint8_t& code : out.values) code = srgb_u8(code / 255.0);
  return out;
}

Image8 with_black_ground(const Image8& picture) {
  Image8 out = picture;
  for (std::size_t i = 0; i < out.pixel_count(); ++i)
    if (out.values[4 * i + 3] == 0)
      for (std::size_t c = 0; c < 3; ++c) out.values[4 * i + c] = 0;
  return out;
}

Image8 brightened(const Image8& picture, double least, double most) {
  Image8 out = picture;
  for (std::uint8_t& code : out.values) code = srgb_u8(least + (most - least) * srgb_decode(code / 255.0));
  return out;
}

}  // namespace etak::demo
