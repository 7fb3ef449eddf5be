// SPDX-License-Identifier: Apache-2.0
#include "core/base/setting.h"

#include <catch2/catch.hpp>

using namespace etak;

// The command line's own form stands in the expected messages of tests/cli.
TEST_CASE(
    "a message names a setting without dashes where no program has said that its settings are options") {
  CHECK(setting("force") == "force");
  CHECK(setting("allow-extrapolation") == "allow extrapolation");
}
