// SPDX-License-Identifier: Apache-2.0
#include "core/image/flip.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "core/image/image.h"
#include "tests/support.h"

using namespace etak;

namespace {

using Colour = std::array<double, 3>;

Image plain(int width, int height, const Colour& colour) {
  Image out(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (std::size_t c = 0; c < 3; ++c) out.at(x, y)[c] = static_cast<float>(colour[c]);
  return out;
}

Image noise_floats(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image out(width, height, 3);
  for (float& value : out.values) value = static_cast<float>(random() % 1024) / 1023.0f;
  return out;
}

double mean_of(const Image& a, const Image& b) {
  return flip(flip_view(a), flip_view(b)).mean;
}

// FLIP once more, written pixel by pixel from the formulas of the article: with two-dimensional filters, with
// the matrices as printed, and without any code of core/image.
namespace plainly {

Colour to_xyz(const Colour& c) {
  return {0.41239080 * c[0] + 0.35758434 * c[1] + 0.18048079 * c[2],
          0.21263901 * c[0] + 0.71516868 * c[1] + 0.07219232 * c[2],
          0.01933082 * c[0] + 0.11919478 * c[1] + 0.95053215 * c[2]};
}
Colour to_rgb(const Colour& c) {
  return {3.24096994 * c[0] - 1.53738318 * c[1] - 0.49861076 * c[2],
          -0.96924364 * c[0] + 1.87596750 * c[1] + 0.04155506 * c[2],
          0.05563008 * c[0] - 0.20397696 * c[1] + 1.05697151 * c[2]};
}
constexpr Colour white{0.95045593, 1, 1.08905775};

Colour ycxcz(const Colour& rgb) {
  const Colour xyz = to_xyz(rgb);
  return {116 * xyz[1] / white[1] - 16, 500 * (xyz[0] / white[0] - xyz[1] / white[1]),
          200 * (xyz[1] / white[1] - xyz[2] / white[2])};
}

double f(double t) {
  return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
}

Colour hunt(const Colour& rgb) {
  const Colour xyz = to_xyz(rgb);
  const double fx = f(xyz[0] / white[0]), fy = f(xyz[1] / white[1]), fz = f(xyz[2] / white[2]);
  const double l = 116 * fy - 16;
  return {l, 0.01 * l * 500 * (fx - fy), 0.01 * l * 200 * (fy - fz)};
}

double hyab(const Colour& p, const Colour& q) {
  return std::abs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]);
}

double redistributed(double distance) {
  const double most = std::pow(hyab(hunt({0, 1, 0}), hunt({0, 0, 1})), 0.7), raised = std::pow(distance, 0.7);
  return raised < 0.4 * most ? raised * 0.95 / (0.4 * most)
                             : 0.95 + (raised - 0.4 * most) / (most - 0.4 * most) * 0.05;
}

Colour pixel(const Image& image, int x, int y) {
  const auto p = image.at(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1));
  return {double(p[0]), double(p[1]), double(p[2])};
}

Colour blurred(const Image& image, int x, int y, double ppd) {
  constexpr double a1[]{1, 1, 34.1}, b1[]{0.0047, 0.0053, 0.04}, a2[]{0, 0, 13.5}, b2[]{1e-5, 1e-5, 0.025};
  const int radius =
      static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * std::numbers::pi * std::numbers::pi)) * ppd));
  Colour sum{}, weights{};
  for (int j = -radius; j <= radius; ++j)
    for (int i = -radius; i <= radius; ++i) {
      const double d2 = (i * i + j * j) / (ppd * ppd);
      const Colour value = ycxcz(pixel(image, x + i, y + j));
      for (std::size_t c = 0; c < 3; ++c) {
        const double weight = a1[c] * std::sqrt(std::numbers::pi / b1[c]) *
                                  std::exp(-std::numbers::pi * std::numbers::pi * d2 / b1[c]) +
                              a2[c] * std::sqrt(std::numbers::pi / b2[c]) *
                                  std::exp(-std::numbers::pi * std::numbers::pi * d2 / b2[c]);
        sum[c] += weight * value[c];
        weights[c] += weight;
      }
    }
  for (std::size_t c = 0; c < 3; ++c) sum[c] /= weights[c];
  const double ny = (sum[0] + 16) / 116;
  Colour rgb = to_rgb({white[0] * (ny + sum[1] / 500), white[1] * ny, white[2] * (ny - sum[2] / 200)});
  for (double& value : rgb) value = std::clamp(value, 0.0, 1.0);
  return hunt(rgb);
}

