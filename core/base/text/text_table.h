// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

namespace etak {

/// A line of a text table.
///   cells    any text, of one line each (line_text()); the last is as long as it is and widens no column, so
///            a row may end early with a long remark
///   before   what stands in front of the row as it is, such as a swatch of colour for terminals
struct TextRow {
  std::vector<std::string> cells;
  std::string before = {};
};

/// The rows with columns as wide as their widest cell, two blanks between them and none at the end of a line.
/// A column that is to have a least width gets it by blanks at the end of its heading.
std::string text_table(std::span<const TextRow> rows);

}  // namespace etak
