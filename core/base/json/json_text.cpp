// SPDX-License-Identifier: Apache-2.0
#include "core/base/json/json_text.h"

#include <array>
#include <charconv>
#include <cmath>

#include "core/base/bytes/hex.h"
#include "core/base/text/text.h"

namespace etak {
namespace {

std::string member_text(const JsonMember& member) {
  return json(member.key) + ": " + member.value;
}

}  // namespace

std::string json(double value) {
  if (!std::isfinite(value)) return "null";
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string json(std::string_view text) {
  std::string out = "\"";
  for (const char c : valid_utf8(text)) {
    if (c == '"' || c == '\\') {
      append(out, '\\', c);
    } else if (static_cast<unsigned char>(c) < 0x20) {
      out += "\\u00";
      append_hex(out, c);
    } else {
      out += c;
    }
  }
  out += '"';
  return quiet_json(std::move(out));
}

std::string json(const char* text) {
  return json(std::string_view(text));
}

std::string json(bool value) {
  return value ? "true" : "false";
}

std::string json(unsigned long long value) {
  return std::to_string(value);
}

std::string json_array(std::span<const std::string> items) {
  return '[' + joined(items) + ']';
}

std::string json_lines(std::span<const std::string> items, int indent) {
  if (items.empty()) return "[]";
  const std::string blanks(static_cast<std::size_t>(indent), ' ');
  const std::string start = "\n" + blanks + "  ";
  return '[' + start + joined(items, ',' + start) + '\n' + blanks + ']';
}

std::string json_object(std::span<const JsonMember> members, int indent) {
  const std::string start = indent < 0 ? "" : "\n" + std::string(static_cast<std::size_t>(indent) + 2, ' ');
  std::string out = "{";
  if (!members.empty()) out += start + joined(members, indent < 0 ? ", " : ',' + start, member_text);
  if (indent >= 0) out.append(1, '\n').append(static_cast<std::size_t>(indent), ' ');
  return out += '}';
}

std::string json_rows(std::initializer_list<std::vector<JsonMember>> rows, int indent) {
  const std::string start = ",\n" + std::string(static_cast<std::size_t>(indent), ' ');
  return '{' + joined(rows, start, [](const auto& row) { return joined(row, ", ", member_text); }) + '}';
}

std::string json_document(std::string_view schema, std::initializer_list<JsonMember> members) {
  std::vector<JsonMember> all{{"schema", json(schema)}};
  all.insert(all.end(), members.begin(), members.end());
  return json_object(all, 0) + '\n';
}

}  // namespace etak
