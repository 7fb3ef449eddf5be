// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "core/light/functions.h"

namespace etak {

/// The function of that name, blanks around it left out. Throws Error.
///   place   file and line, for messages; empty: the command line
const Function& function_named(std::string_view id, std::string_view place);

/// What `etak eval --csv` answers.
struct CsvAnswers {
  std::string text;                   // rows id,value in the order of the questions, with a header
  std::size_t rows = 0, refused = 0;  // a refused row's value is "error"
};

/// Answers a CSV of questions (RFC 4180; columns id, function and inputs as name=value;name=value).
///   refuse   called with the reason for each row that has no answer
/// Throws Error naming `file` and line where the text is no such table.
CsvAnswers answer_csv(std::string_view text, const std::string& file,
                      const std::function<void(std::string_view)>& refuse);

}  // namespace etak
