// SPDX-License-Identifier: Apache-2.0
// Based on:
//   Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astroem and Fairchild 2020, "FLIP: A Difference Evaluator
//   for Alternating Images"
//   Zhang and Wandell 1997, "A spatial extension of CIELAB for digital color-image reproduction": YCxCz
//   Abasi, Tehran and Fairchild 2020, "Distance metrics for very large color differences": HyAB
#include "core/image/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/color/colorspace.h"
#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/math/functions.h"

namespace etak {
namespace {

using std::numbers::pi;
constexpr double color_power = 0.7, knee_in = 0.4, knee_out = 0.95;  // q_c, p_c and p_t of the paper
constexpr double feature_width_deg = 0.082, feature_power = 0.5;     // w and q_f of the paper

using Plane = std::vector<double>;

constexpr Xyz d65{0.3127 / 0.3290, 1, (1 - 0.3127 - 0.3290) / 0.3290};
const Mat3& to_xyz_matrix() {
  static const Mat3 matrix = rgb_to_xyz(primaries(RgbSpace::srgb), d65);
  return matrix;
}
const Mat3& from_xyz_matrix() {
  static const Mat3 matrix = inverse(to_xyz_matrix());
  return matrix;
}

// Filter weights for the pixels -radius..radius.
struct Taps {
  Plane weights;
  int radius() const { return static_cast<int>(weights.size() / 2); }
};

// Runs `taps` along the rows (where `across`) or along the columns of a plane. Places outside of the plane
// have the value of the nearest pixel.
Plane filtered(const Plane& plane, int width, int height, const Taps& taps, bool across) {
  const int radius = taps.radius();
  const auto w = static_cast<std::size_t>(width);
  Plane out(plane.size(), 0.0);
  Plane padded(w + 2 * static_cast<std::size_t>(radius));
  for (int y = 0; y < height; ++y) {
    double* const to = out.data() + static_cast<std::size_t>(y) * w;
    if (across) {
      const double* const from = plane.data() + static_cast<std::size_t>(y) * w;
      for (int x = 0; x < width + 2 * radius; ++x)
        padded[static_cast<std::size_t>(x)] = from[std::clamp(x - radius, 0, width - 1)];
    }
    for (int t = -radius; t <= radius; ++t) {
      const double weight = taps.weights[static_cast<std::size_t>(t + radius)];
      const double* const from =
          across ? padded.data() + t + radius
                 : plane.data() + static_cast<std::size_t>(std::clamp(y + t, 0, height - 1)) * w;
      for (std::size_t x = 0; x < w; ++x) to[x] += weight * from[x];
    }
  }
  return out;
}

template <class Weight>
Taps taps_of(int radius, Weight weight) {
  Taps out;
  for (int x = -radius; x <= radius; ++x) out.weights.push_back(weight(x));
  return out;
}

double sum_of(const Taps& taps) {
  double sum = 0;
  for (const double weight : taps.weights) sum += weight;
  return sum;
}

// The filters of all channels have the radius of the widest one.
int sensitivity_radius(double pixels_per_degree) {
  const double widest = std::max({flip_achromatic.b1, flip_red_green.b1, flip_blue_yellow.b1});
  return static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * pixels_per_degree));
}

// The plane filtered by a channel's contrast sensitivity. A two-dimensional Gaussian is separable, a sum of
// two Gaussians is not, so each term is run on its own.
Plane seen_through(const FlipSensitivity& s, const Plane& plane, int width, int height,
                   double pixels_per_degree) {
  const int radius = sensitivity_radius(pixels_per_degree);
  struct Part {
    Taps taps;
    double scale;  // factor of the two-dimensional Gaussian
  };
  std::vector<Part> parts;
  double total = 0;
  for (const auto& [a, b] : {std::pair{s.a1, s.b1}, std::pair{s.a2, s.b2}}) {
    if (a == 0) continue;
    const double width_b = b;
    Part part{taps_of(radius,
                      [&](int x) {
                        const double d = x / pixels_per_degree;
                        return math::exp(-pi * pi * d * d / width_b);
                      }),
              a * std::sqrt(pi / b)};
    total += part.scale * sum_of(part.taps) * sum_of(part.taps);
    parts.push_back(std::move(part));
  }
  Plane out(plane.size(), 0.0);
  for (Part& part : parts) {
    const Plane rows = filtered(plane, width, height, part.taps, true);
    for (double& weight : part.taps.weights) weight *= part.scale / total;
    const Plane smoothed = filtered(rows, width, height, part.taps, false);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += smoothed[i];
  }
  return out;
}

