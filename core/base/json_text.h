// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "core/base/text.h"

namespace etak {

// JSON written directly: the shortest number that reads back equal, and the line breaks that the writer
// wants.

std::string json(double value);           // "null" for NaN and infinity, which JSON does not have
std::string json(std::string_view text);  // quoted, valid UTF-8, quiet_json() of text.h
std::string json(const char* text);
std::string json(bool value);
std::string json(std::size_t value);

/// "[a, b, c]" of what is JSON already.
std::string json_array(std::span<const std::string> items);

/// The same of values that json() writes.
template <class Values>
std::string json_array_of(const Values& values) {
  return '[' + joined(values, ", ", [](const auto& value) { return json(value); }) + ']';
}

/// A key and its value, which is JSON already.
struct JsonMember {
  std::string_view key;
  std::string value;
};

/// "{...}", a member a line.
///   indent   blanks before the closing brace; below 0: all on one line
std::string json_object(std::span<const JsonMember> members, int indent);

}  // namespace etak
