// SPDX-License-Identifier: Apache-2.0
#include "core/scene/uri.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/base/bytes/hex.h"
#include "core/base/error.h"
#include "core/base/text/ascii.h"

namespace etak {
namespace {

std::string without_escapes(std::string_view text, std::string_view place) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out += text[i];
      continue;
    }
    const int high = i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
    const int low = i + 2 < text.size() ? hex_digit(text[i + 2]) : -1;
    if (high < 0 || low < 0)
      throw Error::at(place, in_quotes(text.substr(i, 3)) + " in a URI", "% and two hexadecimal digits");
    out += static_cast<char>(16 * high + low);
    i += 2;
  }
  return out;
}

/// "https:", "C:": letters, digits, + - . up to a colon.
bool has_scheme(std::string_view text) {
  if (text.empty() || !is_letter(text[0])) return false;
  for (const char c : text) {
    if (c == ':') return true;
    if (!is_letter(c) && !is_digit(c) && c != '+' && c != '-' && c != '.') return false;
  }
  return false;
}

bool leaves_folder(std::string_view path) {
  if (path.front() == '/' || path.front() == '\\' || has_scheme(path)) return true;
  while (!path.empty()) {
    const auto end = std::min(path.find_first_of("/\\"), path.size());
    if (path.substr(0, end) == "..") return true;
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return false;
}

std::string from_base64(std::string_view text, std::string_view place) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::int8_t, 256> value;
  value.fill(-1);
  for (std::size_t i = 0; i < digits.size(); ++i)
    value[static_cast<unsigned char>(digits[i])] = static_cast<std::int8_t>(i);
  const auto fail = [&](std::string_view found) { throw Error::at(place, found, "base64 data"); };
  for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
  if (text.size() % 4 == 1) fail("base64 data that stop within a byte");
  std::string out;
  out.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int held = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int digit = value[static_cast<unsigned char>(text[i])];
    if (digit < 0) fail(in_quotes(text.substr(i, 1)) + " in base64 data, at " + std::to_string(i));
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    out += static_cast<char>(bits >> held & 0xFF);
  }
  return out;
}

}  // namespace

std::string file_of_uri(std::string_view uri, std::string_view place) {
  if (uri.empty()) throw Error::at(place, "an empty URI", "a file");
  if (has_scheme(uri))
    throw Error::at(place, in_quotes(uri, 60), "a file in the scene's folder or a data: URI");
  std::string path = without_escapes(uri, place);
  if (path.find('\0') != path.npos) throw Error::at(place, in_quotes(uri, 60), "a file name");
  if (leaves_folder(path)) throw Error::at(place, in_quotes(uri, 60), "a file in the scene's folder");
  return path;
}

std::optional<std::string> data_of_uri(std::string_view uri, std::string_view place) {
  if (!uri.starts_with("data:")) return std::nullopt;
  const auto comma = uri.find(',');
  if (comma == uri.npos) throw Error::at(place, "a data: URI without a comma", "data:TYPE;base64,DATA");
  const std::string_view data = uri.substr(comma + 1);
  if (!uri.substr(0, comma).ends_with(";base64")) return without_escapes(data, place);
  return from_base64(data, place);
}

std::string uri_of_file(std::string_view file) {
  std::string out;
  for (const char c : file) {
    if (is_letter(c) || is_digit(c) || std::string_view("-._~/").find(c) != std::string_view::npos) {
      out += c;
      continue;
    }
    out += '%';
    append_hex(out, c, hex_upper);
  }
  return out;
}

}  // namespace etak
