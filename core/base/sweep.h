// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/number.h"

namespace etak {

/// A name and the values that take turns in its place.
struct Sweep {
  std::string name;
  std::vector<std::string> values;
};

/// How a sweep is written.
///   expected   for messages
///   most       values
///   read       FIRST and LAST; gives false for what is no value
///   unit       in which `read` gives numbers, behind each step
struct SweepForm {
  std::string expected;
  std::size_t most = 64;
  std::function<bool(std::string_view, double&)> read = parse_number;
  std::string unit = {};
};

/// "NAME=FIRST:LAST:COUNT", numbers at even steps, or "NAME=VALUE,VALUE,...". Throws Error (naming the setting sweep)
/// for a text of another form, and for less than two values or more than the form allows.
Sweep parse_sweep(const std::string& text, const SweepForm& form);

}  // namespace etak
