// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <catch2/catch.hpp>
#include <string_view>

#include "core/exchange/engine_values.h"

namespace etak::test {

/// The field of that name; the test fails where there is none.
inline const EngineField& field(const EngineValues& values, std::string_view name) {
  for (const EngineField& each : values.fields)
    if (each.name == name) return each;
  FAIL("no field " << name << " for " << values.target);
  return values.fields.front();
}

}  // namespace etak::test
