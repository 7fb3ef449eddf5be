// SPDX-License-Identifier: Apache-2.0
#include "core/image/mips.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <functional>
#include <random>

#include "core/color/srgb.h"
#include "core/image/linear_tables.h"
#include "core/image/mip_chain.h"
#include "core/image/mip_rows.h"
#include "tests/core/image/mip_reference.h"

namespace etak {
namespace {

using test::noise_picture;

// The largest difference in codes from the reference chain in double.
int off_from_reference(const Image8& a, const Image8& b, const MipOptions& options) {
  const MipPair pair = mip_pair(a, b, options);
  test::ReferenceLevel level = test::reference_base(a, b);
  int most = 0;
  for (std::size_t l = 1; l < pair.diffuse_alpha.size(); ++l) {
    level = test::reference_next(level, options.alpha_weights_diffuse);
    REQUIRE(pair.diffuse_alpha[l].width == level.width);
    REQUIRE(pair.specular_gloss[l].height == level.height);
    for (std::size_t i = 0; i < level.texels.size(); ++i) {
      const auto expected = test::reference_codes(level.texels[i]);
      for (std::size_t c = 0; c < 4; ++c) {
        most = std::max(most, std::abs(int{pair.diffuse_alpha[l].values[4 * i + c]} - expected[c]));
        most = std::max(most, std::abs(int{pair.specular_gloss[l].values[4 * i + c]} - expected[4 + c]));
      }
    }
  }
  return most;
}

Image8 constant_picture(int width, int height, std::uint8_t code) {
  return Image8(width, height, 4, code);
}

Image8 filled(int width, int height, const std::function<std::uint8_t(int, int, int)>& code) {
  Image8 out(width, height, 4);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 4; ++c) out.at(x, y)[static_cast<std::size_t>(c)] = code(x, y, c);
  return out;
}

double share_that_passes(const Image8& image, double cutoff) {
  return mip_detail::coverage(image.width, image.height, static_cast<float>(255 * cutoff), 1,
                              [&](int y, float* out) {
                                for (int x = 0; x < image.width; ++x) out[x] = image.at(x, y)[3];
                              });
}

const std::pair<int, int> odd_and_even_sizes[] = {{64, 64},  {3, 5},  {1, 1},   {1, 37},
                                                  {41, 1},   {2, 2},  {7, 8},   {63, 65},
                                                  {127, 31}, {96, 6}, {200, 3}, {130, 258}};

}  // namespace

TEST_CASE("tables give each float the code that the double formula gives") {
  const LinearTables& t = linear_tables();
  test::Noise noise{7};
  for (int i = 0; i < 200000; ++i) {
    const float x = static_cast<float>(noise.next()) / 2147483648.0f;
    REQUIRE(t.srgb_code(x) == srgb_u8(double{x}));
    const float v = std::exp2(-12.5f * x);
    const auto gloss = static_cast<int>(std::max(0.0, 255 * (-std::log2(double{v}) / 12)) + 0.5);
    REQUIRE(t.gloss_code(v) == std::min(255, gloss));
  }
  for (int c = 0; c < 256; ++c) {
    const auto at = static_cast<std::size_t>(c);
    CHECK(t.srgb_code(t.srgb[at]) == c);
    CHECK(t.gloss_code(t.inverse[at]) == c);
    if (c == 0) continue;
    CHECK(t.srgb_code(t.srgb_step[at]) == c);
    CHECK(t.srgb_code(std::nextafter(t.srgb_step[at], 0.0f)) == c - 1);
    CHECK(t.gloss_code(t.gloss_step[at]) == c);
    CHECK(t.gloss_code(std::nextafter(t.gloss_step[at], 2.0f)) == c - 1);
  }
  CHECK(t.srgb_code(-1) == 0);
  CHECK(t.srgb_code(2) == 255);
  CHECK(t.gloss_code(1e30f) == 0);
  CHECK(t.gloss_code(INFINITY) == 0);
  CHECK(t.gloss_code(1e-30f) == 255);
}

TEST_CASE("mips are within one code of the chain in double, on noise of odd and even sides") {
  for (const auto& [width, height] : odd_and_even_sizes) {
    CAPTURE(width, height);
    const Image8 a = noise_picture(width, height, 1), b = noise_picture(width, height, 2);
    CHECK(off_from_reference(a, b, {}) <= 1);
    MipOptions plain;
    plain.alpha_weights_diffuse = false;
    CHECK(off_from_reference(a, b, plain) <= 1);
  }
}