// Scales the weights so that the positive ones sum to 1 and the negative ones to -1.
Taps balanced(Taps taps) {
  double above = 0, below = 0;
  for (const double weight : taps.weights) (weight > 0 ? above : below) += weight;
  for (double& weight : taps.weights) weight /= weight > 0 ? above : -below;
  return taps;
}

struct FeatureTaps {
  Taps blur, edge, point;
};

FeatureTaps feature_taps(double pixels_per_degree) {
  const double deviation = 0.5 * feature_width_deg * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * deviation));
  const auto gauss = [&](int x) { return math::exp(-x * x / (2 * deviation * deviation)); };
  FeatureTaps out{
      taps_of(radius, gauss), balanced(taps_of(radius, [&](int x) { return -x * gauss(x); })),
      balanced(taps_of(radius, [&](int x) { return (x * x / (deviation * deviation) - 1) * gauss(x); }))};
  const double sum = sum_of(out.blur);
  for (double& weight : out.blur.weights) weight /= sum;
  return out;
}

// Length of the gradient whose two components are `grey` filtered by `derivative` along rows and along
// columns.
//   blurred_rows   `grey` after the blur along rows
Plane strength(const Plane& grey, const Plane& blurred_rows, int width, int height, const Taps& blur,
               const Taps& derivative) {
  const Plane across = filtered(filtered(grey, width, height, derivative, true), width, height, blur, false);
  Plane out = filtered(blurred_rows, width, height, derivative, false);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::sqrt(out[i] * out[i] + across[i] * across[i]);
  return out;
}

Lab hunt_adjusted(const Vec3& rgb) {
  Lab lab = to_lab(to_xyz(to_xyz_matrix() * rgb), d65);
  lab.a *= 0.01 * lab.l;
  lab.b *= 0.01 * lab.l;
  return lab;
}

double hyab(const Lab& p, const Lab& q) {
  return std::abs(p.l - q.l) + std::sqrt((p.a - q.a) * (p.a - q.a) + (p.b - q.b) * (p.b - q.b));
}

// The largest distance between two colours of sRGB, which is that between green and blue.
double largest_difference() {
  static const double largest =
      math::pow(hyab(hunt_adjusted({0, 1, 0}), hunt_adjusted({0, 0, 1})), color_power);
  return largest;
}

double color_error(const Lab& p, const Lab& q) {
  const double distance = hyab(p, q);
  if (distance == 0) return 0;
  const double largest = largest_difference(), knee = knee_in * largest;
  const double raised = math::pow(distance, color_power);
  if (raised < knee) return raised * knee_out / knee;
  return std::min(1.0, knee_out + (raised - knee) / (largest - knee) * (1 - knee_out));
}