double feature(const Image& image, int x, int y, double ppd, bool points) {
  const double sd = 0.5 * 0.082 * ppd;
  const int radius = static_cast<int>(std::ceil(3 * sd));
  const auto weight = [&](int i, int j) {
    const double gauss = std::exp(-(i * i + j * j) / (2 * sd * sd));
    return points ? (i * i / (sd * sd) - 1) * gauss : -i * gauss;
  };
  double above = 0, below = 0;
  for (int j = -radius; j <= radius; ++j)
    for (int i = -radius; i <= radius; ++i) (weight(i, j) > 0 ? above : below) += weight(i, j);
  double across = 0, down = 0;
  for (int j = -radius; j <= radius; ++j)
    for (int i = -radius; i <= radius; ++i) {
      const double w = weight(i, j) / (weight(i, j) > 0 ? above : -below);
      across += w * (ycxcz(pixel(image, x + i, y + j))[0] + 16) / 116;
      down += w * (ycxcz(pixel(image, x + j, y + i))[0] + 16) / 116;
    }
  return std::hypot(across, down);
}

double flip(const Image& a, const Image& b, int x, int y, double ppd) {
  const double color = redistributed(hyab(blurred(a, x, y, ppd), blurred(b, x, y, ppd)));
  const double edge = std::abs(feature(a, x, y, ppd, false) - feature(b, x, y, ppd, false));
  const double point = std::abs(feature(a, x, y, ppd, true) - feature(b, x, y, ppd, true));
  return std::pow(color, 1 - std::sqrt(std::max(edge, point) / std::sqrt(2.0)));
}

}  // namespace plainly

}  // namespace

TEST_CASE("equal pictures differ nowhere") {
  const Image picture = noise_floats(37, 23, 1);
  const FlipError error = flip(flip_view(picture), flip_view(picture));
  CHECK(error.mean == 0);
  CHECK(error.map.size() == 37 * 23);
  CHECK(*std::max_element(error.map.begin(), error.map.end()) == 0);
}

TEST_CASE("plain pictures differ by their colours alone, and green against blue is the most there is") {
  const Colour black{0, 0, 0}, white{1, 1, 1}, green{0, 1, 0}, blue{0, 0, 1};
  CHECK(mean_of(plain(40, 30, green), plain(40, 30, blue)) == Approx(1).margin(1e-12));
  // The difference in L* is 100, and 100^0.7 = 25.1189; the largest difference is (55.437 + hypot(101.18,
  // 107.80))^0.7 = 41.28. So the error is 0.95 + 0.05 (25.1189 - 16.51) / (0.6 x 41.28).
  CHECK(mean_of(plain(40, 30, black), plain(40, 30, white)) == Approx(0.96737).margin(2e-5));
  // Grey of linear 0.5 has L* 76.0693. White differs by 23.9307, which is below the knee:
  // 23.9307^0.7 x 0.95 / 16.51.
  CHECK(mean_of(plain(40, 30, {0.5, 0.5, 0.5}), plain(40, 30, white)) == Approx(0.53112).margin(2e-4));
}

TEST_CASE("the order of the pictures does not matter") {
  const FlipView a = flip_view(noise_floats(31, 33, 2)), b = flip_view(noise_floats(31, 33, 3));
  CHECK(flip(a, b).map == flip(b, a).map);
  CHECK(flip(a, b).mean == flip(b, a).mean);
}

TEST_CASE("a single bright pixel is seen as the formulas of the article give it, and fades with distance") {
  const double ppd = flip_pixels_per_degree;
  const Image dark = plain(61, 61, {0.1, 0.1, 0.1});
  Image lit = dark;
  for (std::size_t c = 0; c < 3; ++c) lit.at(30, 30)[c] = 1;
  const FlipError error = flip(flip_view(dark), flip_view(lit));
  for (const auto& [x, y] : {std::pair{30, 30}, std::pair{31, 30}, std::pair{33, 28}, std::pair{30, 37}})
    CHECK(error.map[static_cast<std::size_t>(y * 61 + x)] ==
          Approx(plainly::flip(dark, lit, x, y, ppd)).margin(1e-7));
  CHECK(error.map[30 * 61 + 30] > error.map[30 * 61 + 33]);
  CHECK(error.map[30 * 61 + 33] > error.map[30 * 61 + 36]);
  // The widest filter reaches 10 pixels; nothing differs farther away.
  CHECK(error.map[30 * 61 + 41] == Approx(0).margin(1e-9));
}

