// SPDX-License-Identifier: Apache-2.0
#include "core/base/text/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "core/base/bytes/hex.h"
#include "core/base/number.h"

namespace etak {
namespace {

struct CodePoint {
  std::uint32_t value = 0;
  std::size_t length = 0;  // in bytes; 0: not well-formed
};

CodePoint decode(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return {};
  std::uint32_t value = lead & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    value = value << 6 | (byte(i) & 0x3Fu);
  }
  // Overlong forms, surrogates and what lies beyond Unicode.
  const bool overlong = (length == 3 && value < 0x800) || (length == 4 && value < 0x10000);
  if (overlong || value > 0x10FFFF || (value >= 0xD800 && value < 0xE000)) return {};
  return {value, length};
}

bool is_wide(std::uint32_t c) {
  return (c >= 0x1100 && c < 0x1160) || (c >= 0x2E80 && c < 0xA4D0) || (c >= 0xAC00 && c < 0xD7A4) ||
         (c >= 0xF900 && c < 0xFB00) || (c >= 0xFF00 && c < 0xFF61) || c >= 0x1F300;
}

// Characters that a terminal acts on, or that show other text than the bytes hold. The marks of direction
// are those that Unicode's UAX #9 lists.
bool is_active(std::uint32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x61C || c == 0x200E || c == 0x200F ||
         (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069) || c == 0xFEFF;
}

void append_x(std::string& out, char c) {
  out += "\\x";
  append_hex(out, c);
}

void append_u(std::string& out, std::uint32_t c) {
  out += "\\u";
  for (int shift = 12; shift >= 0; shift -= 4) out += hex_lower[c >> shift & 15];
}

// Unicode's blanks (category Zs), which build services take away before they look for a command.
bool is_blank(std::uint32_t c) {
  return c == ' ' || c == 0xA0 || c == 0x1680 || (c >= 0x2000 && c <= 0x200A) || c == 0x202F || c == 0x205F ||
         c == 0x3000;
}

std::size_t columns_of(std::uint32_t character) {
  const bool combining = character >= 0x300 && character < 0x370;
  return combining ? 0 : is_wide(character) ? 2 : 1;
}

}  // namespace

std::vector<std::string> parts_of(std::string_view text, char separator) {
  std::vector<std::string> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    if (end > 0) out.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

std::string valid_utf8(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const CodePoint point = decode(text);
    const std::size_t taken = point.length ? point.length : 1;
    if (point.length)
      out += text.substr(0, taken);
    else
      out += "\uFFFD";
    text.remove_prefix(taken);
  }
  return out;
}

std::string line_text(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  bool behind_blank = true;  // as at the beginning
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint point = decode(text.substr(i));
    const std::string_view two = text.substr(i, 2);
    const bool command = two == "##" || (two == "::" && behind_blank);
    behind_blank = is_blank(point.value);
    if (point.length <= 1 && (point.length == 0 || is_active(point.value) || command))
      append_x(out, text[i]);
    else if (is_active(point.value))
      append_u(out, point.value);
    else
      out += text.substr(i, point.length);
    i += point.length ? point.length : 1;
  }
  return out;
}

std::string quiet_json(std::string text) {
  const auto suspect = [](char c) { return static_cast<unsigned char>(c) >= 0x7F; };
  if (std::none_of(text.begin(), text.end(), suspect) && text.find("##") == text.npos) return text;
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint point = decode(std::string_view(text).substr(i));
    const std::size_t length = point.length ? point.length : 1;
    if ((point.value >= 0x7F && is_active(point.value)) || text.compare(i, 2, "##") == 0)
      append_u(out, point.value);
    else
      out.append(text, i, length);
    i += length;
  }
  return out;
}

std::string padded(std::string_view text, std::size_t width) {
  std::string out = line_text(text);
  const std::size_t have = display_width(out);
  if (have < width) out.append(width - have, ' ');
  return out;
}

std::size_t cell_width(std::string_view text) {
  return display_width(line_text(text));
}

std::size_t display_width(std::string_view text) {
  std::size_t width = 0;
  while (!text.empty()) {
    const CodePoint point = decode(text);
    width += columns_of(point.value);
    text.remove_prefix(point.length ? point.length : 1);
  }
  return width;
}

std::string_view front_of(std::string_view text, std::size_t columns) {
  std::size_t width = 0, end = 0;
  while (end < text.size()) {
    const CodePoint point = decode(text.substr(end));
    width += columns_of(point.value);
    if (width > columns) break;
    end += point.length ? point.length : 1;
  }
  return text.substr(0, end);
}

std::string escape_html(std::string_view text) {
  std::string blank(text);
  for (char& c : blank)
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';
  std::string out;
  for (const char c : line_text(blank)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string fixed(double value, int decimals) {
  // Beyond this the digits of a double mean nothing, and there may be 309 of them.
  if (std::abs(value) >= 1e15) return number(value, 6);
  std::array<char, 64> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals).ptr;
  std::string out(text.data(), end);
  if (out.front() == '-' && out.find_first_not_of("-0.") == std::string::npos) out.erase(0, 1);
  return out;
}

}  // namespace etak