TEST_CASE("loops of several texels give the same bits as the plain ones") {
  using namespace mip_detail;
  const MipRows* const fast = mip_rows();
  if (fast == nullptr) {
    WARN("this processor has plain loops only");
    return;
  }
  const LinearTables& tables = linear_tables();
  struct PlainRow {
    const std::uint8_t *codes_a, *codes_b;
    static Float4 texel(const std::uint8_t* c, float last) {
      const LinearTables& t = linear_tables();
      return Float4{t.srgb[c[0]], t.srgb[c[1]], t.srgb[c[2]], last};
    }
    Float4 a(int x) const { return texel(codes_a + 4 * x, static_cast<float>(codes_a[4 * x + 3])); }
    Float4 b(int x) const { return texel(codes_b + 4 * x, linear_tables().inverse[codes_b[4 * x + 3]]); }
    static Float4 n(int) { return Float4{}; }
  };
  constexpr int count = 8 * 40;
  std::mt19937 random(11);
  for (int round = 0; round < 60; ++round) {
    std::array<std::vector<std::uint8_t>, 4> rows;
    for (auto& row : rows) {
      row.resize(8 * count);
      // The rows are noise, few codes, black and white, or all zero.
      for (auto& code : row)
        code = static_cast<std::uint8_t>(round % 4 == 0   ? random()
                                         : round % 4 == 1 ? random() % 3
                                         : round % 4 == 2 ? 255 * (random() % 2)
                                                          : random() % 2 * 254);
      if (round % 5 == 4)
        for (std::size_t x = 3; x < row.size(); x += 4) row[x] = 0;
    }
    const std::array plain_rows{PlainRow{rows[0].data(), rows[2].data()},
                                PlainRow{rows[1].data(), rows[3].data()}, PlainRow{}};
    const bool weigh = round % 3 != 0;
    std::vector<Texel> a(count), b(count), plain_a(count), plain_b(count);
    average_rows(plain_rows, Taps{0, 2, {0.5f, 0.5f, 0}}, 2 * count, count, weigh,
                 {plain_a.data(), plain_b.data(), nullptr});
    REQUIRE(fast->average(rows[0].data(), rows[1].data(), rows[2].data(), rows[3].data(), count, weigh,
                          tables, a.data(), b.data()) == count);
    CHECK(std::memcmp(a.data(), plain_a.data(), count * sizeof(Texel)) == 0);
    CHECK(std::memcmp(b.data(), plain_b.data(), count * sizeof(Texel)) == 0);

    if (round % 2 == 1)
      for (auto* texels : {&a, &b})
        for (Texel& texel : *texels)  // beyond both ends of the range of codes
          for (int c = 0; c < 4; ++c)
            texel.v[c] = std::ldexp(static_cast<float>(random() % 4096), -11 - round / 4);
    std::vector<std::uint8_t> codes_a(4 * count), codes_b(4 * count);
    std::size_t wider = 0, plain_wider = 0;
    REQUIRE(fast->encode(a.data(), b.data(), count, tables, 1, codes_a.data(), codes_b.data(), wider) ==
            count);
    for (std::size_t x = 0; x < count; ++x) {
      for (int c = 0; c < 3; ++c) {
        REQUIRE(int{codes_a[4 * x + static_cast<std::size_t>(c)]} == int{tables.srgb_code(a[x].v[c])});
        REQUIRE(int{codes_b[4 * x + static_cast<std::size_t>(c)]} == int{tables.srgb_code(b[x].v[c])});
      }
      REQUIRE(int{codes_a[4 * x + 3]} == int{static_cast<std::uint8_t>(static_cast<int>(a[x].v[3] + 0.5f))});
      if (b[x].v[3] > 0) REQUIRE(int{codes_b[4 * x + 3]} == int{tables.gloss_code(b[x].v[3])});
      plain_wider += b[x].v[3] > 1 ? 1 : 0;
    }
    CHECK(wider == plain_wider);
  }
}

TEST_CASE("mips of a 1-px checker and of an impulse are within one code of the chain in double") {
  for (const auto& [width, height] : odd_and_even_sizes) {
    CAPTURE(width, height);
    const Image8 checker = filled(width, height, [](int x, int y, int c) {
      return static_cast<std::uint8_t>((x + y) % 2 == 0 ? 255 : 20 * c);
    });
    CHECK(off_from_reference(checker, checker, {}) <= 1);
    Image8 impulse = constant_picture(width, height, 0);
    for (auto& code : impulse.at(width / 2, height / 3)) code = 255;
    CHECK(off_from_reference(impulse, impulse, {}) <= 1);
  }
}

