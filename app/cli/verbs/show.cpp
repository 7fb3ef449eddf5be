// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include "app/cli/inputs/inputs.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/material/names.h"
#include "core/material/quality.h"
#include "core/pages/f0/report.h"

namespace etak::cli {
namespace {

struct ShowArguments {
  InputNames inputs;
  F0Settings compute;
  TableSettings tables;
  OutputArguments output;
  Library library;
};

// The ids of the datasets that the inputs name; empty, which stands for all, where an input is a whole
// material.
std::vector<std::string> named_datasets(const std::vector<MaterialInput>& inputs) {
  std::vector<std::string> out;
  for (const MaterialInput& input : inputs) {
    if (input.dataset.empty()) return {};
    out.push_back(input.material ? dataset_named(*input.material, input.dataset, input.label()).id
                                 : input.dataset);
  }
  return out;
}

// The record of the material, followed by the policy unless -q is given.
std::string text_form(const MaterialReport& report, const std::vector<MaterialInput>& inputs,
                      const F0Solver& solver, const OutputArguments& output) {
  const std::string out = record_text(report, solver, named_datasets(inputs), use_color(output));
  return output.quiet ? out : out + "\nF0: " + line_text(policy(solver.options())) + '\n';
}

int run(ShowArguments& arguments) {
  if (arguments.inputs.names.size() != 1)
    throw Error::at("etak show", std::to_string(arguments.inputs.names.size()) + " inputs",
                    "one material or file");
  const F0Solver solver(f0_options(arguments.compute, arguments.library));
  const TableOptions tables = table_options(arguments.tables);
  const std::vector<MaterialInput> inputs = find_inputs(arguments.inputs, arguments.library.when_asked(), 1);
  for (const std::string& each : alias_remarks(inputs)) remark(arguments.output, each);
  // "gold/*" gives several inputs, which are datasets of one material.
  const bool one =
      inputs.size() == 1 ||
      (!inputs.empty() && std::all_of(inputs.begin(), inputs.end(), [&](const MaterialInput& input) {
        return input.material && input.material == inputs.front().material;
      }));
  if (!one || inputs.front().from_folder)
    throw Error::at(arguments.inputs.names.front(), "is a folder", "one material or file");
  MaterialReport report{read_material(inputs.front(), tables), {}, arguments.compute.axis_average};
  for (const Dataset& dataset : report.material.datasets)
    report.results.push_back(
        solve_averaged(arguments.compute.axis_average, solver, report.material, dataset));
  write_output(arguments.output, arguments.output.format == "json"
                                     ? record_json(report, solver)
                                     : text_form(report, inputs, solver, arguments.output));
  return exit_ok;
}

}  // namespace

void add_show(CommandLine& line) {
  const auto arguments = std::make_shared<ShowArguments>();
  Command verb = line.verb("show", "the whole record of one material; ID/DATASET lists one dataset");
  add_input_options(verb, arguments->inputs);
  verb.option("--dataset", arguments->inputs.dataset, "only this dataset of the material").value_name("ID");
  add_compute_options(verb, arguments->compute);
  add_table_options(verb, arguments->tables);
  add_library_options(verb, arguments->library);
  add_output_options(verb, arguments->output, {"text", "json"});
  verb.footer("Example:\n  etak show iron");
  verb.runs([arguments] { return run(*arguments); });
}

}  // namespace etak::cli