FlipView view_of(int width, int height, double pixels_per_degree, std::array<Plane, 3> rgb) {
  FlipView out;
  out.width = width;
  out.height = height;
  out.pixels_per_degree = pixels_per_degree;
  const std::size_t count = rgb[0].size();

  // Converts the planes to YCxCz in place.
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 xyz = to_xyz_matrix() * Vec3{rgb[0][i], rgb[1][i], rgb[2][i]};
    const double x = xyz[0] / d65.x, y = xyz[1] / d65.y, z = xyz[2] / d65.z;
    rgb[0][i] = 116 * y - 16;
    rgb[1][i] = 500 * (x - y);
    rgb[2][i] = 200 * (y - z);
  }

  Plane grey(count);
  for (std::size_t i = 0; i < count; ++i) grey[i] = (rgb[0][i] + 16) / 116;
  const FeatureTaps taps = feature_taps(pixels_per_degree);
  const Plane blurred_rows = filtered(grey, width, height, taps.blur, true);
  out.edges = strength(grey, blurred_rows, width, height, taps.blur, taps.edge);
  out.points = strength(grey, blurred_rows, width, height, taps.blur, taps.point);

  out.l = seen_through(flip_achromatic, rgb[0], width, height, pixels_per_degree);
  out.a = seen_through(flip_red_green, rgb[1], width, height, pixels_per_degree);
  out.b = seen_through(flip_blue_yellow, rgb[2], width, height, pixels_per_degree);
  for (std::size_t i = 0; i < count; ++i) {
    const double y = (out.l[i] + 16) / 116, x = y + out.a[i] / 500, z = y - out.b[i] / 200;
    Vec3 blurred = from_xyz_matrix() * Vec3{x * d65.x, y * d65.y, z * d65.z};
    // The channels are blurred by different widths, so the blurred colour can lie outside of the display's
    // gamut.
    for (double& channel : blurred) channel = std::clamp(channel, 0.0, 1.0);
    const Lab lab = hunt_adjusted(blurred);
    out.l[i] = lab.l;
    out.a[i] = lab.a;
    out.b[i] = lab.b;
  }
  return out;
}

template <class Picture, class Linear>
FlipView view_of(const Picture& picture, double pixels_per_degree, Linear linear) {
  if (picture.channels < 3)
    throw Error::at("FLIP", std::to_string(picture.channels) + " channels", "red, green and blue");
  if (!(pixels_per_degree >= 1 && pixels_per_degree <= 1000))
    throw Error::at("FLIP, pixels per degree", number(pixels_per_degree, 6), "1 to 1000");
  std::array<Plane, 3> rgb;
  const std::size_t count = picture.pixel_count(), step = static_cast<std::size_t>(picture.channels);
  for (std::size_t c = 0; c < 3; ++c) {
    rgb[c].resize(count);
    for (std::size_t i = 0; i < count; ++i) rgb[c][i] = linear(picture.values[i * step + c]);
  }
  return view_of(picture.width, picture.height, pixels_per_degree, std::move(rgb));
}

}  // namespace

FlipView flip_view(const Image& picture, double pixels_per_degree) {
  // NaN becomes 0, as in to_codes().
  return view_of(picture, pixels_per_degree,
                 [](float value) { return value > 0 ? std::min(1.0, static_cast<double>(value)) : 0.0; });
}

FlipView flip_view(const Image8& codes, double pixels_per_degree) {
  static const auto decoded = [] {
    std::array<double, 256> out{};
    for (std::size_t code = 0; code < 256; ++code) out[code] = srgb_decode(static_cast<double>(code) / 255);
    return out;
  }();
  return view_of(codes, pixels_per_degree, [](std::uint8_t code) { return decoded[code]; });
}

FlipError flip(const FlipView& reference, const FlipView& test) {
  if (reference.width != test.width || reference.height != test.height)
    throw Error::at("FLIP", std::to_string(test.width) + " x " + std::to_string(test.height) + " pixels",
                    std::to_string(reference.width) + " x " + std::to_string(reference.height));
  if (reference.pixels_per_degree != test.pixels_per_degree)
    throw Error::at("FLIP, pixels per degree", number(test.pixels_per_degree, 6),
                    number(reference.pixels_per_degree, 6));
  FlipError out;
  out.map.resize(reference.l.size());
  double sum = 0;
  for (std::size_t i = 0; i < out.map.size(); ++i) {
    const double color =
        color_error({reference.l[i], reference.a[i], reference.b[i]}, {test.l[i], test.a[i], test.b[i]});
    const double feature = math::pow(std::max(std::abs(reference.edges[i] - test.edges[i]),
                                              std::abs(reference.points[i] - test.points[i])) /
                                         std::numbers::sqrt2,
                                     feature_power);
    // pow(0, 0) would give 1, but where the colours do not differ, nothing differs.
    out.map[i] = color == 0 ? 0 : math::pow(color, std::max(0.0, 1 - feature));
    sum += out.map[i];
  }
  if (!out.map.empty()) out.mean = sum / static_cast<double>(out.map.size());
  return out;
}

}  // namespace etak
