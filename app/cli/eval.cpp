// SPDX-License-Identifier: Apache-2.0
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <memory>

#include "app/cli/file_options.h"
#include "app/cli/output.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/number.h"
#include "core/light/functions.h"

namespace etak::cli {
namespace {

constexpr int digits = 17;

struct EvalArguments {
  std::string function;
  std::vector<std::string> inputs;
  std::string csv;
  bool list = false;
  OutputArguments output;
};

// `place`: file and line, empty for the command line.
const Function& function_named(std::string_view id, std::string_view place) {
  const Function* found = find_function(id);
  const std::string at = place.empty() ? "function" : std::string(place) + ": function";
  if (!found) throw Error::at(at, printable(id), "one of those that etak eval --list names");
  return *found;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// ---- --csv

struct CsvRow {
  std::size_t line;
  std::vector<std::string> fields;
};

// RFC 4180: fields in quotes may hold commas, line ends and doubled quotes. Empty lines are skipped.
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
  return evaluate(function_named(trimmed(function), place), named, place);
}

int run_csv(const EvalArguments& arguments) {
  const std::string& file = arguments.csv;
  const std::string text = read_file(file);
  const std::vector<CsvRow> rows = csv_rows(text, file);
  if (rows.empty()) throw Error::at(file, "no rows", "a header id,function,inputs and rows");
  const std::size_t id = column(rows[0], "id", file), function = column(rows[0], "function", file),
                    inputs = column(rows[0], "inputs", file);
  std::string out = "id,value\n";
  std::size_t refused = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const CsvRow& row = rows[i];
    const std::string place = file + ':' + std::to_string(row.line);
    const auto field = [&](std::size_t at) {
      return at < row.fields.size() ? row.fields[at] : std::string();
    };
    out += csv_field(field(id)) + ',';
    try {
      if (function >= row.fields.size())
        throw Error::at(place, std::to_string(row.fields.size()) + " fields", "id,function,inputs");
      append_number(out, evaluate_row(field(function), field(inputs), place), digits);
    } catch (const Error& e) {
      complain(e.what());
      out += "error";
      ++refused;
    }
    out += '\n';
  }
  write_output(arguments.output, out);
  remark(arguments.output,
         std::to_string(rows.size() - 1) + " rows, " + std::to_string(refused) + " refused");
  return exit_ok;
}

// ---- --list

std::string range(const FunctionInput& input) {
  if (!input.words.empty()) {
    std::string out;
    for (const std::string_view word : input.words) out += (out.empty() ? "" : "|") + std::string(word);
    return out;
  }
  const bool no_min = input.min <= -1e300, no_max = input.max >= 1e300;
  return (no_min || input.above_min ? "(" : "[") + (no_min ? "-inf" : number(input.min, 6)) + ", " +
         (no_max ? "inf" : number(input.max, 6)) + (no_max ? ")" : "]");
}

std::string list_text() {
  std::string out;
  for (const Function& function : functions()) {
    out += std::string(function.id) + ": " + std::string(function.returns) + "\n    from " +
           std::string(function.source) + '\n';
    for (const FunctionInput& input : function.inputs)
      out += "    " + padded(input.name, 10) + ' ' + padded(range(input), 20) + ' ' + padded(input.unit, 5) +
             ' ' + std::string(input.meaning) + '\n';
  }
  return out;
}

std::string list_json() {
  std::string out = "{\n  \"schema\": \"etak-functions/1\",\n  \"functions\": [";
  const char* before = "\n    ";
  for (const Function& function : functions()) {
    out += before + ("{\"id\": " + json_string(function.id)) +
           ", \"returns\": " + json_string(function.returns) +
           ", \"source\": " + json_string(function.source) + ", \"inputs\": [";
    for (const FunctionInput& input : function.inputs) {
      if (&input != function.inputs.data()) out += ", ";
      out += "{\"name\": " + json_string(input.name) + ", \"meaning\": " + json_string(input.meaning) +
             ", \"unit\": " + json_string(input.unit);
      if (input.words.empty()) {
        out += ", \"min\": " + number(input.min, digits) + ", \"max\": " + number(input.max, digits) +
               ", \"above_min\": " + (input.above_min ? "true" : "false");
      } else {
        out += ", \"words\": [";
        for (const std::string_view& word : input.words)
          out += (&word == input.words.data() ? "" : ", ") + json_string(word);
        out += ']';
      }
      out += '}';
    }
    out += "]}";
    before = ",\n    ";
  }
  return out + "\n  ]\n}\n";
}

int run(const EvalArguments& arguments) {
  const bool named = !arguments.function.empty();
  if (named + !arguments.csv.empty() + arguments.list != 1)
    throw Error::at("eval", "not one question", "FUNCTION name=value..., --csv FILE or --list");
  if (arguments.list) {
    write_output(arguments.output, arguments.output.format == "json" ? list_json() : list_text());
    return exit_ok;
  }
  const bool json = arguments.output.format == "json";
  if (!arguments.csv.empty()) {
    if (json) throw Error::at("--format", "json with --csv, which answers with CSV", "text");
    return run_csv(arguments);
  }
  const Function& function = function_named(trimmed(arguments.function), {});
  std::vector<NamedText> inputs;
  for (const std::string& each : arguments.inputs) inputs.push_back(split_input(each, function.id));
  const std::string value = number(evaluate(function, inputs, {}), digits);
  write_output(arguments.output, json ? "{\"schema\": \"etak-eval/1\", \"function\": " +
                                            json_string(function.id) + ", \"value\": " + value + "}\n"
                                      : value + '\n');
  return exit_ok;
}

}  // namespace

void add_eval(CLI::App& app, Verb& chosen) {
  const auto arguments = std::make_shared<EvalArguments>();
  CLI::App& verb =
      *app.add_subcommand("eval", "evaluate one formula, or a table of them, in double precision");
  verb.add_option("FUNCTION", arguments->function, "name of the function, as --list gives it");
  verb.add_option("INPUTS", arguments->inputs, "its inputs, as name=value")->type_name("NAME=VALUE");
  reads_file(verb.add_option("--csv", arguments->csv,
                             "answer the rows id,function,inputs of FILE (inputs as name=value;name=value) "
                             "with id,value; a row that is refused gets \"error\" and its reason on standard "
                             "error"))
      ->type_name("FILE");
  verb.add_flag("--list", arguments->list, "print every function with its inputs, units, ranges and source");
  add_output_options(verb, arguments->output, {"text", "json"});
  verb.footer(
      "Angles theta_*, phi_* are degrees; the normal is +z, the light at azimuth 0.\n"
      "Example:\n  etak eval schueler_ksk theta_l=30 theta_v=40 phi_v=180 K=0.04 g=0.5");
  verb.callback([arguments, &chosen] { chosen = [arguments] { return run(*arguments); }; });
}

}  // namespace etak::cli
