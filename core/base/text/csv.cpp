// SPDX-License-Identifier: Apache-2.0
#include "core/base/text/csv.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/text.h"

namespace etak {
namespace {

template <class Fields>
void append_row(std::string& out, const Fields& fields) {
  std::string_view between;
  for (const std::string_view each : fields) {
    out += between;
    append_csv_field(out, each);
    between = ",";
  }
  out += '\n';
}

// Whether a spreadsheet may compute a cell of this text: = + - @ and their full-width forms begin a formula, and
// | a call of another program. A sign alone is none: "-" stands for standard input.
bool is_formula(std::string_view text) {
  double value = 0;
  const bool begins = text.find_first_of("=+-@|") == 0 || text.starts_with("\uFF1D") ||
                      text.starts_with("\uFF0B") || text.starts_with("\uFF0D") || text.starts_with("\uFF20");
  return text.size() > 1 && begins && !parse_number(text, value);
}

}  // namespace

void append_csv_field(std::string& out, std::string_view text) {
  std::string field = line_text(text);
  // Where a comma separates decimals, a spreadsheet begins a cell behind each semicolon, and takes quotes away.
  for (std::size_t begin = 0; (begin = field.find_first_not_of("; \"", begin)) != field.npos;) {
    if (is_formula(std::string_view(field).substr(begin, field.find(';', begin) - begin)))
      field.insert(begin, 1, '\'');
    begin = std::min(field.find(';', begin), field.size());
  }
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

void append_csv_row(std::string& out, std::initializer_list<std::string_view> fields) {
  append_row(out, fields);
}

void append_csv_row(std::string& out, std::span<const std::string> fields) {
  append_row(out, fields);
}

std::vector<CsvRow> csv_rows(std::string_view text, std::string_view file) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::vector<CsvRow> rows;
  CsvRow row{1, {}};
  std::string field;
  std::size_t line = 1;
  bool quoted = false, was_quoted = false;
  const auto end_row = [&] {
    if (!row.fields.empty() || !field.empty() || was_quoted) {
      row.fields.push_back(std::move(field));
      rows.push_back(std::move(row));
    }
    row = {line + 1, {}};
    field.clear();
    was_quoted = false;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '"' && i + 1 < text.size() && text[i + 1] == '"')
        field += text[++i];
      else if (c == '"')
        quoted = false;
      else
        field += c;
      line += c == '\n';
    } else if (c == '"' && field.empty()) {
      quoted = was_quoted = true;
    } else if (c == ',') {
      row.fields.push_back(std::move(field));
      field.clear();
      was_quoted = false;
    } else if (c == '\n') {
      end_row();
      ++line;
    } else if (c != '\r' || (i + 1 < text.size() && text[i + 1] != '\n')) {
      field += c;
    }
  }
  if (quoted) throw Error::at_line(file, row.line, "a quote that is not closed", "\"");
  end_row();
  return rows;
}

}  // namespace etak
