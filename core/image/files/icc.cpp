// SPDX-License-Identifier: Apache-2.0
#include "core/image/files/icc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "core/base/number.h"
#include "core/color/colorspace.h"
#include "core/color/srgb.h"
#include "core/image/files/png_chunks.h"
#include "core/math/functions.h"

namespace etak {
namespace {

constexpr double most_codes = 2;          // sRGB codes by which a curve may differ from a named one
constexpr double most_coordinate = 0.01;  // by which the XYZ of a primary may differ from a named one

// The linear light of each of the 256 codes.
using Curve = std::array<double, 256>;

double fixed16(std::string_view bytes, std::size_t at) {
  return static_cast<std::int32_t>(big_endian(bytes, at)) / 65536.0;
}

std::uint32_t half_word(std::string_view bytes, std::size_t at) {
  return std::uint32_t{static_cast<std::uint8_t>(bytes[at])} << 8 | static_cast<std::uint8_t>(bytes[at + 1]);
}

// The bytes of a tag; empty where the profile has no such tag or the tag does not lie inside of the profile.
std::string_view tag_of(std::string_view profile, std::string_view signature) {
  constexpr std::size_t table = 132, row = 12;
  const std::size_t count = std::min<std::size_t>(big_endian(profile, 128), (profile.size() - table) / row);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = table + row * i;
    if (profile.substr(at, 4) != signature) continue;
    const std::size_t offset = big_endian(profile, at + 4), size = big_endian(profile, at + 8);
    if (offset > profile.size() || size > profile.size() - offset) return {};
    return profile.substr(offset, size);
  }
  return {};
}

template <class Function>
std::optional<Curve> sampled(Function function) {
  Curve out{};
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = function(static_cast<double>(i) / 255);
    if (!std::isfinite(out[i])) return std::nullopt;
  }
  return out;
}

// A tag of type "curv": it holds no numbers (the identity), one exponent, or a table.
std::optional<Curve> table_curve(std::string_view tag) {
  const std::size_t count = big_endian(tag, 8);
  if (count > (tag.size() - 12) / 2) return std::nullopt;
  if (count == 0) return sampled([](double x) { return x; });
  if (count == 1)
    return sampled([exponent = half_word(tag, 12) / 256.0](double x) { return math::pow(x, exponent); });
  return sampled([&](double x) {
    const double place = x * static_cast<double>(count - 1);
    const std::size_t left = std::min(static_cast<std::size_t>(place), count - 2);
    const double low = half_word(tag, 12 + 2 * left), high = half_word(tag, 14 + 2 * left);
    return (low + (high - low) * (place - static_cast<double>(left))) / 65535;
  });
}

// A tag of type "para": (a x + b)^g + e for x >= d, c x + f below; the shorter forms leave parameters out.
std::optional<Curve> formula_curve(std::string_view tag) {
  constexpr std::array<std::size_t, 5> numbers{1, 3, 4, 5, 7};
  const std::size_t form = half_word(tag, 8);
  if (form >= numbers.size() || (tag.size() - 12) / 4 < numbers[form]) return std::nullopt;
  std::array<double, 7> given{1, 1};  // g a b c d e f
  for (std::size_t i = 0; i < numbers[form]; ++i) given[i] = fixed16(tag, 12 + 4 * i);
  const double g = given[0], a = given[1], b = given[2];
  double c = given[3], d = given[4], e = given[5], f = given[6];
  if (form == 1 || form == 2) {
    if (a == 0) return std::nullopt;
    d = -b / a;
    e = f = c;
    c = 0;
  }
  return sampled([=](double x) { return x >= d ? math::pow(a * x + b, g) + e : c * x + f; });
}

std::optional<Curve> curve_of(std::string_view tag) {
  if (tag.size() < 12) return std::nullopt;
  if (tag.starts_with("curv")) return table_curve(tag);
  return tag.starts_with("para") ? formula_curve(tag) : std::nullopt;
}

template <class Function>
bool is_like(const Curve& curve, Function function) {
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double expected = function(static_cast<double>(i) / 255);
    if (255 * std::abs(srgb_encode(std::clamp(curve[i], 0.0, 1.0)) - srgb_encode(expected)) > most_codes)
      return false;
  }
  return true;
}