TEST_CASE("constant pictures stay exactly constant, for all codes and channels") {
  for (const auto& [width, height] : {std::pair{16, 16}, {13, 7}})
    for (int code = 0; code < 256; ++code) {
      const auto a =
          filled(width, height, [&](int, int, int c) { return static_cast<std::uint8_t>(code + 64 * c); });
      const auto b =
          filled(width, height, [&](int, int, int c) { return static_cast<std::uint8_t>(code + 37 * c); });
      const MipPair pair = mip_pair(a, b, {});
      for (std::size_t l = 1; l < pair.diffuse_alpha.size(); ++l)
        for (std::size_t i = 0; i < pair.diffuse_alpha[l].values.size(); ++i) {
          REQUIRE(pair.diffuse_alpha[l].values[i] == a.values[i % 4]);
          REQUIRE(pair.specular_gloss[l].values[i] == b.values[i % 4]);
        }
    }
}

TEST_CASE("a linear ramp keeps its centre of mass on odd sides, where plain 2 x 2 boxes shift it") {
  for (const int width : {64, 63, 37, 101, 5}) {
    CAPTURE(width);
    Image a(width, 1, 4), b(width, 1, 4, 0.5f);
    for (int x = 0; x < width; ++x)
      for (auto& v : a.at(x, 0)) v = (static_cast<float>(x) + 0.5f) / static_cast<float>(width);
    MipOptions plain;
    plain.alpha_weights_diffuse = false;
    for (const Image& level : mip_pair(a, b, plain).diffuse_alpha) {
      double mass = 0;
      for (int x = 0; x < level.width; ++x) {
        mass += double{level.at(x, 0)[0]} / level.width;
        // The mean of a ramp over an area is the value of the ramp in the middle of the area. The next odd
        // level is made of steps and no longer of the ramp.
        if (2 * level.width >= width - 1)
          CHECK(level.at(x, 0)[1] ==
                Approx((x + 0.5) / level.width).margin(1e-6 + 0.6 / width / level.width));
      }
      CHECK(mass == Approx(0.5).epsilon(1e-5));
    }
  }
}

TEST_CASE("means of light: a black and white checker becomes code 188, not 128") {
  const Image8 checker = filled(8, 8, [](int x, int y, int c) {
    return static_cast<std::uint8_t>(c == 3 || (x + y) % 2 == 0 ? 255 : 0);
  });
  const MipPair pair = mip_pair(checker, checker, {});
  CHECK(int{pair.diffuse_alpha[1].at(0, 0)[0]} == 188);
  CHECK(int{pair.diffuse_alpha.back().at(0, 0)[2]} == 188);
}

TEST_CASE("diffuse under alpha 0 does not count, and counts alike where all is hidden") {
  Image8 a(2, 2, 4, 0);
  a.at(0, 0)[0] = 200;
  a.at(0, 0)[3] = 255;
  for (const auto& [x, y] : {std::pair{1, 0}, {0, 1}, {1, 1}}) a.at(x, y)[1] = 250;
  const Image8 b = constant_picture(2, 2, 100);
  const MipPair weighted = mip_pair(a, b, {});
  CHECK(int{weighted.diffuse_alpha[1].at(0, 0)[0]} == 200);
  CHECK(int{weighted.diffuse_alpha[1].at(0, 0)[1]} == 0);
  CHECK(int{weighted.diffuse_alpha[1].at(0, 0)[3]} == 64);  // 63.75
  a.at(0, 0)[3] = 0;
  CHECK(int{mip_pair(a, b, {}).diffuse_alpha[1].at(0, 0)[1]} > 200);
  // The specular colour does not depend on alpha.
  CHECK(weighted.specular_gloss[1] == constant_picture(1, 1, 100));
}

TEST_CASE("gloss is the mean of 1/e, weighted by the luminance of F0") {
  Image8 a = constant_picture(2, 1, 255), b = constant_picture(2, 1, 128);
  b.at(0, 0)[3] = 255;  // e = 4096
  b.at(1, 0)[3] = 0;    // e = 1
  // 1/e' = (1 + 1/4096) / 2, so g' = 0.0833 and the code 21.2.
  CHECK(int{mip_pair(a, b, {}).specular_gloss[1].at(0, 0)[3]} == 21);
  // A texel that reflects nothing has no weight in the mean of the lobes.
  for (std::size_t c = 0; c < 3; ++c) b.at(1, 0)[c] = 0;
  CHECK(int{mip_pair(a, b, {}).specular_gloss[1].at(0, 0)[3]} == 255);
}

