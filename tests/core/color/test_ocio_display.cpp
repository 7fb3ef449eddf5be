// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <catch2/catch.hpp>

#include "core/color/ocio.h"
#include "core/color/srgb.h"
#include "tests/support.h"

namespace etak {

TEST_CASE("etak's own sRGB display shows linear sRGB through the piecewise curve") {
  const OcioDisplay display = OcioConfig::open("").display("sRGB - Display", "Colorimetric");
  for (const double value : {0.0, 0.001, 0.04, 0.18, 0.5, 1.0}) {
    std::array<float, 3> rgb{static_cast<float>(value), static_cast<float>(value / 2), 0.25f};
    display.apply(rgb.data(), 1);
    CHECK(rgb[0] == Approx(srgb_encode(value)).margin(1e-5));
    CHECK(rgb[1] == Approx(srgb_encode(value / 2)).margin(1e-5));
    CHECK(rgb[2] == Approx(srgb_encode(0.25)).margin(1e-5));
  }
}

TEST_CASE("display and view default to the config's first, several pixels go through at once") {
  const OcioDisplay display = OcioConfig::open("").display("", "");
  CHECK(display.display() == "sRGB - Display");
  CHECK(display.view() == "Colorimetric");
  std::array<float, 6> rgb{0.5f, 0.5f, 0.5f, 1, 1, 1};
  display.apply(rgb.data(), 2);
  CHECK(rgb[0] == Approx(srgb_encode(0.5)).margin(1e-5));
  CHECK(rgb[5] == Approx(1).margin(1e-5));
}

TEST_CASE("an unknown display or view is refused with the list of those there are") {
  const std::string display = test::error_of([] { (void)OcioConfig::open("").display("Plasma", ""); });
  CHECK(test::contains(display, "Plasma"));
  CHECK(test::contains(display, "Display P3 - Display"));
  const std::string view =
      test::error_of([] { (void)OcioConfig::open("").display("sRGB - Display", "Filmic"); });
  CHECK(test::contains(view, "Filmic"));
  CHECK(test::contains(view, "Colorimetric"));
  CHECK(test::contains(test::error_of([] { (void)OcioConfig::open("/no/such.ocio").display("", ""); }),
                       "/no/such.ocio"));
}

}  // namespace etak
