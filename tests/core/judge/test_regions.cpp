// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <catch2/catch.hpp>

#include "core/judge/pixels/byte_masks.h"
#include "core/judge/pixels/regions.h"
#include "tests/core/judge/corpus.h"

using namespace etak;
using namespace etak::test;

namespace {

// Plateaus of grey pictures, the slow way: every step as the header words it, over whole pictures.
std::vector<int> plateau_bits(const std::vector<int>& grey, const std::vector<bool>& mask, int width,
                              int height) {
  const auto clamp_at = [&](int x, int y) {
    return static_cast<std::size_t>(std::clamp(y, 0, height - 1) * width + std::clamp(x, 0, width - 1));
  };
  std::vector<int> median(grey.size()), out(grey.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::array<int, 25> around{};
      for (int i = 0; i < 25; ++i)
        around[static_cast<std::size_t>(i)] = grey[clamp_at(x + i % 5 - 2, y + i / 5 - 2)];
      std::nth_element(around.begin(), around.begin() + 12, around.end());
      median[clamp_at(x, y)] = around[12];
    }
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      bool inside = true;
      int least = 255, most = 0;
      for (int i = 0; i < 9; ++i) {
        const std::size_t at = clamp_at(x + i % 3 - 1, y + i / 3 - 1);
        inside = inside && mask[at];
        least = std::min(least, median[at]);
        most = std::max(most, median[at]);
      }
      out[clamp_at(x, y)] = inside && most - least <= 4;
    }
  return out;
}

struct Run {
  std::vector<int> bits;
  std::vector<PlateauSummary> found;
};

// The same by RegionAnalysis: the zone's mask 124..178.
Run analyse(const std::vector<int>& grey, int width, int height, std::size_t least_area) {
  const CodeTables& tables = code_tables(TextureTransfer::srgb);
  const std::array kinds{RegionKind::zone};
  RegionAnalysis analysis({0, 0, width, height}, kinds, 3, least_area, tables);
  Run run;
  run.bits.resize(grey.size());
  analysis.record([&](std::size_t, int y, const std::uint64_t* words) {
    for (int x = 0; x < width; ++x)
      run.bits[static_cast<std::size_t>(y * width + x)] = words[x / 64] >> (x % 64) & 1;
  });
  std::vector<std::uint8_t> texels(grey.size() * 4);
  for (std::size_t i = 0; i < grey.size(); ++i)
    for (std::size_t c = 0; c < 4; ++c) texels[4 * i + c] = static_cast<std::uint8_t>(grey[i]);
  std::vector<std::uint64_t> words(analysis.word_count());
  const auto rows = [&](int y) -> RowPointers {
    const std::uint8_t* row =
        texels.data() + 4 * static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    return {row, row, nullptr};
  };
  for (int y = 0; y < height; ++y) {
    std::fill(words.begin(), words.end(), 0);
    for (int x = 0; x < width; ++x) {
      const int code = grey[static_cast<std::size_t>(y * width + x)];
      if (code >= 124 && code <= 178) words[static_cast<std::size_t>(x / 64)] |= std::uint64_t{1} << (x % 64);
    }
    analysis.push(y, words.data(), rows);
  }
  run.found = analysis.finish();
  return run;
}

// 8-connected groups by flooding.
std::vector<std::size_t> group_sizes(std::vector<int> bits, int width, int height) {
  std::vector<std::size_t> sizes;
  for (int start = 0; start < width * height; ++start) {
    if (bits[static_cast<std::size_t>(start)] == 0) continue;
    std::vector<int> open{start};
    bits[static_cast<std::size_t>(start)] = 0;
    for (std::size_t i = 0; i < open.size(); ++i)
      for (int k = 0; k < 9; ++k) {
        const int x = open[i] % width + k % 3 - 1, y = open[i] / width + k / 3 - 1;
        if (x < 0 || y < 0 || x >= width || y >= height || bits[static_cast<std::size_t>(y * width + x)] == 0)
          continue;
        bits[static_cast<std::size_t>(y * width + x)] = 0;
        open.push_back(y * width + x);
      }
    sizes.push_back(open.size());
  }
  std::sort(sizes.rbegin(), sizes.rend());
  return sizes;
}

}  // namespace

TEST_CASE("the 5x5 median of vectors is the 13th of 25 sorted values") {
  Random random(3);
  for (int trial = 0; trial < 400; ++trial) {
    std::array<std::array<std::uint8_t, 20>, 5> rows{};
    const int span = 1 + random.below(255);  // many equal values, too
    for (auto& row : rows)
      for (auto& v : row) v = static_cast<std::uint8_t>(random.below(span + 1));
    const std::uint8_t* const pointers[5] = {rows[0].data(), rows[1].data(), rows[2].data(), rows[3].data(),
                                             rows[4].data()};
    std::uint8_t out[16];
    median_5x5(pointers, out);
    for (std::size_t x = 0; x < 16; ++x) {
      std::vector<std::uint8_t> all;
      for (const auto& row : rows)
        all.insert(all.end(), row.begin() + static_cast<std::ptrdiff_t>(x),
                   row.begin() + static_cast<std::ptrdiff_t>(x) + 5);
      std::sort(all.begin(), all.end());
      REQUIRE(out[x] == all[12]);
    }
  }
}

