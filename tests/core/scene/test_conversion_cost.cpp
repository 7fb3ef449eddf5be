// SPDX-License-Identifier: Apache-2.0
#include "core/scene/conversion_cost.h"

#include <catch2/catch.hpp>
#include <cmath>

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

  ConversionCost cost(const std::vector<std::uint8_t>& used = {}, const VertexColors& colors = {}) const {
    const SceneImages<std::uint8_t> images = [this](int image) -> const Image8& {
      return image == 0 ? color : metal_rough;
    };
    std::size_t clamped = 0;
    const MaterialPair pair = scene_material_pair(m, images, GlossForm::one_minus_roughness, false, clamped);
    return conversion_cost(m, images, pair, GlossForm::one_minus_roughness,
                           used.empty() ? nullptr : used.data(), colors);
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

TEST_CASE(
    "what is lost across the seam of a texture that repeats is told, and not where it clamps or mirrors") {
  Subject subject(4, 4);
  for (int x = 0; x < 4; ++x) subject.paint(x, x == 0 ? 40 : x == 3 ? 230 : 130, 100, x < 3 ? 0 : 255);
  // Clamped: metal meets the colour of column 2 alone.
  const double clamped = subject.cost().between;
  const auto wrapped = [&](Wrap wrap) {
    for (GltfTexture* texture : {&*subject.m.base_color_texture, &*subject.m.metallic_roughness_texture})
      texture->sampler.wrap_u = wrap;
    return subject.cost().between;
  };
  CHECK(wrapped(Wrap::mirrored) == clamped);
  const double dark = srgb_decode(40 / 255.0), bright = srgb_decode(230 / 255.0);
  const double diffuse = (dark + bright) / 2 * 0.5, f0 = 0.02 + (dark + bright) / 2 * 0.5;
  CHECK(wrapped(Wrap::repeat) == Approx(std::max(std::abs(code_of(diffuse) - code_of(dark / 2)),
                                                 std::abs(code_of(f0) - code_of((0.04 + bright) / 2))))
                                     .margin(0.5));
  CHECK(wrapped(Wrap::repeat) > clamped + 5);
}

TEST_CASE("what is lost amid four texels is told where no two neighbours lose anything") {
  Subject subject(2, 2);
  // Colours bright but for the lower right, which alone is metal's neighbour at the corner.
  const auto set = [&](int x, int y, std::uint8_t base, std::uint8_t metal) {
    std::ranges::fill(subject.color.at(x, y), base);
    subject.metal_rough.at(x, y)[1] = 100, subject.metal_rough.at(x, y)[2] = metal;
  };
  set(0, 0, 20, 0), set(1, 0, 230, 0), set(0, 1, 230, 0), set(1, 1, 230, 255);
  const double dark = srgb_decode(20 / 255.0), bright = srgb_decode(230 / 255.0);
  // Of the four a quarter is metal. The shader has the mean colour, the pair the mean of each surface.
  const double color = (dark + 3 * bright) / 4;
  const double of_diffuse = std::abs(code_of(color * 0.75) - code_of((dark + 2 * bright) / 4)),
               of_f0 = std::abs(code_of(0.03 + color / 4) - code_of(0.03 + bright / 4));
  CHECK(subject.cost().between == Approx(std::max(of_diffuse, of_f0)).margin(0.5));
}

TEST_CASE("F0 of metal that vertex colours would multiply is told by the darkest of them") {
  Subject subject(4, 4);
  for (int x = 0; x < 4; ++x) subject.paint(x, 200, 100, 255);
  const double base = srgb_decode(200 / 255.0);
  const VertexColors colors{{1, 0.25, 1}, {1, 1, 1}};
  CHECK(subject.cost({}, colors).tinted == Approx(code_of(base) - code_of(base / 4)).margin(0.01));
  CHECK(!subject.cost({}, colors).is_exact());
  CHECK(subject.cost().tinted == 0);
  for (int x = 0; x < 4; ++x) subject.paint(x, 200, 100, 0);
  CHECK(subject.cost({}, colors).tinted == 0);
}

TEST_CASE("a texture that darkens F0 of the dielectric hides nothing of the metal under vertex colours") {
  Subject subject(4, 4);
  for (int x = 0; x < 4; ++x) subject.paint(x, 60, 100, 255);
  subject.m.metallic = 0.5;
  subject.m.ior = 1.8;
  subject.m.specular_color_texture = subject.m.base_color_texture;
  const double base = srgb_decode(60 / 255.0), rest = base * std::pow(0.8 / 2.8, 2) / 2;
  CHECK(subject.cost({}, {{0.25, 0.25, 0.25}, {1, 1, 1}}).tinted ==
        Approx(code_of(rest + base / 2) - code_of(rest + base / 8)).margin(0.7));
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

TEST_CASE("textures of two sizes: what only places beyond a clamped edge read counts as well") {
  Subject subject(8, 4);
  for (int x = 0; x < 8; ++x) subject.paint(x, 180, x % 2 == 0 ? 50 : 150, 0);
  subject.color = Image8(8, 8, 3, 180);
  // The last row of eight is read alone; the centres of the smaller texture's rows lie amid other rows.
  std::vector<std::uint8_t> used(64, 0);
  std::fill(used.end() - 8, used.end(), std::uint8_t{1});
  CHECK(subject.cost(used).resized == Approx(25).margin(1));
}

TEST_CASE(
    "light behind F0 near white that codes of F0 no longer hold is told, and not where F0 is the texture's own") {
  GltfMaterial m;
  m.specular_glossiness = true;
  m.diffuse_texture = GltfTexture{0, {}, 0, {}};
  m.specular_glossiness_texture = GltfTexture{1, {}, 0, {}};
  const Image8 diffuse(4, 4, 4, 232), specular(4, 4, 4, 254);
  const auto cost_of = [&](double factor) {
    m.specular_f0 = {factor, factor, factor};
    const SceneImages<std::uint8_t> images = [&](int image) -> const Image8& {
      return image == 0 ? diffuse : specular;
    };
    std::size_t clamped = 0;
    const MaterialPair pair = scene_material_pair(m, images, GlossForm::one_minus_roughness, false, clamped);
    return conversion_cost(m, images, pair, GlossForm::one_minus_roughness, nullptr);
  };
  CHECK(cost_of(1).is_exact());
  // 0.969 of code 254 is code 250.5, which 251 or 250 stand for.
  const double light = srgb_decode(232 / 255.0), f0 = 0.969 * srgb_decode(254 / 255.0),
               stored = srgb_decode(std::round(255 * srgb_encode(f0)) / 255);
  const ConversionCost cost = cost_of(0.969);
  CHECK(cost.behind ==
        Approx(std::abs(code_of(light * (1 - f0)) - code_of(light * (1 - stored)))).margin(1e-4));
  CHECK(cost.behind > 2);
  CHECK(contains(sentence_of(cost).value_or(""), "behind F0 near white"));
  CHECK(cost_of(0.5).is_exact());
}
