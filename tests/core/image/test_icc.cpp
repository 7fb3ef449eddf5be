// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "core/base/files/steady_file.h"
#include "core/color/srgb.h"
#include "core/image/files/icc.h"
#include "core/image/files/png.h"
#include "core/image/load.h"
#include "tests/core/image/icc_maker.h"
#include "tests/core/image/png_of.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

std::string curve_named(const std::string& curve) {
  const auto colors = icc_colors(icc_rgb(icc_srgb, curve));
  return colors ? colors->curve : "unread";
}

std::vector<std::uint16_t> table_of_srgb(std::size_t size) {
  std::vector<std::uint16_t> out;
  for (std::size_t i = 0; i < size; ++i)
    out.push_back(static_cast<std::uint16_t>(
        std::lround(65535 * srgb_decode(static_cast<double>(i) / static_cast<double>(size - 1)))));
  return out;
}

}  // namespace

TEST_CASE("curves of a profile are named by what they do") {
  CHECK(curve_named(icc_srgb_curve()) == "srgb");
  CHECK(curve_named(icc_table(table_of_srgb(1024))) == "srgb");
  CHECK(curve_named(icc_table(table_of_srgb(4096))) == "srgb");
  CHECK(curve_named(icc_formula(4, {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045, 0, 0})) == "srgb");
  CHECK(curve_named(icc_table({})) == "linear");
  CHECK(curve_named(icc_gamma(1)) == "linear");
  CHECK(curve_named(icc_table({0, 65535})) == "linear");
  CHECK(curve_named(icc_formula(0, {1})) == "linear");
  CHECK(curve_named(icc_gamma(2.2)) == "power-2.2");
  CHECK(curve_named(icc_gamma(2.19921875)) == "power-2.2");  // the exponent of Adobe RGB
  CHECK(curve_named(icc_formula(1, {2.2, 1, 0})) == "power-2.2");
  CHECK(curve_named(icc_formula(2, {2.2, 1, 0, 0})) == "power-2.2");
  CHECK(curve_named(icc_gamma(1.8)).starts_with("gamma 0.55"));
  // The curve of BT.709 for cameras.
  CHECK(curve_named(icc_formula(3, {1 / 0.45, 1 / 1.099, 0.099 / 1.099, 1 / 4.5, 0.081})) ==
        "a curve of its own");
  const auto mixed = icc_colors(icc_profile("RGB ", {{"rXYZ", icc_xyz(icc_srgb[0])},
                                                     {"gXYZ", icc_xyz(icc_srgb[1])},
                                                     {"bXYZ", icc_xyz(icc_srgb[2])},
                                                     {"rTRC", icc_gamma(2.2)},
                                                     {"gTRC", icc_gamma(1)},
                                                     {"bTRC", icc_gamma(2.2)}}));
  REQUIRE(mixed);
  CHECK(mixed->curve == "a curve of its own");
}

TEST_CASE("primaries of a profile are named by where they lie") {
  const auto named = [](const IccColorants& colorants) {
    const auto colors = icc_colors(icc_rgb(colorants, icc_srgb_curve()));
    return colors ? colors->primaries : "unread";
  };
  CHECK(named(icc_srgb) == "sRGB");
  CHECK(named(icc_display_p3) == "Display P3");
  CHECK(named(icc_adobe_rgb) == "Adobe RGB");
  CHECK(named(icc_rec2020) == "Rec. 2020");
  CHECK(named(icc_pro_photo) == "ProPhoto RGB");
  CHECK(named({{{0.9642, 0, 0}, {0, 1, 0}, {0, 0, 0.8249}}}) == "others");
  CHECK(icc_colors(icc_profile("GRAY", {{"kTRC", icc_gamma(2.2)}})) == IccColors{"power-2.2", "greys"});
}

TEST_CASE("a profile that is cut, or names what is not there, is not read, and nothing else happens") {
  const std::string whole = icc_rgb(icc_srgb, icc_table(table_of_srgb(64)));
  REQUIRE(icc_colors(whole));
  for (std::size_t size = 0; size < whole.size(); ++size) CHECK_FALSE(icc_colors(whole.substr(0, size)));
  for (std::size_t at = 0; at < 132 + 6 * 12; ++at)
    for (const char byte : {'\0', '\x7f', '\xff'}) {
      std::string changed = whole;
      changed[at] = byte;
      (void)icc_colors(changed);  // must not read outside of the bytes; the sanitizers notice
    }
  CHECK_FALSE(icc_colors(icc_profile("CMYK", {})));
  CHECK_FALSE(icc_colors(icc_profile("GRAY", {{"kTRC", icc_formula(7, {1})}})));
  CHECK_FALSE(icc_colors(icc_profile("GRAY", {{"kTRC", icc_formula(4, {1, 2})}})));
  CHECK_FALSE(icc_colors(icc_profile("GRAY", {{"kTRC", icc_formula(1, {2.2, 0, 1})}})));
  // 0 to a negative power is infinite.
  CHECK_FALSE(icc_colors(icc_profile("GRAY", {{"kTRC", icc_formula(0, {-30000})}})));
  CHECK_FALSE(icc_colors(icc_profile("RGB ", {{"A2B0", "mft2"}})));
  CHECK_FALSE(icc_colors(whole + std::string(largest_profile_bytes, '\0')));
}

TEST_CASE("the profile of a PNG file is read, whatever lies around it") {
  const std::string plain = make_png({3, 2});
  const auto header = [](const std::string& bytes) {
    BytesInMemory source(bytes);
    const auto out = png_header(source);
    REQUIRE(out);
    return *out;
  };
  CHECK(header(with_iccp(plain, icc_rgb(icc_srgb, icc_srgb_curve()))).colour_space == "srgb");
  const std::string linear = with_iccp(plain, icc_rgb(icc_display_p3, icc_gamma(1)));
  CHECK(header(linear).colour_space == "linear");
  CHECK(header(linear).primaries == "Display P3");
  CHECK(PngReader::open(linear, "t.png")->header().primaries == "Display P3");
  // A profile wins over gAMA, and an sRGB chunk over both.
  PngSpec spec{3, 2};
  spec.before = png_chunk("gAMA", big_endian(60000)) + iccp_chunk(icc_rgb(icc_display_p3, icc_gamma(1)));
  CHECK(header(make_png(spec)).colour_space == "linear");
  spec.before += png_chunk("sRGB", std::string(1, '\0'));
  CHECK(header(make_png(spec)).colour_space == "srgb");
  CHECK(header(make_png(spec)).primaries.empty());
  // These are not read: a chunk without a profile, a damaged stream, and a stream that never ends.
  CHECK(header(with_iccp(plain, "no profile")).colour_space == "icc: a profile");
  std::string damaged = linear;
  damaged[60] ^= 0x55;
  CHECK(header(damaged).colour_space == "icc: a profile");
  CHECK(header(with_iccp(plain, std::string(std::size_t{50} << 20, 'x'))).colour_space == "icc: a profile");
}
