// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/core/image/png_maker.h"

/// Makes ICC profiles byte by byte, for tests. Nothing of core/image is used, so that the tests are
/// independent of it.
namespace etak::test {

inline std::string icc_u16(std::uint32_t value) {
  return {static_cast<char>(value >> 8), static_cast<char>(value)};
}

inline std::string icc_fixed(double value) {
  return big_endian(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(value * 65536))));
}

inline std::string icc_xyz(const std::array<double, 3>& xyz) {
  return std::string("XYZ \0\0\0\0", 8) + icc_fixed(xyz[0]) + icc_fixed(xyz[1]) + icc_fixed(xyz[2]);
}

inline std::string icc_table(const std::vector<std::uint16_t>& values) {
  std::string out = std::string("curv\0\0\0\0", 8) + big_endian(static_cast<std::uint32_t>(values.size()));
  for (const std::uint16_t v : values) out += icc_u16(v);
  return out;
}

/// A "curv" tag with one exponent, as u8Fixed8Number.
inline std::string icc_gamma(double exponent) {
  return icc_table({static_cast<std::uint16_t>(std::lround(exponent * 256))});
}

inline std::string icc_formula(unsigned form, const std::vector<double>& numbers) {
  std::string out = std::string("para\0\0\0\0", 8) + icc_u16(form) + icc_u16(0);
  for (const double v : numbers) out += icc_fixed(v);
  return out;
}

/// The sRGB curve as a "para" tag of form 3.
inline std::string icc_srgb_curve() {
  return icc_formula(3, {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045});
}

using IccTags = std::vector<std::pair<std::string, std::string>>;

inline std::string icc_profile(const std::string& model, const IccTags& tags) {
  std::string body(128, '\0');
  body.replace(16, 4, model);
  body.replace(20, 4, "XYZ ");
  body.replace(36, 4, "acsp");
  std::string table = big_endian(static_cast<std::uint32_t>(tags.size())), data;
  const std::size_t start = 132 + 12 * tags.size();
  for (const auto& [signature, bytes] : tags) {
    table += signature + big_endian(static_cast<std::uint32_t>(start + data.size())) +
             big_endian(static_cast<std::uint32_t>(bytes.size()));
    data += bytes;
  }
  return body + table + data;
}

/// The XYZ of the primaries under D50, as printed in the profiles of the named colour spaces.
using IccColorants = std::array<std::array<double, 3>, 3>;
inline constexpr IccColorants icc_srgb{
    {{0.4361, 0.2225, 0.0139}, {0.3851, 0.7169, 0.0971}, {0.1431, 0.0606, 0.7141}}};
inline constexpr IccColorants icc_display_p3{
    {{0.5151, 0.2412, -0.0011}, {0.2919, 0.6922, 0.0419}, {0.1572, 0.0666, 0.7841}}};
inline constexpr IccColorants icc_adobe_rgb{
    {{0.6097, 0.3111, 0.0195}, {0.2053, 0.6257, 0.0609}, {0.1492, 0.0632, 0.7446}}};
inline constexpr IccColorants icc_rec2020{
    {{0.6735, 0.2790, -0.0019}, {0.1657, 0.6753, 0.0300}, {0.1251, 0.0456, 0.7969}}};
inline constexpr IccColorants icc_pro_photo{
    {{0.7977, 0.2880, 0}, {0.1352, 0.7119, 0}, {0.0313, 0.0001, 0.8249}}};

inline std::string icc_rgb(const IccColorants& colorants, const std::string& curve) {
  return icc_profile("RGB ", {{"rXYZ", icc_xyz(colorants[0])},
                              {"gXYZ", icc_xyz(colorants[1])},
                              {"bXYZ", icc_xyz(colorants[2])},
                              {"rTRC", curve},
                              {"gTRC", curve},
                              {"bTRC", curve}});
}

/// The iCCP chunk of a PNG file, which holds a profile.
inline std::string iccp_chunk(const std::string& profile) {
  return png_chunk("iCCP", std::string("a profile\0\0", 11) + zlib_stream(profile));
}

/// A PNG file with `chunk` in front of its image data.
inline std::string with_iccp(const std::string& png, const std::string& profile) {
  std::string out = png;
  return out.insert(33, iccp_chunk(profile));  // behind IHDR
}

}  // namespace etak::test
