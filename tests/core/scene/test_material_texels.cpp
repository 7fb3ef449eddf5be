// SPDX-License-Identifier: Apache-2.0
#include "core/scene/material_texels.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "core/color/srgb.h"

using namespace etak;

TEST_CASE("F0 of an index of refraction, by hand") {
  CHECK(dielectric_f0(1.5, 1, {1, 1, 1})[0] == Approx(0.04));
  CHECK(srgb_u8(dielectric_f0(1.5, 1, {1, 1, 1})[0]) == 56);
  CHECK(srgb_u8(dielectric_f0(1.477, 1, {1, 1, 1})[0]) == 54);
  CHECK(dielectric_f0(0, 1, {0.2, 0.5, 1})[1] == Approx(0.5));    // scale 1: the colour is F0
  CHECK(dielectric_f0(1.5, 0.5, {100, 1, 0})[0] == Approx(0.5));  // clamped before the strength
  CHECK(dielectric_f0(1.5, 0.5, {100, 1, 0})[1] == Approx(0.02));
}

TEST_CASE("metal-rough to diffuse and specular, by hand") {
  const DiffuseSpecular half = diffuse_specular({0.8, 0.4, 0.2}, 0.25, {0.04, 0.04, 0.04});
  CHECK(half.diffuse[0] == Approx(0.6));
  CHECK(half.f0[0] == Approx(0.04 * 0.75 + 0.2));
  const DiffuseSpecular metal = diffuse_specular({0.8, 0.4, 0.2}, 1, {0.04, 0.04, 0.04});
  CHECK(metal.diffuse[0] == 0);
  CHECK(metal.f0 == Vec3{0.8, 0.4, 0.2});
}

TEST_CASE("solving for metal-rough undoes the conversion of any base above black") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 2000; ++i) {
    // A base darker than a dielectric's F0 has two solutions.
    const Vec3 base{0.05 + 0.95 * share(random), 0.05 + 0.95 * share(random), 0.05 + 0.95 * share(random)};
    const double metallic = i % 5 == 0 ? i % 2 : share(random);
    const MetalRough found = metal_rough_of(diffuse_specular(base, metallic, {0.04, 0.04, 0.04}));
    CHECK(found.error < 1e-9);
    CHECK(found.metallic == Approx(metallic).margin(1e-7));
    for (std::size_t c = 0; c < 3; ++c) CHECK(found.base[c] == Approx(base[c]).margin(1e-6));
  }
  // A gem (F0 0.17 and a full diffuse colour) has no metal-rough form, and the error says so.
  CHECK(metal_rough_of({{0.5, 0.1, 0.1}, {0.17, 0.17, 0.17}}).error > 0.01);
  CHECK(metal_rough_of({{0, 0, 0}, {0, 0, 0}}).error == Approx(0.04));
}

TEST_CASE("diffuse conventions differ by 1 - max F0, and convert back") {
  const DiffuseSpecular texel{{0.5, 0.25, 0}, {0.04, 0.2, 0.1}};
  const auto final_color =
      converted(texel, DiffuseConvention::reduced_when_shading, DiffuseConvention::as_it_is);
  CHECK(final_color.diffuse[0] == Approx(0.5 * 0.8));
  CHECK(final_color.f0 == texel.f0);
  const auto back =
      converted(final_color, DiffuseConvention::as_it_is, DiffuseConvention::reduced_when_shading);
  CHECK(back.diffuse[1] == Approx(0.25));
}

TEST_CASE("roughness codes are those of the gloss's form") {
  const auto of_schueler = roughness_codes(GlossForm::schueler);
  for (std::size_t i = 0; i < 256; ++i) {
    const double gloss = static_cast<double>(i) / 255;
    CHECK(roughness_codes(GlossForm::one_minus_roughness)[i] == 255 - i);
    CHECK(roughness_codes(GlossForm::roughness)[i] == i);
    CHECK(of_schueler[i] == std::lround(255 * std::pow(2 / (std::exp2(12 * gloss) + 2), 0.25)));
  }
}

TEST_CASE("converted codes are those of the formulas in double, but for ties of single precision") {
  std::mt19937 random(3);
  const Vec3 factor{1, 0.7, 0.3};
  const Vec3 dielectric = dielectric_f0(1.5, 1, {1, 0.5, 2});
  const MetalRoughCodes codes(factor, 0.9, dielectric);
  int differ = 0;
  for (int i = 0; i < 50000; ++i) {
    const std::array<std::uint8_t, 3> base{static_cast<std::uint8_t>(random()),
                                           static_cast<std::uint8_t>(random()),
                                           static_cast<std::uint8_t>(random())};
    const auto metallic = static_cast<std::uint8_t>(random());
    std::array<std::uint8_t, 3> diffuse{}, f0{};
    codes.convert(base.data(), metallic, diffuse.data(), f0.data());
    Vec3 linear;
    for (std::size_t c = 0; c < 3; ++c) linear[c] = factor[c] * srgb_decode(base[c] / 255.0);
    const DiffuseSpecular exact = diffuse_specular(linear, 0.9 * metallic / 255.0, dielectric);
    for (std::size_t c = 0; c < 3; ++c) {
      const int a = std::abs(diffuse[c] - srgb_u8(exact.diffuse[c])),
                b = std::abs(f0[c] - srgb_u8(exact.f0[c]));
      REQUIRE(std::max(a, b) <= 1);
      differ += a + b;
    }
  }
  CHECK(differ < 30);  // of 300,000

  // Without factors and metal nothing moves at all.
  const MetalRoughCodes plain({1, 1, 1}, 1, {0.04, 0.04, 0.04});
  for (unsigned code = 0; code < 256; ++code) {
    const auto c = static_cast<std::uint8_t>(code);
    const std::array<std::uint8_t, 3> base{c, c, c};
    std::array<std::uint8_t, 3> diffuse{}, f0{};
    plain.convert(base.data(), 0, diffuse.data(), f0.data());
    CHECK((diffuse == base && f0 == std::array<std::uint8_t, 3>{56, 56, 56}));
    plain.convert(base.data(), 255, diffuse.data(), f0.data());
    CHECK((f0 == base && diffuse == std::array<std::uint8_t, 3>{0, 0, 0}));
  }
}
