// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/output/form.h"
#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/json/json_text.h"
#include "core/base/memory.h"
#include "core/base/number.h"
#include "core/light/functions_csv.h"
#include "core/pages/lists/lists.h"

namespace etak::cli {
namespace {

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

int run(const EvalArguments& arguments) {
  const bool named = !arguments.function.empty();
  if (named + !arguments.csv.empty() + arguments.list != 1)
    throw Error::at("eval", "not one question", "FUNCTION name=value..., --csv FILE or --list");
  if (arguments.list) {
    write_output(arguments.output, arguments.output.format == "json" ? functions_json() : functions_text());
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
  const std::string value = number(evaluate(function, inputs, {}), 17);
  write_output(
      arguments.output,
      (as_json ? json_object(
                     {{"schema", json("etak-eval/1")}, {"function", json(function.id)}, {"value", value}}, -1)
               : value) +
          '\n');
  return exit_ok;
}

}  // namespace

void add_eval(CommandLine& line) {
  const auto arguments = std::make_shared<EvalArguments>();
  Command verb = line.verb("eval", "evaluate one formula, or a table of them, in double precision");
  verb.option("FUNCTION", arguments->function, "name of the function, as --list gives it").value_name("");
  verb.option("INPUTS", arguments->inputs, "its inputs, as name=value").value_name("NAME=VALUE");
  verb.option(
          "--csv", arguments->csv,
          "answer the rows id,function,inputs of FILE (inputs as name=value;name=value) with id,value; a row that is refused gets \"error\" and its reason on standard error")
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
