// SPDX-License-Identifier: Apache-2.0
#include "core/study/sphere_looks.h"

#include <catch2/catch.hpp>

#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/material/library.h"

using namespace etak;

namespace {

constexpr int picture_side = 24;

FresnelTruth truth_of(const char* id) {
  const auto material = MaterialLibrary::builtin().find(id);
  return fresnel_truth(std::get<OpticalConstants>(material->preferred_dataset().optics), id);
}

// The same light from all sides.
Environment even(float radiance) {
  return Environment(Image(64, 32, 3, radiance), 1, "even", 1);
}

std::vector<SphereLook> looks_of(const char* id, const Environment& around) {
  const FresnelForm* const forms[] = {fresnel_form("schlick"), fresnel_form("f82_tint")};
  return sphere_looks(truth_of(id), forms, around, {0.5, 1, picture_side});
}

}  // namespace

TEST_CASE("a sphere under even light shows F0 in its middle and is cut out of its square") {
  const auto looks = looks_of("copper", even(0.5f));
  REQUIRE(looks.size() == 3);
  const FresnelTruth truth = truth_of("copper");
  for (const SphereLook& look : looks) {
    const auto middle = look.picture.at(picture_side / 2, picture_side / 2);
    // Khronos PBR Neutral takes 0.04 from what is as bright as this.
    for (std::size_t c = 0; c < 3; ++c) CHECK(std::abs(middle[c] - srgb_u8(0.5 * truth.f0[c] - 0.04)) <= 1);
    CHECK(middle[3] == 255);
    CHECK(look.picture.at(0, 0)[3] == 0);
    CHECK(look.picture.at(picture_side / 2, 0)[3] > 0);
  }
}

TEST_CASE("the exact sphere differs from itself by nothing, F82 misses chromium by less than Schlick does") {
  const auto looks = looks_of("chromium", even(0.8f));
  CHECK(looks[0].mean_de == 0);
  CHECK(looks[0].worst_de == 0);
  CHECK(looks[1].mean_de > 2 * looks[2].mean_de);
  for (const SphereLook& look : looks) CHECK(look.worst_de >= look.mean_de);
}

TEST_CASE("a clear ball shows what is behind it, an opaque one does not") {
  const Vec3 clear{1, 1, 1}, tinted{1, 1, 0.25};
  const FresnelForm* const forms[] = {fresnel_form("schlick"), fresnel_form("from_f0")};
  for (const char* id : {"fused_silica", "water", "sapphire", "diamond"}) {
    INFO(id);
    const auto look = [&](const std::optional<Vec3>& passing) {
      return sphere_looks(truth_of(id), forms, even(0.5f), {1, 1, picture_side, passing});
    };
    const auto middle = [](const SphereLook& each) {
      return each.picture.at(picture_side / 2, picture_side / 2);
    };
    const auto black = look({}), shown = look(clear), yellow = look(tinted);
    const double f0 = truth_of(id).f0[1];
    // Khronos PBR Neutral takes 0.04 from what is bright.
    CHECK(std::abs(middle(shown[0])[1] - srgb_u8(0.5 * (f0 + (1 - f0) * (1 - f0)) - 0.04)) <= 1);
    CHECK(middle(black[0])[1] < 100);
    CHECK(middle(yellow[0])[0] > middle(yellow[0])[2] + 40);
    // The exact form from F0 is all it needs; Schlick's is seen.
    CHECK(shown[2].worst_de < 0.5);
    CHECK(shown[1].worst_de > 2 * shown[2].worst_de);
  }
}

TEST_CASE("light that is too bright for a display keeps the hue of its material") {
  // sRGB alone clips red and green of gold's highlights to yellow.
  const auto looks = looks_of("gold", even(2));
  const auto gold = looks[0].picture.at(picture_side / 2, picture_side / 2);
  CHECK(gold[0] > gold[1] + 5);
  CHECK(gold[1] > gold[2] + 10);
}

TEST_CASE("where no light is, all spheres are black and equal") {
  for (const SphereLook& look : looks_of("gold", even(0))) {
    CHECK(look.worst_de == 0);
    CHECK(look.picture.at(picture_side / 2, picture_side / 2)[0] == 0);
  }
}
