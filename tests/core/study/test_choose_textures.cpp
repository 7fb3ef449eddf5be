// SPDX-License-Identifier: Apache-2.0
// Choices for materials of scenes, whose texels differ.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <functional>
#include <memory>
#include <utility>

#include "core/color/delta_e.h"
#include "core/pages/choose_report.h"
#include "core/study/choose/choose.h"
#include "core/study/choose/choose_pictures.h"
#include "tests/core/study/choose_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

// A scene's material: codes of a texture pair, sRGB F0 and gloss from `texel`.
ChooseSubject textured_subject(int side, const std::function<std::array<std::uint8_t, 4>(int, int)>& texel) {
  Image8 diffuse(side, side, 4), specular(side, side, 4);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const auto codes = texel(x, y);
      std::copy(codes.begin(), codes.end(), specular.at(x, y).begin());
      diffuse.at(x, y)[3] = 255;
    }
  ChooseSubject out;
  out.name = "wall";
  out.texture =
      std::make_shared<const TexelChain>(view(std::as_const(diffuse)), view(std::as_const(specular)),
                                         PixelBox{0, 0, side, side}, GlossForm::schueler);
  return out;
}

}  // namespace

TEST_CASE("an even texture needs no filter, a faint one no mips or none at all, a checkerboard all of them") {
  const auto even = chosen(textured_subject(32, [](int, int) {
    return std::array<std::uint8_t, 4>{60, 60, 60, 150};
  }));
  CHECK(!even.textured);
  CHECK(even.filter == TextureFilter::constant);
  CHECK(even.fresnel->id == "from_f0");

  const auto faint = chosen(textured_subject(32, [](int x, int) {
    return std::array<std::uint8_t, 4>{60, 60, static_cast<std::uint8_t>(60 + x % 2), 150};
  }));
  CHECK(faint.textured);
  CHECK(faint.filter == TextureFilter::constant);
  CHECK(faint.picture_error <= 1);

  const auto checks = chosen(textured_subject(32, [](int x, int y) {
    return std::array<std::uint8_t, 4>{60, 60, 60, static_cast<std::uint8_t>((x + y) % 2 == 0 ? 40 : 220)};
  }));
  CHECK(checks.filter == TextureFilter::trilinear);
  CHECK(checks.picture_error <= 1);
  CHECK(checks.filter_candidates.size() == all_filters.size());
}

TEST_CASE("the budget holds in every pixel of a texture that runs from dark to light F0") {
  const ChooseSubject ramp = textured_subject(64, [](int x, int y) {
    const auto code = static_cast<std::uint8_t>(30 + x);
    return std::array<std::uint8_t, 4>{code, code, code, static_cast<std::uint8_t>(100 + y)};
  });
  for (const double budget : {0.7, 2.0}) {
    const Choice choice = chosen(ramp, budget);
    CHECK(choice.met);
    // Drawn again, without the code that chose.
    const ChoosePictures pictures(ramp);
    Look look{choice.fresnel, choice.values, choice.visibility, choice.filter};
    const auto everything = pictures.draw({}), drawn = pictures.draw(look);
    REQUIRE(everything.size() == choice.pixels);
    double most = 0, worst = 0;
    for (const Vec3& pixel : everything) most = std::max({most, pixel[0], pixel[1], pixel[2]});
    for (std::size_t i = 0; i < everything.size(); ++i) {
      Vec3 a = everything[i], b = drawn[i];
      for (std::size_t c = 0; c < 3; ++c) a[c] /= most, b[c] /= most;
      worst = std::max(worst, delta_e2000(to_lab(to_rgb(a)), to_lab(to_rgb(b))));
    }
    CHECK(worst <= budget);
    CHECK(worst == Approx(choice.picture_error));
  }
}

TEST_CASE("metals and dielectrics in one texture need a form that tells them apart") {
  const Choice choice = chosen(
      textured_subject(
          16,
          [](int x, int) {
            return std::array<std::uint8_t, 4>{static_cast<std::uint8_t>(x < 8 ? 56 : 240), 200, 100, 150};
          }),
      0.1);
  CHECK(choice.met);
  CHECK(choice.fresnel->id == "by_f0");
  CHECK(choice.model.find("by-f0") != std::string::npos);
}

TEST_CASE("a scene's material saves the texture that is one colour, or says why it saves nothing") {
  // Gloss and F0 alike everywhere, and the diffuse colour is black: only the second texture is read.
  const auto checks = chosen(textured_subject(32, [](int x, int y) {
    return std::array<std::uint8_t, 4>{60, 60, 60, static_cast<std::uint8_t>((x + y) % 2 == 0 ? 40 : 220)};
  }));
  CHECK(checks.textures == 1);
  CHECK(checks.chosen_ns < 0.6 * checks.everything_ns);
  CHECK(contains(saving_remark(checks), "wall: one texture is read, the other is one colour"));

  const auto even = chosen(textured_subject(32, [](int, int) {
    return std::array<std::uint8_t, 4>{60, 60, 60, 150};
  }));
  CHECK(even.textures == 0);
  CHECK(even.chosen_ns == even.everything_ns);
  CHECK(contains(saving_remark(even), "nothing is saved within 1 ΔE2000: from_f0 is needed"));
  CHECK(contains(choice_text({even}, shipped_costs()), "savings:\n  wall: nothing is saved"));
  CHECK(saving_remark(chosen("gold")).empty());
}
