// SPDX-License-Identifier: Apache-2.0
#include "core/base/setting.h"

#include <catch2/catch.hpp>

#include "tests/support.h"

using namespace etak;

namespace {

// The style of a program for the time of a test.
struct Style {
  explicit Style(SettingStyle style) { settings_are(style); }
  ~Style() { settings_are(SettingStyle::words); }
};

std::optional<int> digit(const std::string& text) {
  if (text.size() == 1 && text[0] >= '0' && text[0] <= '9') return text[0] - '0';
  return std::nullopt;
}

}  // namespace

TEST_CASE("a message names a setting as the users of the program write it") {
  CHECK(setting("force") == "force");
  CHECK(setting("allow-extrapolation") == "allow extrapolation");
  {
    const Style options(SettingStyle::options);
    CHECK(setting("allow-extrapolation") == "--allow-extrapolation");
    CHECK(setting("material-class") == "--class");
  }
  {
    const Style keywords(SettingStyle::keywords);
    CHECK(setting("force") == "force");
    CHECK(setting("allow-extrapolation") == "allow_extrapolation");
    CHECK(setting("material-class") == "material_class");
  }
}

TEST_CASE("a word that a setting does not know is refused with the words that it takes") {
  CHECK(setting_value("how-many", "", 7, digit, "a digit") == 7);
  CHECK(setting_value("how-many", "3", 7, digit, "a digit") == 3);
  const Style keywords(SettingStyle::keywords);
  CHECK(test::error_of([] { (void)setting_value("how-many", "\x1b", 7, digit, "a digit"); }) ==
        "how_many: \\x1b; expected a digit");
}
