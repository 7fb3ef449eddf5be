// SPDX-License-Identifier: Apache-2.0
// The pass over whole pictures: strips, tiles, workers and pictures of floats.
#include "core/judge/pixels/pixel_pass.h"

#include <catch2/catch.hpp>
#include <limits>

#include "core/judge/pixels/plan.h"
#include "tests/core/judge/corpus.h"

using namespace etak;
using namespace etak::test;

namespace {

// Rows of a picture of four float channels.
class FloatRows : public RowSource {
 public:
  explicit FloatRows(const Pixels<float>& image) : RowSource(header_of(image)), image_(image) {}
  void read_rows(std::uint8_t*, std::size_t, int) override { FAIL("codes of a picture of floats"); }
  void read_float_rows(float* rgba, std::size_t stride, int count) override {
    for (int i = 0; i < count; ++i, ++row_)
      std::copy_n(image_.at(0, row_).data(), 4 * static_cast<std::size_t>(image_.width),
                  rgba + static_cast<std::size_t>(i) * stride);
  }

 private:
  const Pixels<float>& image_;
  int row_ = 0;
};

CheckTile named_tile(const std::string& name, const PixelBox& box) {
  CheckTile out;
  out.name = name;
  out.box = box;
  return out;
}

PassResult passed_whole(PictureRows pictures, const std::vector<CheckTile>& tiles, const PassPlan& plan) {
  return pixel_pass(pictures, tiles, std::vector<bool>(tiles.size()), plan);
}

}  // namespace

TEST_CASE("workers change nothing in what a pass finds, and tiles come back in their order") {
  constexpr int width = 300, height = 700;  // three strips
  const TextureSet set = blended_set(blob_mask(704, 3, 8), 0.04, 0.9, Blend::linear);
  Image8 a(width, height, 4), b(width, height, 4);
  paste(set.a, 0, 0, a);
  paste(set.b, 0, 0, b);
  CheckTarget target;
  target.manifest.gutter = 4;
  target.manifest.tiles = {named_tile("low", {10, 600, 200, 90}), named_tile("all", {4, 4, 290, 690}),
                           named_tile("first", {20, 8, 64, 64}), named_tile("across", {100, 200, 99, 120})};
  std::vector<PassResult> results;
  for (const unsigned workers : {1u, 2u, 5u}) {
    const PassPlan plan = first_plan(target, {}, true, true, false, workers);
    results.push_back(passed_whole({rows_of(a), rows_of(b), nullptr}, target.manifest.tiles, plan));
    const PassResult& now = results.back();
    CHECK(now.stats.pictures_decoded == 2);
    CHECK(now.stats.passes == 1);
    CHECK(now.stats.texels == std::size_t{width} * height);
    REQUIRE(now.tiles.size() == target.manifest.tiles.size());
    for (std::size_t i = 0; i < now.tiles.size(); ++i) {
      const TileEvidence &one = results.front().tiles[i], &tile = now.tiles[i];
      INFO(workers << " workers, " << tile.tile.name);
      CHECK(tile.tile == target.manifest.tiles[i]);
      CHECK(tile.counts.texels == tile.tile.box.area());
      CHECK(tile.counts.metals == one.counts.metals);
      CHECK(tile.counts.energy_over == one.counts.energy_over);
      CHECK(tile.counts.gloss_squares == one.counts.gloss_squares);
      CHECK(tile.detail.b == one.detail.b);
      CHECK(tile.hash == one.hash);
      CHECK(tile.gutter_wrong == one.gutter_wrong);
      CHECK(tile.mip_bleed == one.mip_bleed);
      REQUIRE(tile.regions.size() == one.regions.size());
      for (std::size_t kind = 0; kind < one.regions.size(); ++kind) {
        CHECK(tile.regions[kind].masked == one.regions[kind].masked);
        CHECK(tile.regions[kind].largest == one.regions[kind].largest);
      }
    }
  }
  // Metal is where the picture has it, in a tile across strips too.
  std::uint64_t metals = 0;
  const PassPlan plan = first_plan(target, {}, true, true, false, 1);
  const PixelBox& across = target.manifest.tiles[3].box;
  for (int y = across.y; y < across.y + across.height; ++y)
    for (int x = across.x; x < across.x + across.width; ++x)
      metals += plan.tables->luminance(b.at(x, y).data()) >= plan.b_y[b_metal];
  CHECK(metals > 0);
  CHECK(results.front().tiles[3].counts.metals == metals);
}

TEST_CASE("without its diffuse picture a set is opaque all over, without its specular one it is black") {
  const Image8 codes(40, 30, 4, 90);
  const std::vector<CheckTile> tiles{named_tile("", {0, 0, 40, 30})};
  const PassResult specular =
      passed_whole({nullptr, rows_of(codes), nullptr}, tiles, first_plan({}, {}, false, true, false, 1));
  CHECK(specular.stats.pictures_decoded == 1);
  CHECK(specular.tiles[0].counts.alpha_full == 40 * 30);
  CHECK(specular.tiles[0].detail.b[0][90] == specular.tiles[0].detail.opaque);
  const PassResult diffuse =
      passed_whole({rows_of(codes), nullptr, nullptr}, tiles, first_plan({}, {}, true, false, false, 1));
  CHECK(diffuse.tiles[0].counts.black == 40 * 30);
  CHECK(diffuse.tiles[0].detail.a[3][90] == diffuse.tiles[0].detail.opaque);
}

TEST_CASE("values of floats that no code holds are counted, and the first place of each kind is told") {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  Pixels<float> floats(20, 10, 4, 0.25f);
  floats.at(3, 1)[0] = nan;
  floats.at(4, 1)[1] = inf;
  floats.at(7, 2)[2] = -0.5f;
  floats.at(1, 5)[0] = -2;
  floats.at(9, 6)[1] = 1.5f;
  floats.at(2, 8)[1] = 3;
  floats.at(5, 9)[0] = 1.0004f;  // what rounding to half floats makes of 1
  const std::vector<CheckTile> tiles{named_tile("", {0, 0, 20, 10})};
  const PassResult result = passed_whole({nullptr, std::make_unique<FloatRows>(floats), nullptr}, tiles,
                                         first_plan({}, {}, false, true, false, 1));
  CHECK(!result.a_floats);
  REQUIRE(result.b_floats);
  const FloatFacts& facts = *result.b_floats;
  CHECK(facts.nan == 1);
  CHECK(facts.infinite == 1);
  CHECK(facts.nan_at == std::array{3, 1});
  CHECK(facts.negative == 2);
  CHECK(facts.negative_at == std::array{7, 2});
  CHECK(facts.most_negative == -2);
  CHECK(facts.above_one == 2);
  CHECK(facts.above_at == std::array{2, 8});
  CHECK(facts.largest == 3);
  CHECK(facts.above_value == std::array{0.25f, 3.0f, 0.25f});
  // The codes are those of the values brought into 0..1: encoded for colours, as they are for gloss.
  const Detail& detail = result.tiles[0].detail;
  CHECK(detail.b[3][64] == 200);
  CHECK(detail.b[0][137] == 197);
  CHECK(detail.b[0][0] == 2);
  CHECK(detail.b[1][255] == 3);
}
