// SPDX-License-Identifier: Apache-2.0
#include "core/base/text/text_table.h"

#include <algorithm>
#include <cstddef>

#include "core/base/text/text.h"

namespace etak {

std::string text_table(std::span<const TextRow> rows) {
  std::vector<std::size_t> widths;
  for (const TextRow& row : rows)
    for (std::size_t i = 0; i + 1 < row.cells.size(); ++i) {
      if (i == widths.size()) widths.push_back(0);
      widths[i] = std::max(widths[i], cell_width(row.cells[i]));
    }
  std::string out;
  for (const TextRow& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.cells.size(); ++i)
      line += i + 1 < row.cells.size() ? padded(row.cells[i], widths[i]) + "  " : line_text(row.cells[i]);
    line.erase(line.find_last_not_of(' ') + 1);
    append(out, row.before, line, '\n');
  }
  return out;
}

}  // namespace etak
