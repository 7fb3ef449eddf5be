// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "core/light/functions.h"

namespace etak {

/// The function with this id, around which blanks are ignored. Throws Error for unknown ids.
///   place   file and line, for messages; empty for the command line
const Function& function_named(std::string_view id, std::string_view place);

/// The answers of `etak eval --csv`.
struct CsvAnswers {
  std::string text;                   // a header, and rows id,value in the order of the questions
  std::size_t rows = 0, refused = 0;  // how many questions there are, and how many have the value "error"
};

/// Answers a CSV table of questions (RFC 4180) with the columns id, function and inputs; inputs are written
/// as name=value;name=value. Throws Error that names `file` and line where the text is no such table.
///   refuse   is called with the reason for each row that has no answer
CsvAnswers answer_csv(std::string_view text, const std::string& file,
                      const std::function<void(std::string_view)>& refuse);

}  // namespace etak