TEST_CASE("a bumpy normal map widens the lobe as the mean of the lobes turned does") {
  // The normals have slopes of +-s along both axes. The reference turns the lobe cos^e by each normal and
  // compares the second moment of the mean lobe, along one axis, with that of a single lobe.
  const double s = 0.08;
  const std::uint8_t gloss = 140;
  const double e = std::exp2(12 * gloss / 255.0);
  Image8 normals(16, 16, 3);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const double p = x % 2 == 0 ? s : -s, q = y % 2 == 0 ? s : -s, length = std::sqrt(1 + p * p + q * q);
      const double n[3] = {p / length, q / length, 1 / length};
      for (std::size_t c = 0; c < 3; ++c)
        normals.at(x, y)[c] = static_cast<std::uint8_t>(std::floor((n[c] + 1) * 127.5 + 0.5));
    }
  const auto second_moment = [&](double p, double q) {
    // The moment of p' over the plane of slopes, with the weight cos^e of the angle to the normal (p, q, 1).
    double weight = 0, moment = 0;
    for (double u = -1; u <= 1; u += 0.01)
      for (double v = -1; v <= 1; v += 0.01) {
        const double cosine = (1 + u * p + v * q) / std::sqrt((1 + u * u + v * v) * (1 + p * p + q * q));
        const double w = std::pow(cosine, e);
        weight += w;
        moment += w * u * u;
      }
    return moment / weight;
  };
  const double widened = second_moment(s, s) - second_moment(0, 0);
  const Image8 a = constant_picture(16, 16, 255), b = constant_picture(16, 16, gloss);
  for (const NormalVariance kind : {NormalVariance::toksvig, NormalVariance::slopes}) {
    MipOptions options;
    options.normals = &normals;
    options.normal_variance = kind;
    const MipPair pair = mip_pair(a, b, options);
    CHECK(pair.specular_gloss[0] == b);
    const double expected = -std::log2(1 / e + widened) / 12 * 255;
    // One code is 3 % of the variance, and the normals have 8 bits only.
    CHECK(std::abs(int{pair.specular_gloss[1].at(0, 0)[3]} - expected) <= 2);
    CHECK(int{pair.specular_gloss.back().at(0, 0)[3]} == int{pair.specular_gloss[1].at(0, 0)[3]});
    CHECK(expected < gloss - 8);
    CHECK(pair.gloss_clamped == 0);
  }
}

TEST_CASE("a flat normal map leaves gloss alone; a lobe wider than gloss 0 is counted") {
  const Image8 a = constant_picture(8, 8, 255), b = constant_picture(8, 8, 90);
  Image8 normals(8, 8, 3, 128);
  for (std::size_t i = 2; i < normals.values.size(); i += 3) normals.values[i] = 255;
  MipOptions options;
  options.normals = &normals;
  CHECK(mip_pair(a, b, options).specular_gloss == mip_pair(a, b, {}).specular_gloss);
  // The mean of flat normals in opposite directions is almost zero.
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      normals.at(x, y)[0] = x % 2 == 0 ? 0 : 255;
      normals.at(x, y)[2] = 128;
    }
  const MipPair wide = mip_pair(a, b, options);
  CHECK(wide.gloss_clamped == 16 + 4 + 1);
  CHECK(int{wide.specular_gloss[1].at(0, 0)[3]} == 0);
}

TEST_CASE("a mask's coverage stays, where the plain mean loses it") {
  // Blades of grass: thin opaque strokes on a transparent ground.
  const Image8 a = filled(256, 256, [](int x, int y, int c) {
    return static_cast<std::uint8_t>(c < 3 ? 120 : (x + y / 5) % 7 < 2 && (y * 3 + x) % 31 < 24 ? 255 : 0);
  });
  const Image8 b = noise_picture(256, 256, 5);
  MipOptions options;
  options.alpha_cutoff = 0.5;
  const MipPair kept = mip_pair(a, b, options), plain = mip_pair(a, b, {});
  const double share = share_that_passes(a, 0.5);
  REQUIRE(share > 0.1);
  REQUIRE(share < 0.4);
  for (std::size_t l = 1; l <= 5; ++l) {
    CAPTURE(l);
    const double now = share_that_passes(kept.diffuse_alpha[l], 0.5);
    CHECK(std::abs(now - share) <= std::abs(share_that_passes(plain.diffuse_alpha[l], 0.5) - share));
    CHECK(now == Approx(share).margin(l <= 3 ? 0.02 : 0.12));
  }
  CHECK(share_that_passes(plain.diffuse_alpha[4], 0.5) < share / 2);
  // Only opacity differs between the chains, and a level does not depend on the number of levels.
  CHECK(kept.specular_gloss == plain.specular_gloss);
  for (std::size_t i = 0; i < kept.diffuse_alpha[2].values.size(); ++i)
    if (i % 4 != 3) REQUIRE(kept.diffuse_alpha[2].values[i] == plain.diffuse_alpha[2].values[i]);
  options.levels = 3;
  CHECK(mip_pair(a, b, options).diffuse_alpha[2] == kept.diffuse_alpha[2]);
  // Where all texels have one alpha, there is no factor.
  for (const int alpha : {0, 100, 255}) {
    Image8 flat = a;
    for (std::size_t i = 3; i < flat.values.size(); i += 4) flat.values[i] = static_cast<std::uint8_t>(alpha);
    options.levels = 0;
    CHECK(mip_pair(flat, b, options).diffuse_alpha == mip_pair(flat, b, {}).diffuse_alpha);
  }
}

