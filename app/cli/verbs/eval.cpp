// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/output/form.h"
#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/json_text.h"
#include "core/base/memory.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "core/light/functions.h"
#include "core/light/functions_csv.h"

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

int run_csv(const EvalArguments& arguments) {
  const std::string text = read_file(arguments.csv);
  const CsvAnswers answers = with_memory_for(
      arguments.csv, [&] { return "the answers to its " + mebibytes(text.size()); },
      [&] { return answer_csv(text, arguments.csv, complain); });
  write_output(arguments.output, answers.text);
  remark(arguments.output,
         std::to_string(answers.rows) + " rows, " + std::to_string(answers.refused) + " refused");
  return exit_ok;
}

// ---- --list

std::string range(const FunctionInput& input) {
  if (!input.words.empty()) return joined(input.words, "|");
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
    out += before + ("{\"id\": " + json(function.id)) + ", \"returns\": " + json(function.returns) +
           ", \"source\": " + json(function.source) + ", \"inputs\": [";
    for (const FunctionInput& input : function.inputs) {
      if (&input != function.inputs.data()) out += ", ";
      out += "{\"name\": " + json(input.name) + ", \"meaning\": " + json(input.meaning) +
             ", \"unit\": " + json(input.unit);
      if (input.words.empty()) {
        out += ", \"min\": " + number(input.min, digits) + ", \"max\": " + number(input.max, digits) +
               ", \"above_min\": " + (input.above_min ? "true" : "false");
      } else {
        out += ", \"words\": " + json_array_of(input.words);
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
  const bool as_json = arguments.output.format == "json";
  if (!arguments.csv.empty()) {
    if (as_json) refuse_form(arguments.output, "etak eval", "with --csv, which answers with CSV", {"text"});
    return run_csv(arguments);
  }
  const Function& function = function_named(arguments.function, {});
  std::vector<NamedText> inputs;
  for (const std::string& each : arguments.inputs) inputs.push_back(split_input(each, function.id));
  const std::string value = number(evaluate(function, inputs, {}), digits);
  write_output(arguments.output, as_json ? "{\"schema\": \"etak-eval/1\", \"function\": " +
                                               json(function.id) + ", \"value\": " + value + "}\n"
                                         : value + '\n');
  return exit_ok;
}

}  // namespace

void add_eval(CommandLine& line) {
  const auto arguments = std::make_shared<EvalArguments>();
  Command verb = line.verb("eval", "evaluate one formula, or a table of them, in double precision");
  verb.option("FUNCTION", arguments->function, "name of the function, as --list gives it");
  verb.option("INPUTS", arguments->inputs, "its inputs, as name=value").value_name("NAME=VALUE");
  verb.option("--csv", arguments->csv,
              "answer the rows id,function,inputs of FILE (inputs as name=value;name=value) "
              "with id,value; a row that is refused gets \"error\" and its reason on standard "
              "error")
      .reads_file()
      .value_name("FILE");
  verb.flag("--list", arguments->list, "print every function with its inputs, units, ranges and source");
  add_output_options(verb, arguments->output, {"text", "json"});
  verb.footer(
      "Angles theta_*, phi_* are degrees; the normal is +z, the light at azimuth 0.\n"
      "Example:\n  etak eval schueler_ksk theta_l=30 theta_v=40 phi_v=180 K=0.04 g=0.5");
  verb.runs([arguments] { return run(*arguments); });
}

}  // namespace etak::cli