TEST_CASE("coloured noise agrees with plain loops over filters of two dimensions, at the borders too") {
  for (const double ppd : {flip_pixels_per_degree, 23.5}) {
    const Image a = noise_floats(26, 19, 4), b = noise_floats(26, 19, 5);
    const FlipError error = flip(flip_view(a, ppd), flip_view(b, ppd));
    double sum = 0;
    for (int y = 0; y < 19; ++y)
      for (int x = 0; x < 26; ++x) {
        const double expected = plainly::flip(a, b, x, y, ppd);
        sum += expected;
        INFO("pixel " << x << ", " << y);
        REQUIRE(error.map[static_cast<std::size_t>(y * 26 + x)] == Approx(expected).margin(2e-6));
      }
    CHECK(error.mean == Approx(sum / (26 * 19)).margin(1e-6));
  }
}

TEST_CASE("a picture turned on its side has its error turned with it") {
  const Image a = noise_floats(20, 14, 6), b = noise_floats(20, 14, 7);
  const auto turned = [](const Image& image) {
    Image out(image.height, image.width, 3);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) std::copy_n(image.at(x, y).data(), 3, out.at(y, x).data());
    return out;
  };
  const FlipError upright = flip(flip_view(a), flip_view(b));
  const FlipError lying = flip(flip_view(turned(a)), flip_view(turned(b)));
  for (std::size_t y = 0; y < 14; ++y)
    for (std::size_t x = 0; x < 20; ++x)
      REQUIRE(upright.map[y * 20 + x] == Approx(lying.map[x * 14 + y]).margin(1e-10));
}

TEST_CASE("from further away, at more pixels per degree, fine noise is seen less") {
  const Image a = noise_floats(64, 64, 8), b = noise_floats(64, 64, 9);
  double before = 2;
  for (const double ppd : {15.0, 30.0, 60.0, 120.0}) {
    const double mean = flip(flip_view(a, ppd), flip_view(b, ppd)).mean;
    CHECK(mean < before);
    before = mean;
  }
}

TEST_CASE("values outside of a display's range are seen as the display shows them") {
  CHECK(mean_of(plain(8, 8, {1, 1, 1}), plain(8, 8, {7, 1, 2})) == 0);
  CHECK(mean_of(plain(8, 8, {0, 0, 0}), plain(8, 8, {-1, 0, std::nan("")})) == 0);
}

TEST_CASE("codes are sRGB codes, a fourth channel is not looked at, and one pixel is a picture") {
  Image8 codes(5, 4, 4);
  Image light(5, 4, 3);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 5; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const double code = 40 * x + 20 * y + 5.0 * static_cast<double>(c), v = code / 255;
        codes.at(x, y)[c] = static_cast<std::uint8_t>(code);
        codes.at(x, y)[3] = static_cast<std::uint8_t>(x * y);
        light.at(x, y)[c] = static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
      }
  CHECK(flip(flip_view(codes), flip_view(light)).mean < 1e-4);
  CHECK(mean_of(plain(1, 1, {0, 1, 0}), plain(1, 1, {0, 0, 1})) == Approx(1).margin(1e-12));
}

TEST_CASE("pictures that cannot be compared are refused") {
  const FlipView view = flip_view(plain(4, 4, {0, 0, 0}));
  CHECK(test::contains(test::error_of([&] {
                         flip(view, flip_view(plain(4, 5, {0, 0, 0})));
                       }),
                       "4 x 5 pixels"));
  CHECK(test::contains(test::error_of([&] {
                         flip(view, flip_view(plain(4, 4, {0, 0, 0}), 30));
                       }),
                       "pixels per degree"));
  CHECK(test::contains(test::error_of([&] { flip_view(Image(4, 4, 1)); }), "red, green and blue"));
  CHECK(test::contains(test::error_of([&] { flip_view(plain(4, 4, {0, 0, 0}), 0); }), "1 to 1000"));
}
