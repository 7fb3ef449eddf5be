// SPDX-License-Identifier: Apache-2.0
#include "core/render/display.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/color/srgb.h"
#include "core/render/cpu_renderer.h"

namespace etak {

TEST_CASE("codes by table are the codes of the curve, around every boundary too") {
  Image picture(1, 1, 3);
  for (int i = 0; i <= 20000; ++i) {
    const float value = static_cast<float>(i) / 19000;
    picture.values = {value, std::nextafter(value, 2.0f), std::nextafter(value, -1.0f)};
    const Image8 codes = to_codes(picture, 1, Transfer::srgb);
    for (std::size_t c = 0; c < 3; ++c) REQUIRE(codes.values[c] == srgb_u8(double{picture.values[c]}));
  }
  for (int code = 1; code < 256; ++code) {
    const auto at = static_cast<float>(srgb_decode((code - 0.5) / 255));
    picture.values = {at, at * (1 - 1e-6f), at * (1 + 1e-6f)};
    const Image8 codes = to_codes(picture, 1, Transfer::srgb);
    for (std::size_t c = 0; c < 3; ++c) REQUIRE(codes.values[c] == srgb_u8(double{picture.values[c]}));
  }
}

TEST_CASE("every transfer has each of its 256 codes, in order, and changes by one code at a time") {
  for (const Transfer each : {Transfer::srgb, Transfer::power_045, Transfer::square_root, Transfer::linear}) {
    Image picture(1, 1, 3);
    int before = 0;
    // The steps are far smaller than a code, also near black, where the curves are steep.
    for (float value = 1e-8f; value < 1.1f; value *= 1.0005f) {
      picture.values = {value, value, value};
      const int code = to_codes(picture, 1, each).values[0];
      REQUIRE((code == before || code == before + 1));
      before = code;
    }
    CHECK(before == 255);
  }
}

TEST_CASE("Schueler's shortcuts are the powers they are named for, and exposure is a factor before them") {
  Image picture(1, 1, 3);
  picture.values = {0.25f, 0.04f, 1};
  CHECK(to_codes(picture, 1, Transfer::square_root).values == std::vector<std::uint8_t>{128, 51, 255});
  CHECK(to_codes(picture, 1, Transfer::linear).values == std::vector<std::uint8_t>{64, 10, 255});
  CHECK(to_codes(picture, 2, Transfer::linear).values[0] == 128);
  CHECK(int{to_codes(picture, 1, Transfer::power_045).values[1]} ==
        static_cast<int>(std::floor(255 * std::pow(0.04, 0.45) + 0.5)));
}

TEST_CASE("what no display shows becomes black or white") {
  Image picture(1, 1, 4);
  picture.values = {std::numeric_limits<float>::quiet_NaN(), -1, std::numeric_limits<float>::infinity(), 0};
  CHECK(to_codes(picture, 1, Transfer::srgb).values == std::vector<std::uint8_t>{0, 0, 255});
}

TEST_CASE("18 % grey has its stated code under every tone curve, and grey stays grey") {
  Image picture(1, 1, 3);
  picture.values = {0.18f, 0.18f, 0.18f};
  const auto codes = [&](Tone tone) { return to_codes(picture, 1, Transfer::srgb, tone).values; };
  CHECK(codes(Tone::plain) == std::vector<std::uint8_t>{118, 118, 118});
  CHECK(codes(Tone::neutral) == std::vector<std::uint8_t>{105, 105, 105});
  CHECK(codes(Tone::agx_like) == std::vector<std::uint8_t>{118, 118, 118});
  for (const Tone tone : {Tone::neutral, Tone::agx_like}) {
    int before = 0;
    for (float value = 1e-6f; value < 40; value *= 1.01f) {
      picture.values = {value, value, value};
      const auto seen = codes(tone);
      REQUIRE(seen[0] == seen[1]);
      REQUIRE(seen[0] == seen[2]);
      REQUIRE(int{seen[0]} >= before);
      before = seen[0];
    }
    CHECK(before >= 252);
  }
}

TEST_CASE("Khronos PBR Neutral is what its specification computes") {
  Image picture(1, 1, 4);
  const auto linear = [&](float r, float g, float b) {
    picture.values = {r, g, b, 1};
    return to_codes(picture, 1, Transfer::linear, Tone::neutral).values;
  };
  const auto code = [](double value) { return static_cast<std::uint8_t>(std::lround(255 * value)); };
  // Below 0.08 the square of the least channel is left of it: 6.25 x^2.
  CHECK(linear(0.06f, 0.06f, 0.06f)[0] == code(6.25 * 0.06 * 0.06));
  CHECK(linear(0.5f, 0.3f, 0.2f) == std::vector<std::uint8_t>{code(0.46), code(0.26), code(0.16)});
  CHECK(linear(1, 1, 1)[0] == code(1 - 0.24 * 0.24 / (0.96 - 0.52)));
  // Of (2, 0, 0): the peak becomes 0.961081, and 0.134827 of it is drawn to white.
  CHECK(linear(2, 0, 0) == std::vector<std::uint8_t>{code(0.961081), code(0.129580), code(0.129580)});
}

TEST_CASE(
    "the curve like AgX is sRGB's contrast at middle grey, white 6.5 stops above, and fades colours to white") {
  Image picture(1, 1, 4);
  const auto srgb = [&](double r, double g, double b) {
    picture.values = {float(r), float(g), float(b), 1};
    return to_codes(picture, 1, Transfer::srgb, Tone::agx_like).values;
  };
  const auto grey = [&](double stops) {
    return int{srgb(0.18 * std::exp2(stops), 0.18 * std::exp2(stops), 0.18 * std::exp2(stops))[0]};
  };
  // A stop about middle grey: 37 codes, of sRGB alone 38.
  CHECK(grey(0.5) - grey(-0.5) == Approx(37).margin(1));
  CHECK(grey(6.5) == 255);
  CHECK(grey(5) < 255);
  CHECK(grey(-10) == 0);
  CHECK(grey(-6) > 0);
  CHECK(srgb(50, 0, 0)[1] > 150);
  CHECK(srgb(0.3, 0.02, 0.02)[1] < 60);
  CHECK(srgb(-1, -1, -1)[0] == 0);
}

TEST_CASE("Filament's tone curve is what its source computes") {
  // By another program, in double: 255 times the linear values.
  struct Shown {
    std::array<float, 3> scene;
    std::array<double, 3> codes;
  };
  const Shown all[] = {{{0.18f, 0.18f, 0.18f}, {55.168, 55.617, 56.258}},
                       {{1, 1, 1}, {201.216, 193.55, 181.656}},
                       {{1, 0.766f, 0.336f}, {202.274, 178.249, 118.668}},
                       {{5, 1, 0.2f}, {255, 203.391, 120.987}},
                       {{0.02f, 0.01f, 0.9f}, {2.98, 1.149, 190.455}},
                       {{0.05f, 0.002f, 0.001f}, {7.315, 0.02, 0.138}},
                       {{0.3f, 0.28f, 0.05f}, {98.362, 91.463, 14.254}},
                       {{16, 16, 16}, {250.862, 238.43, 219.649}},
                       {{0, 0, 0}, {0, 0, 0}}};
  Image picture(1, 1, 4);
  for (const Shown& each : all) {
    picture.values = {each.scene[0], each.scene[1], each.scene[2], 1};
    const Vec3 shown = toned(picture.values.data(), 1, Tone::filament);
    for (std::size_t c = 0; c < 3; ++c) CHECK(255 * shown[c] == Approx(each.codes[c]).margin(2e-3));
  }
}

TEST_CASE("tone curves are found by their names") {
  for (const Tone each : {Tone::plain, Tone::neutral, Tone::agx_like, Tone::filament, Tone::false_color})
    CHECK(tone_named(name(each)) == each);
  CHECK_FALSE(tone_named("aces"));
}

TEST_CASE("transfers are found by their names") {
  for (const Transfer each : {Transfer::srgb, Transfer::power_045, Transfer::square_root, Transfer::linear})
    CHECK(transfer_named(name(each)) == each);
  CHECK_FALSE(transfer_named("gamma"));
}

TEST_CASE("a picture that was cut out, laid over any background, is the picture that is drawn over it") {
  Scene scene;
  scene.width = scene.height = 40;
  scene.lights = default_lights();
  scene.specular = find_model(default_specular);
  for (const double opacity : {1.0, 0.3}) {
    scene.surface.opacity = opacity;
    const FittedModels fitted = fit_models(scene.specular, nullptr, {}, scene.surface);
    scene.specular_values = fitted.specular_values;
    const auto drawn = [&](const Vec3& background) {
      scene.background = background;
      Image out;
      render_cpu(scene, nullptr, 1, Precision::f32, out);
      return out;
    };
    CHECK(is_seen_through(scene) == (opacity < 1));
    const Image cut = cut_out(drawn, is_seen_through(scene)), whole = drawn({0.2, 0.5, 0.7});
    double worst = 0;
    for (std::size_t i = 0; i < cut.values.size(); ++i)
      if (i % 4 != 3) {
        const double behind = std::array{0.2, 0.5, 0.7}[i % 4],
                     through = 1 - double{cut.values[i / 4 * 4 + 3]};
        worst = std::max(worst, std::abs(double{cut.values[i]} + through * behind - double{whole.values[i]}));
      }
    CHECK(worst < 1e-6);
    CHECK(cut.at(0, 0)[3] == 0);
    CHECK(cut.at(20, 20)[3] == (opacity < 1 ? Approx(0.3 + 0.7 * 0.05).margin(0.05) : Approx(1)));
    const Image straight = unmultiplied(cut);
    const Image8 codes = with_opacity(to_codes(straight, 1, Transfer::srgb), straight);
    CHECK(codes.channels == 4);
    CHECK(codes.at(0, 0)[3] == 0);
  }
}

}  // namespace etak