TEST_CASE("threads and the number of levels asked for change nothing") {
  const Image8 a = noise_picture(203, 517, 1), b = noise_picture(203, 517, 2);
  MipOptions options;
  options.alpha_cutoff = 0.3;
  const MipPair one = mip_pair(a, b, options, 1);
  CHECK(one.diffuse_alpha.size() == 10);
  for (const unsigned threads : {2u, 3u, 16u}) {
    const MipPair many = mip_pair(a, b, options, threads);
    CHECK(many.diffuse_alpha == one.diffuse_alpha);
    CHECK(many.specular_gloss == one.specular_gloss);
  }
  for (const int levels : {1, 2, 6, 7, 99}) {
    options.levels = levels;
    const MipPair some = mip_pair(a, b, options);
    REQUIRE(some.diffuse_alpha.size() == std::min<std::size_t>(10, static_cast<std::size_t>(levels)));
    for (std::size_t l = 0; l < some.diffuse_alpha.size(); ++l) {
      CHECK(some.diffuse_alpha[l] == one.diffuse_alpha[l]);
      CHECK(some.specular_gloss[l] == one.specular_gloss[l]);
    }
  }
}

TEST_CASE("a full chain has the levels that halving gives") {
  CHECK(full_mip_levels(1, 1) == 1);
  CHECK(full_mip_levels(2, 1) == 2);
  CHECK(full_mip_levels(3, 5) == 3);
  CHECK(full_mip_levels(16384, 16384) == 15);
  CHECK(full_mip_levels(4095, 8) == 12);
}

TEST_CASE("float mips agree with those of 8 bits") {
  const int width = 45, height = 30;
  const Image8 a = noise_picture(width, height, 3), b = noise_picture(width, height, 4);
  Image linear_a(width, height, 4), linear_b(width, height, 4);
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const auto value = [&](std::uint8_t code) {
      return static_cast<float>(i % 4 == 3 ? code / 255.0 : srgb_decode(code / 255.0));
    };
    linear_a.values[i] = value(a.values[i]);
    linear_b.values[i] = value(b.values[i]);
  }
  const MipPair codes = mip_pair(a, b, {});
  const MipPairFloat floats = mip_pair(linear_a, linear_b, {});
  REQUIRE(floats.diffuse_alpha.size() == codes.diffuse_alpha.size());
  for (std::size_t l = 0; l < codes.diffuse_alpha.size(); ++l)
    for (std::size_t i = 0; i < codes.diffuse_alpha[l].values.size(); ++i) {
      const auto code = [&](float v) { return i % 4 == 3 ? to_code(v) : srgb_u8(double{v}); };
      REQUIRE(std::abs(code(floats.diffuse_alpha[l].values[i]) - codes.diffuse_alpha[l].values[i]) <= 1);
      REQUIRE(std::abs(code(floats.specular_gloss[l].values[i]) - codes.specular_gloss[l].values[i]) <= 1);
    }
}

TEST_CASE("float mips keep values above 1 and let NaN through, without a fault") {
  Image a(4, 4, 4, 1), b(4, 4, 4, 0.25f);
  a.at(1, 1)[0] = 101;
  b.at(3, 3)[1] = std::nanf("");
  b.at(0, 0)[3] = -1;
  MipOptions options;
  options.alpha_cutoff = 0.5;
  const MipPairFloat pair = mip_pair(a, b, options);
  CHECK(pair.diffuse_alpha[1].at(0, 0)[0] == Approx(26));
  CHECK(std::isnan(pair.specular_gloss[1].at(1, 1)[1]));
  CHECK(pair.specular_gloss[1].at(1, 0)[3] == Approx(0.25));
}

}  // namespace etak
