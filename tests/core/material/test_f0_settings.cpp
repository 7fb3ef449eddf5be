// SPDX-License-Identifier: Apache-2.0
#include "core/material/f0/f0_settings.h"

#include <catch2/catch.hpp>

#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

// What was asked of the door to OpenColorIO, and how often the library was opened.
struct Asked {
  std::vector<std::string> spaces;
  int libraries = 0;

  F0Options options(const F0Settings& settings) {
    static const MaterialLibrary library = MaterialLibrary::builtin();
    return f0_options(
        settings,
        [this]() -> const MaterialLibrary& {
          ++libraries;
          return library;
        },
        [this](const std::string& config, const std::string& name) {
          spaces.push_back(config + "|" + name);
          return CustomSpace{name, {}};
        });
  }
  std::string problem(const F0Settings& settings) {
    return error_of([&] { (void)options(settings); });
  }
};

}  // namespace

TEST_CASE("settings of F0 that are not given are the reference policy, and open neither library nor config") {
  Asked asked;
  const F0Options out = asked.options({});
  CHECK(policy(out) == policy({}));
  CHECK(asked.libraries == 0);
  CHECK(asked.spaces.empty());
}

TEST_CASE("settings of F0 become the values that they name") {
  Asked asked;
  F0Settings settings;
  settings.observer = "1964-10deg";
  settings.illuminant = "A";
  settings.interpolation = "pchip";
  settings.method = "auto";
  settings.integration_bound = "1e-4";
  settings.outside = "water";
  settings.allow_extrapolation = true;
  const F0Options out = asked.options(settings);
  CHECK(out.viewing.observer == Observer::cie1964_10deg);
  CHECK(out.viewing.illuminant == Illuminant::a);
  CHECK(out.interpolation == Interpolation::pchip);
  CHECK(out.method == Method::automatic);
  CHECK(out.integration_bound == 1e-4);
  CHECK(out.outside.label == "water");
  CHECK(out.allow_extrapolation);
  CHECK(asked.libraries == 1);
}

TEST_CASE("a space that etak has needs no config, unless a config is named beside it") {
  Asked asked;
  F0Settings settings;
  settings.space = "acescg";
  CHECK(asked.options(settings).space == RgbSpace::acescg);
  CHECK(asked.spaces.empty());
  settings.ocio = "my.ocio";
  CHECK(asked.options(settings).custom_space.value().name == "acescg");
  settings.ocio.clear();
  settings.space = "Film Log";
  CHECK(asked.options(settings).custom_space.value().name == "Film Log");
  CHECK(asked.spaces == std::vector<std::string>{"my.ocio|acescg", "|Film Log"});
}

TEST_CASE("settings of F0 that do not fit are refused by their names") {
  Asked asked;
  F0Settings settings;
  settings.illuminant = "D66";
  CHECK(asked.problem(settings) == "illuminant: D66; expected D65, D50, A or E");
  settings = {};
  settings.ocio = "my.ocio";
  CHECK(asked.problem(settings) == "ocio: no colour space of it is named; expected space NAME beside it");
  settings = {};
  settings.integration_bound = "1e-4";
  CHECK(asked.problem(settings) == "integration bound: nothing is refined; expected method auto beside it");
  settings.method = "auto";
  settings.integration_bound = "-1";
  CHECK(asked.problem(settings) == "integration bound: -1; expected a number above 0, such as 1e-5");
  settings = {};
  settings.outside = "soup";
  CHECK(asked.problem(settings).starts_with("soup: no material has this name"));
}
