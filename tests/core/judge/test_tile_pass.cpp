// SPDX-License-Identifier: Apache-2.0
// The pass over one tile, against plain loops over its texels.
#include "core/judge/pixels/tile_pass.h"

#include <catch2/catch.hpp>

#include "core/judge/pixels/plan.h"
#include "tests/core/judge/corpus.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr int picture_width = 150, picture_height = 40;

Image8 random_codes(std::uint64_t seed) {
  Image8 out(picture_width, picture_height, 4);
  Random random(seed);
  for (std::uint8_t& code : out.values)
    code = static_cast<std::uint8_t>(random.below(4) == 0 ? 255 * random.below(2) : random.below(256));
  return out;
}

CheckTile tile_of(const PixelBox& box) {
  CheckTile out;
  out.box = box;
  return out;
}

struct Planes {
  const Image8 *a, *b, *metallic = nullptr;

  RowPointers row(int x, int y) const {
    return {a->at(x, y).data(), b->at(x, y).data(),
            metallic == nullptr ? nullptr : metallic->at(x, y).data()};
  }
};

// What a pass finds in a tile whose rows the plan's workers count in turn.
TileEvidence passed(const Planes& planes, const CheckTile& tile, const PassPlan& plan,
                    bool every_row = false) {
  TilePass pass(tile, plan, RegionAnalysis::rows_kept, every_row);
  const auto rows = [&](int y) { return planes.row(tile.box.x, y); };
  for (int y = tile.box.y; y < tile.box.y + tile.box.height; ++y) {
    pass.count_row(static_cast<unsigned>(y) % plan.workers, y, rows(y));
    pass.follow_row(y, rows);
  }
  return pass.finish();
}

template <class Act>
void each_place(const PixelBox& box, Act act) {
  for (int y = box.y; y < box.y + box.height; ++y)
    for (int x = box.x; x < box.x + box.width; ++x) act(x, y);
}

std::size_t masked(const TileEvidence& tile, RegionKind kind) {
  const PlateauSummary* found = tile.region(kind);
  REQUIRE(found != nullptr);
  return found->masked;
}

}  // namespace

TEST_CASE("the counts of a tile are those of a plain loop over its texels, whichever worker counts a row") {
  const Image8 a = random_codes(1), b = random_codes(2);
  const PixelBox box{5, 3, 131, 34};
  for (const unsigned workers : {1u, 3u}) {
    const PassPlan plan = first_plan({}, {}, true, true, false, workers);
    ByteCounts plain;
    each_place(box, [&](int x, int y) {
      const auto diffuse = a.at(x, y), specular = b.at(x, y);
      const int alpha = diffuse[3], gloss = specular[3];
      plain.alpha_zero += alpha == 0;
      plain.alpha_full += alpha == 255;
      if (alpha == 0) return;
      ++plain.opaque;
      plain.gloss_sum += static_cast<std::uint64_t>(gloss);
      const bool metal = plan.tables->luminance(specular.data()) >= plan.b_y[b_metal];
      plain.metals += metal;
      std::uint64_t worst = 0;
      for (std::size_t c = 0; c < 3; ++c)
        worst = std::max<std::uint64_t>(worst,
                                        plan.tables->linear[diffuse[c]] + plan.tables->linear[specular[c]]);
      plain.energy_over += worst > plan.energy_limit;
      plain.energy_far_over += worst > plan.energy_far_limit;
      plain.energy_worst = std::max(plain.energy_worst, worst);
      const int most = std::max({diffuse[0], diffuse[1], diffuse[2]});
      if (alpha >= ByteLimits::alpha_middle_first && alpha <= ByteLimits::alpha_middle_last && !metal &&
          most > plan.limits.black_diffuse) {
        ++plain.middle;
        plain.middle_below += most <= alpha + 1;
      }
    });
    const ByteCounts counts = passed({&a, &b}, tile_of(box), plan).counts;
    CHECK(counts.texels == box.area());
    CHECK(counts.alpha_zero == plain.alpha_zero);
    CHECK(counts.alpha_full == plain.alpha_full);
    CHECK(counts.opaque == plain.opaque);
    CHECK(counts.gloss_sum == plain.gloss_sum);
    CHECK(counts.metals == plain.metals);
    CHECK(counts.energy_over == plain.energy_over);
    CHECK(counts.energy_far_over == plain.energy_far_over);
    CHECK(counts.energy_worst == plain.energy_worst);
    CHECK(counts.middle == plain.middle);
    CHECK(counts.middle_below == plain.middle_below);
    const auto [x, y] = counts.energy_place;
    CHECK(around(counts.energy_box, PixelBox{x, y, 1, 1}) == counts.energy_box);
    CHECK(around(box, counts.energy_box) == box);
  }
}

