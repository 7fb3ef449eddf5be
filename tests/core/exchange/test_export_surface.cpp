// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/exchange/export_surface.h"
#include "core/material/library.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

ExportSurface surface_of_library(const char* id, F0Options options = {}, LinearRgb diffuse = {}) {
  const Material material = *MaterialLibrary::builtin().find(id);
  const Dataset& dataset = material.preferred_dataset();
  return export_surface(material, dataset, options, F0Solver(options).solve(dataset.optics), diffuse, 0.75);
}

constexpr LinearRgb gold{1.0428, 0.7738, 0.3347};

}  // namespace

TEST_CASE("Schueler's gloss covers perceptual roughness 0.904 to 0.149") {
  const std::pair<double, double> printed[] = {
      {0, 0.904}, {0.25, 0.669}, {0.5, 0.417}, {0.75, 0.250}, {1, 0.149}};
  for (const auto& [gloss, roughness] : printed) {
    CHECK(roughness_of_gloss(gloss) == Approx(roughness).margin(0.0005));
    // e = 2 / alpha^2 - 2 is 2^(12 g).
    const double alpha = std::pow(roughness_of_gloss(gloss), 2);
    CHECK(std::log2(2 / (alpha * alpha) - 2) == Approx(12 * gloss).margin(1e-9));
    CHECK(alpha == Approx(alpha_of_gloss(gloss)).epsilon(1e-14));
  }
  // One 8-bit step is 3.3 % of the exponent.
  CHECK(std::exp2(12.0 / 255) == Approx(1.033).margin(0.0005));
}

TEST_CASE("the index of a dielectric and its F0 go back and forth") {
  for (const double n : {1.0, 1.333, 1.5, 2.417, 4.0}) {
    const double f0 = std::pow((n - 1) / (n + 1), 2);
    CHECK(ior_of_f0(f0) == Approx(n).epsilon(1e-13));
  }
}

TEST_CASE("clamp changes gold's red alone and tells it") {
  Changes changes;
  const LinearRgb out = fitted(gold, {Fit::clamp, 1, RgbSpace::srgb}, "Base Color", "ends at 1", changes);
  CHECK(out == LinearRgb{1, gold.g, gold.b});
  REQUIRE(changes.size() == 1);
  CHECK(changes[0].field == "Base Color");
  CHECK(changes[0].action == "clamp");
  CHECK(changes[0].amount() == Approx(0.0428));
  CHECK(one_line(changes[0]) ==
        "Base Color 1.043 0.7738 0.3347 -> 1 0.7738 0.3347 (clamp, 0.0428): ends at 1");
}

TEST_CASE("preserve-hue keeps the ratios of gold's channels") {
  Changes changes;
  const LinearRgb out = fitted(gold, {Fit::preserve_hue, 1, RgbSpace::srgb}, "x", "y", changes);
  CHECK(out.r == 1);
  CHECK(out.g / out.r == Approx(gold.g / gold.r).epsilon(1e-14));
  CHECK(out.b / out.r == Approx(gold.b / gold.r).epsilon(1e-14));
  REQUIRE(changes.size() == 1);
  CHECK(changes[0].action == "preserve-hue");
}

TEST_CASE("preserve-hue takes a negative channel to 0 and keeps the luminance") {
  Changes changes;
  const LinearRgb in{0.5, 0.3, -0.05};
  const LinearRgb out = fitted(in, {Fit::preserve_hue, 1, RgbSpace::srgb}, "x", "y", changes);
  CHECK(out.b == Approx(0).margin(1e-15));
  CHECK(luminance(out, RgbSpace::srgb) == Approx(luminance(in, RgbSpace::srgb)).epsilon(1e-12));
  // On the line between the colour and its grey: the order of the channels and the hue stay.
  CHECK((out.r - out.g) / (out.g - out.b) == Approx((in.r - in.g) / (in.g - in.b)).epsilon(1e-12));
}

TEST_CASE("a colour in range is not touched and not told") {
  for (const Fit fit : {Fit::clamp, Fit::preserve_hue}) {
    Changes changes;
    CHECK(fitted({0, 0.5, 1}, {fit, 1, RgbSpace::srgb}, "x", "y", changes) == LinearRgb{0, 0.5, 1});
    CHECK(changes.empty());
  }
}

TEST_CASE("the luminance of sRGB is Rec. 709's") {
  CHECK(luminance({1, 0, 0}, RgbSpace::srgb) == Approx(0.2126).margin(5e-5));
  CHECK(luminance({0, 1, 0}, RgbSpace::srgb) == Approx(0.7152).margin(5e-5));
  CHECK(luminance({0, 0, 1}, RgbSpace::srgb) == Approx(0.0722).margin(5e-5));
  CHECK(luminance({1, 1, 1}, RgbSpace::acescg) == Approx(1).epsilon(1e-12));
}

TEST_CASE("the tint of F82 is R82 over Schlick at cos 1/7") {
  const ExportSurface chromium = surface_of_library("chromium");
  REQUIRE(chromium.f82);
  const LinearRgb tint = tint82(chromium, chromium.f0);
  const double schlick = chromium.f0.r + (1 - chromium.f0.r) * std::pow(6.0 / 7, 5);
  CHECK(tint.r == Approx(chromium.f82->r / schlick).epsilon(1e-12));
  // K = 17.6513846 is the height of mu (1 - mu)^6 at mu = 1/7.
  CHECK(1 / (std::pow(6.0 / 7, 6) / 7) == Approx(17.6513846).margin(5e-8));
}

TEST_CASE("conductors are metals, semiconductors too, surfaces are bodies over an F0 of at most 0.04") {
  CHECK(surface_of_library("gold").kind == SurfaceKind::metal);
  CHECK(surface_of_library("silicon").kind == SurfaceKind::metal);
  const ExportSurface glass = surface_of_library("fused_silica", {}, {0.1, 0.2, 0.3});
  CHECK(glass.kind == SurfaceKind::dielectric);
  CHECK(glass.diffuse == LinearRgb{0.1, 0.2, 0.3});
  CHECK(surface_of_library("gold", {}, {0.1, 0.2, 0.3}).diffuse == LinearRgb{});
  const MaterialLibrary library = MaterialLibrary::builtin();
  for (std::size_t i = 0; i < library.ids().size(); ++i) {
    if (library.at(i).material_class != "surface") continue;
    const ExportSurface body = surface_of_library(library.ids()[i].c_str());
    CHECK(body.kind == SurfaceKind::dielectric);
    REQUIRE(body.total);
    const double f0 = std::min(0.04, (body.total->r + body.total->g + body.total->b) / 3);
    for (const double channel : vec(body.f0)) CHECK(channel == Approx(f0).epsilon(1e-12));
    CHECK(!body.notes.empty());
  }
}

TEST_CASE("gold fits into ACEScg where it does not into sRGB") {
  F0Options options;
  CHECK(surface_of_library("gold", options).f0.r > 1);
  options.space = RgbSpace::acescg;
  CHECK(surface_of_library("gold", options).f0.r < 1);
}

TEST_CASE("a bad gloss, opacity or colour is refused") {
  ExportSurface s;
  s.id = "mine";
  CHECK(error_of([&] { validate(s); }).empty());
  s.gloss = 1.5;
  CHECK(contains(error_of([&] { validate(s); }), "mine: gloss 1.5"));
  s.gloss = 0.5;
  s.diffuse.g = std::nan("");
  CHECK(contains(error_of([&] { validate(s); }), "diffuse"));
  s.diffuse.g = 0;
  s.f0.r = INFINITY;
  CHECK(contains(error_of([&] { validate(s); }), "F0"));
}