TEST_CASE("regions are those of the slow way, at every size and noise") {
  Random random(5);
  for (int trial = 0; trial < 60; ++trial) {
    const int width = 1 + random.below(trial < 30 ? 150 : 70), height = 1 + random.below(60);
    const int noise = random.below(12);
    std::vector<int> grey(static_cast<std::size_t>(width * height), 60);
    for (int i = 0; i < 6; ++i) {
      const int x0 = random.below(width), y0 = random.below(height), w = 1 + random.below(40),
                h = 1 + random.below(30);
      const int level = 110 + random.below(80);
      for (int y = y0; y < std::min(height, y0 + h); ++y)
        for (int x = x0; x < std::min(width, x0 + w); ++x)
          grey[static_cast<std::size_t>(y * width + x)] = level;
    }
    for (int& code : grey) code = std::clamp(code + random.below(2 * noise + 1) - noise, 0, 255);
    std::vector<bool> mask(grey.size());
    for (std::size_t i = 0; i < grey.size(); ++i) mask[i] = grey[i] >= 124 && grey[i] <= 178;
    const Run run = analyse(grey, width, height, 5);
    const auto expected = plateau_bits(grey, mask, width, height);
    INFO("trial " << trial << ": " << width << " x " << height << ", noise " << noise);
    REQUIRE(run.bits == expected);
    auto sizes = group_sizes(expected, width, height);
    std::erase_if(sizes, [](std::size_t n) { return n < 5; });
    REQUIRE(run.found[0].regions == sizes.size());
    std::size_t area = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      area += sizes[i];
      REQUIRE(run.found[0].largest[i].area == sizes[i]);
    }
    REQUIRE(run.found[0].area == area);
    REQUIRE(run.found[0].masked == static_cast<std::size_t>(std::count(mask.begin(), mask.end(), true)));
  }
}

TEST_CASE("isolated squares leave plateaus of 1, 24, 52, 88 and 184 texels") {
  for (const auto& [side, expected] :
       {std::pair(5, 1), std::pair(8, 24), std::pair(10, 52), std::pair(12, 88), std::pair(16, 184)}) {
    std::vector<int> grey(64 * 64, 56);
    for (int y = 20; y < 20 + side; ++y)
      for (int x = 20; x < 20 + side; ++x) grey[static_cast<std::size_t>(y * 64 + x)] = 149;
    INFO(side);
    CHECK(analyse(grey, 64, 64, 1).found[0].area == static_cast<std::size_t>(expected));
  }
}