std::string name_of(const Curve& curve) {
  if (is_like(curve, [](double x) { return srgb_decode(x); })) return "srgb";
  const double middle = curve[128];
  const double exponent = middle > 0 && middle < 1 ? math::log(middle) / math::log(128.0 / 255) : 1;
  if (is_like(curve, [&](double x) { return math::pow(x, exponent); })) return power_curve_name(1 / exponent);
  return "a curve of its own";
}

std::string name_of_primaries(const Mat3& columns) {
  constexpr std::array<std::array<double, 2>, 3> adobe{{{0.64, 0.33}, {0.21, 0.71}, {0.15, 0.06}}};
  constexpr std::array<std::array<double, 2>, 3> pro_photo{
      {{0.7347, 0.2653}, {0.1596, 0.8404}, {0.0366, 0.0001}}};
  const Xyz d50{0.9642, 1, 0.8249}, d65{0.3127 / 0.3290, 1, (1 - 0.3127 - 0.3290) / 0.3290};
  const auto are = [&](const std::array<std::array<double, 2>, 3>& primaries, const Xyz& white) {
    const Mat3 expected = bradford(white, d50) * rgb_to_xyz(primaries, white);
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t c = 0; c < 3; ++c)
        if (std::abs(expected[row][c] - columns[row][c]) > most_coordinate) return false;
    return true;
  };
  if (are(primaries(RgbSpace::srgb), d65)) return "sRGB";
  if (are(primaries(RgbSpace::display_p3), d65)) return "Display P3";
  if (are(adobe, d65)) return "Adobe RGB";
  if (are(primaries(RgbSpace::rec2020), d65)) return "Rec. 2020";
  return are(pro_photo, d50) ? "ProPhoto RGB" : "others";
}

// The name of the curve that all the tags have; nullopt where one of them cannot be read.
std::optional<std::string> name_of_curves(std::string_view profile,
                                          std::initializer_list<std::string_view> tags) {
  std::string out;
  for (const std::string_view tag : tags) {
    const auto curve = curve_of(tag_of(profile, tag));
    if (!curve) return std::nullopt;
    const std::string name = name_of(*curve);
    out = out.empty() || out == name ? name : "a curve of its own";
  }
  return out;
}

}  // namespace

std::optional<IccColors> icc_colors(std::string_view profile) {
  if (profile.size() < 132 || profile.size() > largest_profile_bytes || profile.substr(36, 4) != "acsp")
    return std::nullopt;
  const std::string_view model = profile.substr(16, 4);
  if (model == "GRAY") {
    const auto curve = name_of_curves(profile, {"kTRC"});
    return curve ? std::optional(IccColors{*curve, "greys"}) : std::nullopt;
  }
  const auto curve = model == "RGB " ? name_of_curves(profile, {"rTRC", "gTRC", "bTRC"}) : std::nullopt;
  if (!curve) return std::nullopt;
  Mat3 columns{};
  for (std::size_t c = 0; c < 3; ++c) {
    constexpr std::array<std::string_view, 3> tags{"rXYZ", "gXYZ", "bXYZ"};
    const std::string_view tag = tag_of(profile, tags[c]);
    if (tag.size() < 20 || !tag.starts_with("XYZ ")) return std::nullopt;
    for (std::size_t row = 0; row < 3; ++row) columns[row][c] = fixed16(tag, 8 + 4 * row);
  }
  return IccColors{*curve, name_of_primaries(columns)};
}

std::string primaries_name(const std::array<std::array<double, 2>, 3>& rgb,
                           const std::array<double, 2>& white) {
  constexpr double least_area = 1e-3;  // of the triangle of the primaries, twice
  const auto across = [&](std::size_t c, std::size_t axis) { return rgb[c][axis] - rgb[0][axis]; };
  if (!(white[1] > 0) || std::ranges::any_of(rgb, [](const auto& xy) { return !(xy[1] > 0); }) ||
      std::abs(across(1, 0) * across(2, 1) - across(1, 1) * across(2, 0)) < least_area)
    return "others";
  const Xyz d50{0.9642, 1, 0.8249}, xyz{white[0] / white[1], 1, (1 - white[0] - white[1]) / white[1]};
  return name_of_primaries(bradford(xyz, d50) * rgb_to_xyz(rgb, xyz));
}

std::string power_curve_name(double exponent) {
  if (std::abs(exponent - 1) < 0.01) return "linear";
  // 0.45455 is the power nearest to the sRGB curve, and countless sRGB files declare it.
  if (std::abs(exponent - 0.45455) < 0.005) return "power-2.2";
  return "gamma " + number(exponent, 5);
}

}  // namespace etak
