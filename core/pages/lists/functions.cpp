// SPDX-License-Identifier: Apache-2.0
#include "core/light/functions.h"
#include "core/base/json/json_text.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/pages/lists/lists.h"

namespace etak {
namespace {

std::string range_text(const FunctionInput& input) {
  if (!input.words.empty()) return joined(input.words, "|");
  const bool no_min = input.min <= -1e300, no_max = input.max >= 1e300;
  return (no_min || input.above_min ? "(" : "[") + (no_min ? "-inf" : number(input.min, 6)) + ", " +
         (no_max ? "inf" : number(input.max, 6)) + (no_max ? ")" : "]");
}

std::string input_object(const FunctionInput& input) {
  constexpr int exact_digits = 17;
  std::vector<JsonMember> members{
      {"name", json(input.name)}, {"meaning", json(input.meaning)}, {"unit", json(input.unit)}};
  if (input.words.empty()) {
    members.push_back({"min", number(input.min, exact_digits)});
    members.push_back({"max", number(input.max, exact_digits)});
    members.push_back({"above_min", json(input.above_min)});
  } else {
    members.push_back({"words", json_array_of(input.words)});
  }
  return json_object(members, -1);
}

std::string function_object(const Function& function) {
  return json_object({{"id", json(function.id)},
                      {"returns", json(function.returns)},
                      {"source", json(function.source)},
                      {"inputs", '[' + joined(function.inputs, ", ", input_object) + ']'}},
                     -1);
}

}  // namespace

std::string functions_text() {
  std::string out;
  for (const Function& function : functions()) {
    append(out, function.id, ": ", function.returns, "\n    from ", function.source, '\n');
    for (const FunctionInput& input : function.inputs)
      append(out, "    ", padded(input.name, 10), ' ', padded(range_text(input), 20), ' ',
             padded(input.unit, 5), ' ', input.meaning, '\n');
  }
  return out;
}

std::string functions_json() {
  return json_document("etak-functions/1", {{"functions", json_lines_of(functions(), 2, function_object)}});
}

}  // namespace etak