TEST_CASE("byte tests give the same masks in both sets of instructions as one texel at a time") {
  Random random(11);
  const ByteLimits limits;
  std::array<std::uint8_t, 256> a{}, b{};
  for (int trial = 0; trial < 300; ++trial) {
    const int kind = random.below(4);
    for (std::size_t i = 0; i < 256; ++i) {
      a[i] = static_cast<std::uint8_t>(kind == 0 ? 0 : random.below(256));
      b[i] =
          static_cast<std::uint8_t>(kind == 1 ? 120 + random.below(64) : random.below(kind == 2 ? 3 : 256));
      if (i % 4 == 3 && random.below(3) == 0) a[i] = random.below(2) == 0 ? 0 : 255;
    }
    MaskWords plain{}, wide{};
    MaskCounts sums, wide_sums;
    const bool transparency = random.below(2) == 0;
    const std::uint64_t valid = trial % 3 == 0 ? 0xffffffffffu : ~std::uint64_t{0};
    byte_masks_plain()(a.data(), b.data(), 1, valid, transparency, limits, &plain, sums);
    byte_masks()(a.data(), b.data(), 1, valid, transparency, limits, &wide, wide_sums);
    std::uint64_t sum = 0, squares = 0;
    for (std::size_t i = 0; i < 64; ++i) {
      const std::uint8_t *p = &a[4 * i], *q = &b[4 * i];
      const auto in_zone = [](std::uint8_t v) { return v >= 124 && v <= 178; };
      const int most = std::max({q[0], q[1], q[2]}), least = std::min({q[0], q[1], q[2]});
      const int a_most = std::max({p[0], p[1], p[2]}), a_least = std::min({p[0], p[1], p[2]});
      const auto bit = [&](std::uint64_t word) { return (word >> i & 1) != 0; };
      for (const MaskWords* m : {&plain, &wide}) {
        const bool counts = bit(valid);
        REQUIRE(bit(m->opaque) == (counts && (transparency ? p[3] == 255 : p[3] != 0)));
        REQUIRE(bit(m->alpha_zero) == (counts && p[3] == 0));
        REQUIRE(bit(m->alpha_full) == (counts && p[3] == 255));
        REQUIRE(bit(m->alpha_middle) == (counts && p[3] > 8 && p[3] < 247));
        REQUIRE(bit(m->zone_any) == (in_zone(q[0]) || in_zone(q[1]) || in_zone(q[2])));
        REQUIRE(bit(m->zone_all) == (in_zone(q[0]) && in_zone(q[1]) && in_zone(q[2])));
        REQUIRE(bit(m->black) == (most == 0));
        REQUIRE(bit(m->nearly_black) == (most <= 1));
        REQUIRE(bit(m->spread) == (most - least > 4));
        REQUIRE(bit(m->bluish) == (q[2] - q[0] > 12));
        for (int level = 0; level < ByteLimits::b_levels; ++level) {
          REQUIRE(bit(m->b_below[level]) == (most < limits.b_level[level]));
          REQUIRE(bit(m->b_from[level]) == (least >= limits.b_level[level]));
        }
        for (int level = 0; level < ByteLimits::a_levels; ++level) {
          REQUIRE(bit(m->a_below[level]) == (a_most < limits.a_level[level]));
          REQUIRE(bit(m->a_from[level]) == (a_least >= limits.a_level[level]));
        }
        REQUIRE(bit(m->diffuse_on_metal) == (a_most > 30));
        REQUIRE(bit(m->diffuse_black) == (a_most <= 2));
        REQUIRE(bit(m->single_channel) == (a_least == 0 && a_most > 124));
        REQUIRE(bit(m->energy_doubt) == (p[0] + q[0] > 255 || p[1] + q[1] > 255 || p[2] + q[2] > 255));
        REQUIRE(bit(m->gloss_zero) == (q[3] == 0));
        REQUIRE(bit(m->gloss_full) == (q[3] == 255));
      }
      if (p[3] != 0) {
        sum += q[3];
        squares += std::uint64_t{q[3]} * q[3];
      }
    }
    for (const MaskCounts* counts : {&sums, &wide_sums}) {
      REQUIRE(counts->gloss_sum == sum);
      REQUIRE(counts->gloss_squares == squares);
      REQUIRE(counts->opaque == static_cast<std::uint64_t>(std::popcount(plain.opaque)));
      REQUIRE(counts->zone_any == static_cast<std::uint64_t>(std::popcount(plain.zone_any & valid)));
      REQUIRE(counts->zone_all == static_cast<std::uint64_t>(std::popcount(plain.zone_all & valid)));
      REQUIRE(counts->black == static_cast<std::uint64_t>(std::popcount(plain.black & valid)));
      REQUIRE(counts->gloss_zero ==
              static_cast<std::uint64_t>(std::popcount(plain.gloss_zero & plain.opaque)));
      REQUIRE(counts->gloss_full ==
              static_cast<std::uint64_t>(std::popcount(plain.gloss_full & plain.opaque)));
    }
  }
}

TEST_CASE("luminance codes of greys are the greys, and the zone is codes 124 to 178") {
  for (const TextureTransfer transfer :
       {TextureTransfer::srgb, TextureTransfer::power_22, TextureTransfer::linear}) {
    const CodeTables& tables = code_tables(transfer);
    for (int code = 0; code < 256; ++code) {
      const auto c = static_cast<std::uint8_t>(code);
      const std::uint8_t rgb[3] = {c, c, c};
      CHECK(tables.luminance_code(rgb) == code);
    }
  }
  const CodeTables& srgb = code_tables(TextureTransfer::srgb);
  CHECK(srgb.first_code_at_least(first_above(0.20)) == 124);
  CHECK(srgb.first_code_at_least(first_at_least(0.45)) == 179);
  CHECK(code_tables(TextureTransfer::power_22).first_code_at_least(first_above(0.20)) == 123);
  CHECK(code_tables(TextureTransfer::power_22).first_code_at_least(first_at_least(0.45)) == 178);
}

TEST_CASE(
    "edges between metal and dielectric never make a region up to sigma 4, and a hidden patch always does") {
  const int size = 512;
  for (const double sigma : {0.0, 1.0, 2.0, 4.0, 8.0})
    for (const double metal : {0.55, 0.95})
      for (const Blend blend : {Blend::linear, Blend::encoded}) {
        const Pixels<float> mask = blob_mask(size, sigma, 21);
        TextureSet set = blended_set(mask, 0.04, metal, blend);
        INFO("sigma " << sigma << ", metal " << metal << ", "
                      << (blend == Blend::linear ? "linear" : "encoded"));
        if (sigma <= 4) CHECK(!found(check_set(set), "ETK101"));
        const auto [x0, y0] = emptiest_place(mask);
        for (int y = y0 - 5; y < y0 + 5; ++y)
          for (int x = x0 - 5; x < x0 + 5; ++x)
            for (std::size_t c = 0; c < 3; ++c) set.b.at(x, y)[c] = 149;
        const CheckedFile file = check_set(set);
        REQUIRE(found(file, "ETK101", Severity::warning));
        if (sigma > 4) continue;
        const auto finding = std::ranges::find(file.findings, "ETK101", &Finding::rule);
        CHECK(finding->area_px == 52);
        CHECK(finding->box->x >= x0 - 5);
        CHECK(finding->box->y >= y0 - 5);
        CHECK(finding->box->x + finding->box->width <= x0 + 5);
        CHECK(finding->box->y + finding->box->height <= y0 + 5);
      }
}
