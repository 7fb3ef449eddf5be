// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <string_view>

#include "core/study/error_time.h"

namespace etak::test {

/// The table of that id; the test fails where there is none.
inline const ErrorTimeTable& table(const ErrorTimeFamily& family, std::string_view id) {
  const auto found = std::ranges::find(family.tables, id, &ErrorTimeTable::id);
  REQUIRE(found != family.tables.end());
  return *found;
}

}  // namespace etak::test
