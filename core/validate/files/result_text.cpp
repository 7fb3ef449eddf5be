// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "core/base/bytes_le.h"
#include "core/validate/files/result_cache.h"

// A result as bytes: each member in the order below, numbers in eight bytes, texts and lists with their length
// before them, and a byte before what may be missing. An entry of a warm cache is read in a microsecond or two,
// where JSON takes ten times as long.

namespace etak {
namespace {

template <class To, class Struct>
void members(To& to, Struct& s);

// Writes members.
class Writer {
 public:
  std::string bytes;

  void number(std::uint64_t value) { bytes_le::append64(bytes, value); }
  void member(const std::string& text) {
    number(text.size());
    bytes += text;
  }
  void member(double value) { number(std::bit_cast<std::uint64_t>(value)); }
  void member(std::size_t value) { number(value); }
  void member(std::int64_t value) { number(static_cast<std::uint64_t>(value)); }
  void member(int value) { number(static_cast<std::uint64_t>(value)); }
  void member(Severity value) { number(static_cast<std::uint64_t>(value)); }
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
  template <class Value>
  void member(const Value& value) {
    members(*this, value);
  }
};

// Reads the same. Bytes of another form leave `good` false, and nothing is read beyond their end.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  bool good = true;
  bool at_end() const { return bytes_.empty(); }

  std::uint64_t number() {
    constexpr std::size_t size = 8;
    if (bytes_.size() < size) return fail();
    const std::uint64_t out = bytes_le::number64(bytes_, 0);
    bytes_.remove_prefix(size);
    return out;
  }
  // A length, which is never more than the bytes that are left: each part of a list takes at least one.
  std::size_t length() {
    const std::uint64_t out = number();
    return out > bytes_.size() ? fail() : static_cast<std::size_t>(out);
  }
  void member(std::string& text) {
    const std::size_t size = length();
    text.assign(bytes_.substr(0, size));
    bytes_.remove_prefix(size);
  }
  void member(double& value) { value = std::bit_cast<double>(number()); }
  void member(std::size_t& value) { value = static_cast<std::size_t>(number()); }
  void member(std::int64_t& value) { value = static_cast<std::int64_t>(number()); }
  void member(int& value) { value = static_cast<int>(number()); }
  void member(Severity& value) {
    const std::uint64_t read = number();
    if (read > static_cast<std::uint64_t>(Severity::error)) (void)fail();
    value = good ? static_cast<Severity>(read) : Severity::off;
  }
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
    if (bytes_.empty() || (bytes_[0] != '\0' && bytes_[0] != '\1')) return void(fail());
    const bool there = bytes_[0] == '\1';
    bytes_.remove_prefix(1);
    if (there) member(value.emplace());
  }
  template <class Value>
  void member(std::vector<Value>& values) {
    const std::size_t count = length();
    for (std::size_t i = 0; i < count && good; ++i) member(values.emplace_back());
  }
  template <class Value>
  void member(Value& value) {
    members(*this, value);
  }

 private:
  std::uint64_t fail() {
    good = false;
    bytes_ = {};
    return 0;
  }
  std::string_view bytes_;
};

// The members of each struct, once for both directions.
template <class To, class Struct>
void members(To& to, Struct& s) {
  using Type = std::remove_const_t<Struct>;
  const auto all = [&](auto&... values) { (to.member(values), ...); };
  if constexpr (std::is_same_v<Type, PixelBox>) {
    all(s.x, s.y, s.width, s.height);
  } else if constexpr (std::is_same_v<Type, NearestMaterial>) {
    all(s.id, s.dataset, s.bytes);
  } else if constexpr (std::is_same_v<Type, FindingIsland>) {
    all(s.tile, s.box, s.area_px, s.uv);
  } else if constexpr (std::is_same_v<Type, Finding>) {
    all(s.rule, s.slug, s.severity, s.file, s.tile, s.material, s.pointer, s.box, s.uv, s.area_px,
        s.area_share, s.linear, s.byte, s.luminance, s.value, s.limit, s.nearest, s.message, s.cause, s.fix,
        s.source, s.islands);
  } else {
    static_assert(std::is_same_v<Type, CheckedFile>);
    all(s.path, s.companions, s.sha256, s.width, s.height, s.roles, s.findings, s.plateau_px, s.transition_px,
        s.counts);
  }
}

}  // namespace

std::string result_text(const CheckedFile& file) {
  Writer out;
  out.member(file);
  return std::move(out.bytes);
}

std::optional<CheckedFile> read_result_text(std::string_view bytes) {
  Reader in(bytes);
  CheckedFile out;
  in.member(out);
  if (!in.good || !in.at_end()) return std::nullopt;
  return out;
}

}  // namespace etak