TEST_CASE("each kind of region marks the opaque texels that its condition names") {
  const Image8 a = random_codes(3), b = random_codes(4), metallic = random_codes(5);
  const PixelBox box{0, 0, picture_width, picture_height};
  PassPlan plan = first_plan({}, {}, true, true, true, 1);
  plan.kinds = {RegionKind::zone,          RegionKind::f0_zero,    RegionKind::any_f0,
                RegionKind::albedo_bright, RegionKind::half_metal, RegionKind::dark_metal};
  std::array<std::size_t, 6> expected{};
  each_place(box, [&](int x, int y) {
    if (a.at(x, y)[3] == 0) return;
    const auto specular = b.at(x, y);
    const std::uint32_t luminance = plan.tables->luminance(specular.data());
    const int metal = metallic.at(x, y)[0];
    expected[0] += luminance >= plan.b_y[b_zone] && luminance < plan.b_y[b_metal];
    expected[1] += std::max({specular[0], specular[1], specular[2]}) <= 1;
    expected[2] += 1;
    expected[3] += plan.tables->luminance(a.at(x, y).data()) >= plan.a_y[a_bright];
    expected[4] += metal >= half_metal_first_code && metal < metal_first_code;
    expected[5] += metal >= metal_first_code && luminance < plan.b_y[b_zone];
  });
  const TileEvidence found = passed({&a, &b, &metallic}, tile_of(box), plan);
  for (std::size_t kind = 0; kind < plan.kinds.size(); ++kind) {
    INFO(kind);
    CHECK(masked(found, plan.kinds[kind]) == expected[kind]);
    CHECK(expected[kind] > 0);
  }
}

TEST_CASE("hidden texels of another colour are a fringe where a visible texel lies within two texels") {
  PassPlan plan = first_plan({}, {}, true, true, false, 1);
  plan.kinds.clear();
  const Image8 b(picture_width, picture_height, 4);
  const PixelBox box{2, 1, 140, 36};
  // A strip of hidden texels across the first two words of a row of masks.
  for (const auto& [left, columns, difference, each] :
       {std::array{64, 1, 40, 1}, {60, 7, 40, 4}, {60, 7, 16, 0}, {63, 3, 17, 3}}) {
    Image8 a(picture_width, picture_height, 4, 255);
    each_texel(a, [&](auto texel, int x, int) {
      const bool hidden = x >= left && x < left + columns;
      set_rgb(texel, hidden ? std::array{100, 100 + difference, 100} : std::array{100, 100, 100});
      texel[3] = hidden ? 0 : 255;
    });
    const TileEvidence found = passed({&a, &b}, tile_of(box), plan);
    INFO(left << " " << columns << " " << difference);
    CHECK(found.fringe == static_cast<std::uint64_t>(each * box.height));
    CHECK(found.fringe_worst == (each > 0 ? difference : 0));
    if (each > 0) CHECK(found.fringe_place == std::array{left, box.y});
  }
}

TEST_CASE("details come from every 16th row of a tall tile, or from all rows where that is asked for") {
  Image8 a(30, 100, 4, 255), b(30, 100, 4, 7);
  const PassPlan plan = first_plan({}, {}, true, true, false, 1);
  const CheckTile tall = tile_of({0, 0, 30, 100}), low = tile_of({0, 10, 30, 64});
  const TileEvidence sample = passed({&a, &b}, tall, plan), all = passed({&a, &b}, tall, plan, true),
                     short_one = passed({&a, &b}, low, plan);
  CHECK(!sample.detail.every_row);
  CHECK(sample.detail.texels == 30 * 7);
  CHECK(sample.detail.b[3][7] == 30 * 7);
  CHECK(all.detail.every_row);
  CHECK(all.detail.texels == 30 * 100);
  CHECK(short_one.detail.every_row);
  CHECK(short_one.detail.smooth_a == 29 * 64);
}
