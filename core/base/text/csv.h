// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace etak {

/// A text field of a CSV row (RFC 4180), for programs and spreadsheets; numbers are written without it. The
/// field is line_text() of `text`, so a row is one line, in quotes where it holds a comma or a quote. Where
/// it begins, or goes on behind a semicolon, with `=`, `+`, `-`, `@`, one of their full-width forms or `|`, and is
/// no number, an apostrophe comes first: a spreadsheet would take it for a formula.
std::string csv_field(std::string_view text);
void append_csv_field(std::string& out, std::string_view text);

/// A row of such fields, with its line end.
void append_csv_row(std::string& out, std::initializer_list<std::string_view> fields);
void append_csv_row(std::string& out, std::span<const std::string> fields);

/// A row that was read, and the line of the file on which it begins, 1-based.
struct CsvRow {
  std::size_t line = 1;
  std::vector<std::string> fields;
};

/// The rows of a CSV by RFC 4180: fields in quotes may hold commas, line ends and doubled quotes. Lines end
/// with LF or CRLF; empty ones and a byte order mark are skipped. Throws Error for a quote without its end.
std::vector<CsvRow> csv_rows(std::string_view text, std::string_view file);

}  // namespace etak
