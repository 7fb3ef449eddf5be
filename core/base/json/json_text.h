// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text/text.h"

namespace etak {

// JSON written directly: the shortest number that reads back equal, and the line breaks that the writer
// wants.

std::string json(double value);           // "null" for NaN and infinity, which JSON does not have
std::string json(std::string_view text);  // quoted, valid UTF-8, quiet_json() of text.h
std::string json(const char* text);
std::string json(bool value);
// Of these two types one is std::size_t and one std::uint64_t, which are the same where addresses have 64 bits.
std::string json(unsigned long long value);
inline std::string json(unsigned long value) {
  return json(static_cast<unsigned long long>(value));
}

/// "[a, b, c]" of what is JSON already.
std::string json_array(std::span<const std::string> items);

/// "[a, b, c]" of values that json() writes.
template <class Values>
std::string json_array_of(const Values& values) {
  return '[' + joined(values, ", ", [](const auto& value) { return json(value); }) + ']';
}

/// "[...]" of what is JSON already, an item a line; "[]" of none.
///   indent   blanks before the closing bracket
std::string json_lines(std::span<const std::string> items, int indent);

/// An item a line, as json_lines(), of values that `json_of`, a function or member, writes.
template <class Values, class JsonOf>
std::string json_lines_of(const Values& values, int indent, JsonOf json_of) {
  std::vector<std::string> items;
  for (const auto& value : values) items.push_back(std::invoke(json_of, value));
  return json_lines(items, indent);
}

/// A key and its value, which is JSON already.
struct JsonMember {
  std::string_view key;
  std::string value;
};

/// "{...}", a member a line.
///   indent   blanks before the closing brace; below 0: all on one line
std::string json_object(std::span<const JsonMember> members, int indent);
inline std::string json_object(std::initializer_list<JsonMember> members, int indent) {
  return json_object(std::span(members.begin(), members.size()), indent);
}

/// "{...}" of rows of members: the first row begins behind the brace, each other one a line.
///   indent   blanks before the other rows
std::string json_rows(std::initializer_list<std::vector<JsonMember>> rows, int indent);

/// A whole document, a member a line: "schema" with the name and version of its form, then the members.
std::string json_document(std::string_view schema, std::initializer_list<JsonMember> members);

}  // namespace etak
