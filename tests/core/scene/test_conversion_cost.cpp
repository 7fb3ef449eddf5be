// SPDX-License-Identifier: Apache-2.0
#include "core/scene/conversion_cost.h"

#include <catch2/catch.hpp>

#include "core/color/srgb.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

// A material of two pictures, whose texels are given one by one.
struct Subject {
  GltfMaterial m;
  Image8 color, metal_rough;

  Subject(int color_width, int other_width) : color(color_width, 2, 3), metal_rough(other_width, 2, 3) {
    m.base_color_texture = GltfTexture{0, {}, 0, {}};
    m.metallic_roughness_texture = GltfTexture{1, {}, 0, {}};
    for (GltfTexture* texture : {&*m.base_color_texture, &*m.metallic_roughness_texture})
      texture->sampler.wrap_u = texture->sampler.wrap_v = Wrap::clamp;
  }

  void paint(int column, std::uint8_t base, std::uint8_t rough, std::uint8_t metal) {
    for (int y = 0; y < 2; ++y) {
      if (column < color.width) std::ranges::fill(color.at(column, y), base);
      if (column >= metal_rough.width) continue;
      metal_rough.at(column, y)[1] = rough;
      metal_rough.at(column, y)[2] = metal;
    }
  }

  ConversionCost cost(const std::vector<std::uint8_t>& used = {}) const {
    const SceneImages<std::uint8_t> images = [this](int image) -> const Image8& {
      return image == 0 ? color : metal_rough;
    };
    std::size_t clamped = 0;
    const MaterialPair pair = scene_material_pair(m, images, GlossForm::one_minus_roughness, false, clamped);
    return conversion_cost(m, images, pair, GlossForm::one_minus_roughness,
                           used.empty() ? nullptr : used.data());
  }
};

double code_of(double linear) {
  return 255 * srgb_encode(linear);
}

}  // namespace

TEST_CASE("a material of one metal and one dielectric of the same base colour loses nothing as a pair") {
  Subject subject(4, 4);
  for (int x = 0; x < 4; ++x) subject.paint(x, 180, 100, x < 2 ? 0 : 255);
  const ConversionCost cost = subject.cost();
  CHECK(cost.is_exact());
  CHECK(cost.between == 0);
  CHECK(sentence_of(cost) == std::nullopt);
}

TEST_CASE("what a pair loses where bright metal meets dark paint is told in codes") {
  Subject subject(4, 4);
  for (int x = 0; x < 4; ++x) subject.paint(x, x < 2 ? 40 : 230, 100, x < 2 ? 0 : 255);
  const ConversionCost cost = subject.cost();
  // Half way the shader has the mean of both colours, half of it metal; a pair has half of each surface.
  const double dark = srgb_decode(40 / 255.0), bright = srgb_decode(230 / 255.0);
  const double diffuse = (dark + bright) / 2 * 0.5, f0 = 0.02 + (dark + bright) / 2 * 0.5;
  const double of_diffuse = std::abs(code_of(diffuse) - code_of(dark / 2)),
               of_f0 = std::abs(code_of(f0) - code_of((0.04 + bright) / 2));
  CHECK(cost.between == Approx(std::max(of_diffuse, of_f0)).margin(0.5));
  CHECK(cost.partial < 1);
  REQUIRE(sentence_of(cost));
  CHECK(contains(*sentence_of(cost), "where metal meets what is less metal"));
  // Nothing is lost where nothing reads both sides.
  CHECK(subject.cost({1, 1, 0, 0, 1, 1, 0, 0}).is_exact());
}

TEST_CASE("the diffuse light of what is partly metal is told") {
  Subject subject(4, 4);
  for (int x = 0; x < 4; ++x) subject.paint(x, 200, 100, 128);
  const double base = srgb_decode(200 / 255.0), metal = 128 / 255.0;
  const double diffuse = base * (1 - metal), f0 = 0.04 * (1 - metal) + base * metal;
  CHECK(subject.cost().partial == Approx(code_of(diffuse * 0.96) - code_of(diffuse * (1 - f0))).margin(1));
  CHECK(subject.cost().between == 0);
}

TEST_CASE("textures of two sizes: what filtering the smaller one up changes at its own texels") {
  Subject subject(8, 4);
  for (int x = 0; x < 8; ++x) subject.paint(x, 180, x % 2 == 0 ? 50 : 150, 0);
  const ConversionCost cost = subject.cost();
  CHECK(cost.sizes == "8 x 2 and 4 x 2");
  // Filtered up to twice the width and read at the old centre, a texel has 3/4 of itself and 1/8 of either
  // neighbour, which differ from it by 100 codes; height is as it was.
  CHECK(cost.resized == Approx(25).margin(1));
  REQUIRE(sentence_of(cost));
  CHECK(contains(*sentence_of(cost), "its textures of 8 x 2 and 4 x 2"));
}
