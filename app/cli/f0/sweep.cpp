// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "app/cli/f0/run.h"
#include "core/base/error.h"
#include "core/material/names.h"
#include "core/pages/f0/film.h"
#include "core/pages/f0/report.h"

namespace etak::cli {

int answer_film_sweep(F0Arguments& arguments, const F0Job& job) {
  const OutputArguments& output = arguments.output;
  if (output.format == "html" || !arguments.sort.empty() || arguments.compute.axis_average)
    throw Error::at("--sweep", "beside --format html, --sort or --axis-average",
                    "rows over thickness, or --format svg");
  if (arguments.inputs.names.size() != 1 || arguments.inputs.all || !arguments.files_from.empty())
    throw Error::at("--sweep", "not one input", "one stack, such as anatase:40nm/titanium");
  const LibraryWhenAsked library = arguments.library.when_asked();
  const std::vector<MaterialInput> inputs = find_inputs(arguments.inputs, library, 1);
  if (inputs.size() != 1) throw Error::at("--sweep", "not one dataset", "one stack");
  const Material material = read_material(inputs[0], job.tables);
  const Dataset& dataset = dataset_named(material, inputs[0].dataset, inputs[0].label());
  const auto* stack = std::get_if<Stack>(&dataset.optics);
  if (stack == nullptr)
    throw Error::at("--sweep", inputs[0].label() + " has no layers",
                    "a stack, such as anatase:40nm/titanium");
  const FilmSweep sweep = film_sweep(*stack, arguments.sweep);
  const F0Options& options = job.solver.options();
  if (output.format == "svg") {
    write_output(output, film_strip(sweep, options));
    return exit_ok;
  }
  const std::vector<F0Row> rows = film_rows(sweep, job.solver, material, dataset);
  std::string text = output.format == "csv"     ? film_csv(sweep, rows)
                     : output.format == "json"  ? f0_json(rows, options)
                     : output.format == "jsonl" ? f0_jsonl(rows, options)
                                                : f0_table(rows, options, use_color(output));
  write_output(output, text);
  const bool refused =
      std::any_of(rows.begin(), rows.end(), [](const F0Row& row) { return row.result.refused(); });
  return refused ? exit_findings : exit_ok;
}

}  // namespace etak::cli
