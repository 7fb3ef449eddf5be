// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/light/functions.h"

/// Values of the functions of `etak eval`, for tests.
namespace etak::test::function_values {

inline double c(double degrees) {
  return std::cos(degrees * std::numbers::pi / 180);
}
inline double s(double degrees) {
  return std::sin(degrees * std::numbers::pi / 180);
}

// Evaluates a function for inputs written as "n=1.5;k=0".
inline double eval(std::string_view id, std::string_view inputs) {
  const Function* function = find_function(id);
  if (!function) throw Error("no function " + std::string(id));
  std::vector<NamedText> named;
  while (!inputs.empty()) {
    const auto end = std::min(inputs.find(';'), inputs.size());
    named.push_back(split_input(inputs.substr(0, end), "test"));
    inputs.remove_prefix(std::min(end + 1, inputs.size()));
  }
  return evaluate(*function, named, "test");
}

inline Approx near_to(double value, double relative = 1e-11) {
  return Approx(value).epsilon(relative).margin(1e-300);
}

}  // namespace etak::test::function_values
