// SPDX-License-Identifier: Apache-2.0
#include "core/light/functions_csv.h"

#include <algorithm>
#include <vector>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/base/text/ascii.h"
#include "core/base/text/csv.h"
#include "core/base/text/edit_distance.h"

namespace etak {
namespace {

constexpr int digits = 17;

std::size_t column(const CsvRow& header, std::string_view name, std::string_view file) {
  const auto is_it = [&](const std::string& field) { return trimmed(field) == name; };
  const auto found = std::find_if(header.fields.begin(), header.fields.end(), is_it);
  if (found == header.fields.end())
    throw Error::at_line(file, header.line, "no column \"" + std::string(name) + "\"", "id,function,inputs");
  if (std::find_if(found + 1, header.fields.end(), is_it) != header.fields.end())
    throw Error::at_line(file, header.line, "two columns \"" + std::string(name) + "\"", "one");
  return static_cast<std::size_t>(found - header.fields.begin());
}

double evaluate_row(const std::string& function, std::string_view inputs, std::string_view place) {
  std::vector<NamedText> named;
  while (!inputs.empty()) {
    const std::size_t end = std::min(inputs.find(';'), inputs.size());
    if (const auto part = inputs.substr(0, end); part.find_first_not_of(" \t") != part.npos)
      named.push_back(split_input(part, place));
    inputs.remove_prefix(std::min(end + 1, inputs.size()));
  }
  return evaluate(function_named(function, place), named, place);
}

}  // namespace

const Function& function_named(std::string_view id, std::string_view place) {
  const Function* found = find_function(trimmed(id));
  const std::string at = place.empty() ? "function" : std::string(place) + ": function";
  if (found != nullptr) return *found;
  std::vector<std::string> ids;
  for (const Function& each : functions()) ids.emplace_back(each.id);
  throw Error::at(
      at, printable(id),
      "one of those that etak eval " + setting("list") + " names" + did_you_mean(trimmed(id), ids));
}

CsvAnswers answer_csv(std::string_view text, const std::string& file,
                      const std::function<void(std::string_view)>& refuse) {
  const std::vector<CsvRow> rows = csv_rows(text, file);
  if (rows.empty()) throw Error::at(file, "no rows", "a header id,function,inputs and rows");
  const std::size_t id = column(rows[0], "id", file), function = column(rows[0], "function", file),
                    inputs = column(rows[0], "inputs", file);
  CsvAnswers out{"id,value\n", rows.size() - 1, 0};
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const CsvRow& row = rows[i];
    const std::string place = file + ':' + std::to_string(row.line);
    const auto field = [&](std::size_t at) {
      return at < row.fields.size() ? row.fields[at] : std::string();
    };
    std::string value = "error";
    try {
      if (function >= row.fields.size())
        throw Error::at(place, std::to_string(row.fields.size()) + " fields", "id,function,inputs");
      value = number(evaluate_row(field(function), field(inputs), place), digits);
    } catch (const Error& e) {
      refuse(e.what());
      ++out.refused;
    }
    append_csv_row(out.text, {field(id), value});
  }
  return out;
}

}  // namespace etak
