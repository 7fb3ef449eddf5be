// SPDX-License-Identifier: Apache-2.0
#include "core/base/csv.h"

#include "core/base/number.h"
#include "core/base/text.h"

namespace etak {

void append_csv_field(std::string& out, std::string_view text) {
  std::string field = line_text(text);
  double value = 0;
  // A sign alone is no formula: "-" stands for standard input.
  if (field.size() > 1 && field.find_first_of("=+-@") == 0 && !parse_number(field, value))
    field.insert(0, 1, '\'');
  if (field.find_first_of(",\"") == field.npos) {
    out += field;
    return;
  }
  out += '"';
  for (const char c : field) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
}

std::string csv_field(std::string_view text) {
  std::string out;
  append_csv_field(out, text);
  return out;
}

}  // namespace etak
