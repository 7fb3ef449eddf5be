// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/content_kind.h"

#include <algorithm>
#include <string>
#include <vector>

#include "core/base/number.h"
#include "core/exchange/table_columns.h"

namespace etak {
namespace {

bool is_text(std::string_view head) {
  return std::none_of(head.begin(), head.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f';
  });
}

// Lists that only a scene has: "asset" itself may stand at the end of a large document.
bool has_lists_of_gltf(std::string_view head) {
  const auto has = [&](std::string_view key) { return head.find(key) != std::string_view::npos; };
  return has("\"accessors\"") || has("\"bufferViews\"") || has("\"extensionsUsed\"") || has("\"meshes\"") ||
         (has("\"asset\"") && has("\"version\""));
}

bool is_row(std::string_view line, std::vector<std::string_view>& fields) {
  split_fields(line, find_separator(line), fields);
  double value = 0;
  return fields.size() >= 2 && parse_cell(fields[0], value) && parse_cell(fields[1], value);
}

// A header names wavelength or energy and another column, and few other words: prose may also hold the words
// "wavelength" and "n".
bool is_header(std::string_view line) {
  bool axis = false, quantity = false;
  std::size_t known = 0;
  const std::vector<std::string> names = header_names(line, find_separator(line));
  for (const std::string& name : names) {
    Column column;
    std::string problem;
    if (!parse_column(name, column, problem)) continue;
    ++known;
    const bool is_axis = column.quantity == Quantity::wavelength || column.quantity == Quantity::energy;
    axis = axis || is_axis;
    quantity = quantity || (!is_axis && column.quantity != Quantity::skipped);
  }
  return axis && quantity && 2 * known >= names.size();
}

}  // namespace

ContentKind content_kind(std::string_view head) {
  head = head.substr(0, content_head);
  if (head.starts_with("glTF")) return ContentKind::gltf;
  if (!is_text(head)) return ContentKind::binary;
  if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == head.npos) return ContentKind::prose;
  if (head[first] == '{') return has_lists_of_gltf(head) ? ContentKind::gltf : ContentKind::json;
  std::vector<std::string_view> fields;
  bool table = false;
  while (!head.empty()) {
    std::string_view line = head.substr(0, head.find('\n'));
    head.remove_prefix(std::min(line.size() + 1, head.size()));
    if (line.starts_with("DATA:") || line.starts_with("REFERENCES:")) return ContentKind::page;
    line = line.substr(0, line.find('#'));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (!table && !line.empty()) table = is_row(line, fields) || is_header(line);
  }
  return table ? ContentKind::table : ContentKind::prose;
}

}  // namespace etak
