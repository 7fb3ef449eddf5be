// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace etak {

/// A text field of a CSV row (RFC 4180), for programs and spreadsheets; numbers are written without it. The
/// field is line_text() of `text`, so a row is one line, in quotes where it holds a comma or a quote. Where
/// it begins with `=`, `+`, `-` or `@` and is no number, an apostrophe comes first: a spreadsheet would take
/// it for a formula.
std::string csv_field(std::string_view text);
void append_csv_field(std::string& out, std::string_view text);

}  // namespace etak
