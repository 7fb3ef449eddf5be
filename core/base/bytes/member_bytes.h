// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/bytes/bytes_le.h"
#include "core/base/members.h"

// Structs as bytes and back: each member in a fixed order, numbers in eight bytes, texts and lists with their
// length before them, and a byte before what may be missing. A small struct is read in a microsecond or two,
// where JSON takes ten times as long. A struct takes part by a function members(to, value) (members.h); it serves
// both directions. An enumeration takes part by a function last_of(value), found beside it, that gives the last of
// its values, which begin at 0.

namespace etak {

/// Writes members.
class MemberWriter {
 public:
  std::string bytes;

  void member(const std::string& text) {
    number(text.size());
    bytes += text;
  }
  void member(bool value) { number(value ? 1 : 0); }
  void member(double value) { number(std::bit_cast<std::uint64_t>(value)); }
  void member(std::uint64_t value) { number(value); }
  void member(std::int64_t value) { number(static_cast<std::uint64_t>(value)); }
  void member(int value) { number(static_cast<std::uint64_t>(value)); }
  void member(std::uint8_t value) { number(value); }
  template <class Value, std::size_t count>
  void member(const std::array<Value, count>& values) {
    for (const Value& value : values) member(value);
  }
  template <class A, class B>
  void member(const std::pair<A, B>& pair) {
    member(pair.first);
    member(pair.second);
  }
  template <class Value>
  void member(const std::optional<Value>& value) {
    bytes += value ? '\1' : '\0';
    if (value) member(*value);
  }
  template <class Value>
  void member(const std::vector<Value>& values) {
    number(values.size());
    for (const Value& value : values) member(value);
  }
  template <class Key, class Value, class Less>
  void member(const std::map<Key, Value, Less>& values) {
    number(values.size());
    for (const auto& pair : values) member(pair);
  }
  template <class Value>
  void member(const Value& value) {
    if constexpr (std::is_enum_v<Value> || std::is_unsigned_v<Value>)
      number(static_cast<std::uint64_t>(value));
    else
      members(*this, value);
  }

  template <class Value>
  void member(std::string_view, const Value& value, Said = Said::always) {
    member(value);
  }
  template <class Act>
  void object(std::string_view, bool, Act act) {
    act(*this);
  }

 private:
  void number(std::uint64_t value) { bytes_le::append64(bytes, value); }
};

/// Reads the same. Bytes of another form leave it not good, and nothing is read beyond their end.
class MemberReader {
 public:
  explicit MemberReader(std::string_view bytes) : bytes_(bytes) {}

  /// Whether all bytes were read, and were of that form.
  bool good() const { return good_ && bytes_.empty(); }

  void member(std::string& text) {
    const std::size_t size = length();
    text.assign(bytes_.substr(0, size));
    bytes_.remove_prefix(size);
  }
  void member(bool& value) { value = number() != 0; }
  void member(double& value) { value = std::bit_cast<double>(number()); }
  void member(std::uint64_t& value) { value = number(); }
  void member(std::int64_t& value) { value = static_cast<std::int64_t>(number()); }
  void member(int& value) { value = static_cast<int>(number()); }
  template <class Value, std::size_t count>
  void member(std::array<Value, count>& values) {
    for (Value& value : values) member(value);
  }
  template <class A, class B>
  void member(std::pair<A, B>& pair) {
    member(pair.first);
    member(pair.second);
  }
  template <class Value>
  void member(std::optional<Value>& value) {
    if (bytes_.empty() || (bytes_[0] != '\0' && bytes_[0] != '\1')) return fail();
    const bool there = bytes_[0] == '\1';
    bytes_.remove_prefix(1);
    if (there) member(value.emplace());
  }
  template <class Value>
  void member(std::vector<Value>& values) {
    // Room for more is made when there turns out to be more: the number may be anybody's.
    constexpr std::size_t most_at_once = 64;
    const std::size_t count = length();
    if constexpr (std::is_same_v<Value, double>) {
      // The bytes that are left bound the numbers, so that all of them have their room at once.
      constexpr std::size_t size = 8;
      if (count > bytes_.size() / size) return fail();
      values.resize(count);
      for (std::size_t i = 0; i < count; ++i)
        values[i] = std::bit_cast<double>(bytes_le::number64(bytes_, i * size));
      bytes_.remove_prefix(count * size);
      return;
    }
    values.reserve(std::min(count, most_at_once));
    for (std::size_t i = 0; i < count && good_; ++i) member(values.emplace_back());
  }
  template <class Value>
  void member(Value& value) {
    if constexpr (requires { last_of(value); }) {
      const std::uint64_t read = number();
      if (read > static_cast<std::uint64_t>(last_of(value))) return fail();
      value = static_cast<Value>(read);
    } else if constexpr (std::is_unsigned_v<Value>) {
      const std::uint64_t read = number();
      if (read > std::numeric_limits<Value>::max()) return fail();
      value = static_cast<Value>(read);
    } else {
      members(*this, value);
    }
  }
  template <class Value>
  void member(std::string_view, Value& value, Said = Said::always) {
    member(value);
  }
  template <class Act>
  void object(std::string_view, bool, Act act) {
    act(*this);
  }

  /// For members that are of no form that their struct takes.
  void fail() {
    good_ = false;
    bytes_ = {};
  }

 private:
  std::uint64_t number() {
    constexpr std::size_t size = 8;
    if (bytes_.size() < size) {
      fail();
      return 0;
    }
    const std::uint64_t out = bytes_le::number64(bytes_, 0);
    bytes_.remove_prefix(size);
    return out;
  }
  // Never more than the bytes that are left: each element of a list takes at least one.
  std::size_t length() {
    const std::uint64_t out = number();
    if (out <= bytes_.size()) return static_cast<std::size_t>(out);
    fail();
    return 0;
  }

  std::string_view bytes_;
  bool good_ = true;
};

}  // namespace etak
