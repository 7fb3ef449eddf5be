// SPDX-License-Identifier: Apache-2.0
// Strict reading of JSON for the *json.cpp files of core: no public header, because it names nlohmann-json.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace etak {

using Json = nlohmann::json;

/// Empties a value from its leaves upwards, without asking for memory. The destructor of nlohmann-json first
/// moves all children into a new array: where memory has just ended, that ends the program.
void take_apart(Json& value) noexcept;

/// A document that was read, which is taken apart when it ends.
class JsonDocument {
 public:
  explicit JsonDocument(Json value) noexcept : value_(std::move(value)) {}
  JsonDocument(JsonDocument&& other) noexcept : value_(std::move(other.value_)) {}
  JsonDocument& operator=(JsonDocument&&) = delete;
  ~JsonDocument() { take_apart(value_); }

  const Json& operator*() const { return value_; }
  const Json* operator->() const { return &value_; }
  operator const Json&() const { return value_; }
  Json take() && { return std::move(value_); }

 private:
  Json value_;
};

/// Parses a document and refuses what nlohmann-json lets pass: equal keys in one object, and depth without
/// end.
///   file   for messages
///   what   "a material file", what the document should have been
/// Takes time in proportion to the text (times the logarithm of an object's keys). Throws Error, also where
/// the document does not fit into memory.
JsonDocument parse_json_strictly(std::string_view text, std::string_view file, int most_depth,
                                 std::string_view what);

/// A value and its place. Missing members and wrong types throw Error with file and JSON pointer.
struct JsonNode {
  const Json& value;
  std::string_view file;
  std::string pointer;

  [[noreturn]] void fail(std::string_view found, std::string_view expected = {}) const {
    throw Error::at(std::string(file) + '#' + (pointer.empty() ? "/" : pointer), found, expected);
  }
  [[noreturn]] void fail_type(std::string_view expected) const {
    fail(printable(value.dump(-1, ' ', false, Json::error_handler_t::replace), 60), expected);
  }

  bool has(std::string_view key) const { return value.contains(key); }
  JsonNode at(std::string_view key) const {
    const auto found = value.find(key);
    if (found == value.end()) fail("no \"" + std::string(key) + "\"", "this key");
    return {*found, file, pointer + '/' + std::string(key)};
  }
  JsonNode at(std::size_t index) const { return {value[index], file, pointer + '/' + std::to_string(index)}; }
  std::size_t size() const { return value.size(); }

  void expect_object() const {
    if (!value.is_object()) fail_type("an object");
  }
  /// An object with no other keys than these.
  void expect_object(std::initializer_list<std::string_view> keys) const {
    expect_object();
    for (const auto& [key, ignored] : value.items())
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) fail("unknown key " + in_quotes(key));
  }
  void expect_array() const {
    if (!value.is_array()) fail_type("an array");
  }

  std::string text() const {
    if (!value.is_string()) fail_type("a string");
    return value.get<std::string>();
  }
  std::string text_or_empty(std::string_view key) const { return has(key) ? at(key).text() : std::string(); }
  /// The text of a document's form, such as "etak-baseline/1".
  void expect_text(std::string_view expected) const {
    if (text() != expected) fail_type(in_quotes(expected));
  }
  /// The value that the text names: an optional that `named` finds.
  template <class Named>
  auto word(const Named& named, std::string_view expected) const {
    const auto out = named(text());
    if (!out) fail_type(expected);
    return *out;
  }

  /// What `read`, a function or member, makes of every element of an array.
  template <class Read>
  auto each(const Read& read) const {
    expect_array();
    std::vector<std::decay_t<std::invoke_result_t<Read, const JsonNode&>>> out;
    out.reserve(size());
    for (std::size_t i = 0; i < size(); ++i) out.push_back(std::invoke(read, at(i)));
    return out;
  }
  std::vector<std::string> texts() const { return each(&JsonNode::text); }
  /// What `read` makes of the elements of an array of so many.
  template <std::size_t count, class Read>
  auto each_of(const Read& read, std::string_view expected) const {
    if (!value.is_array() || size() != count) fail_type(expected);
    std::array<std::decay_t<std::invoke_result_t<Read, const JsonNode&>>, count> out;
    for (std::size_t i = 0; i < count; ++i) out[i] = std::invoke(read, at(i));
    return out;
  }

  bool is_number() const { return value.is_number(); }
  bool boolean() const {
    if (!value.is_boolean()) fail_type("true or false");
    return value.get<bool>();
  }
  double number() const {
    if (!value.is_number()) fail_type("a number");
    const double number = value.get<double>();
    if (!std::isfinite(number)) fail_type("a finite number");
    return number;
  }
  /// The default bounds are far inside what an int holds.
  int integer(int least = -1000000, int most = 1000000) const {
    const std::string range = "a whole number from " + std::to_string(least) + " to " + std::to_string(most);
    if (!value.is_number_integer()) fail_type(range);
    if (value < least || value > most) fail_type(range);
    return value.get<int>();
  }
};

}  // namespace etak
