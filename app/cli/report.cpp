// SPDX-License-Identifier: Apache-2.0
#include "app/cli/report.h"

#include <memory>

#include "app/cli/options.h"
#include "app/cli/pictures.h"
#include "app/cli/progress.h"
#include "app/cli/replace.h"
#include "app/cli/verbs.h"
#include "core/pages/stability_report.h"

namespace etak::cli {
namespace {

int show_stability(const StabilityArguments& arguments) {
  check_output(arguments.output);
  const std::vector<StabilityCase> cases =
      arguments.device == "cpu" ? stability_cases() : pictures("--device").stability_on_gl(arguments.device);
  write_output(arguments.output,
               arguments.output.format == "json" ? stability_json(cases) : stability_text(cases));
  return all_passed(cases) ? exit_ok : exit_findings;
}

}  // namespace

void add_report(CommandLine& line) {
  Command verb = line.verb("report", "Measure error against run time of every shortcut");
  auto arguments = std::make_shared<ReportArguments>();
  verb.option("--family", arguments->families,
              "only these, such as fresnel,transfer; see the page for the names")
      .separated_by(',')
      .value_name("NAME");
  verb.option("-o,--output", arguments->folder,
              "folder for report.html, report.json, report.csv and a plot per table")
      .required()
      .value_name("DIR");
  const Option quick =
      verb.flag("--quick", arguments->quick, "coarser grids, fewer repeats: under a minute (the default)");
  verb.flag("--full", arguments->full, "the whole grids and repeats: some minutes").excludes(quick);
  verb.option("--device", arguments->device, "what pictures are timed on")
      .one_of({"cpu", "gl", "all"})
      .show_default();
  verb.flag("--force", arguments->force, "replace an earlier report; ETAK_FORCE=1 says the same");
  verb.flag("-q,--quiet", arguments->quiet, "no remarks and no progress");
  add_progress_option(verb, arguments->progress);
  add_thread_option(verb, arguments->threads);
  verb.footer(
      "Errors are the same in every run; times are of this machine, median and quartiles of interleaved "
      "repeats.\n"
      "Example:\n  etak report --family transfer -o report");
  verb.runs([arguments] { return pictures("etak report").measure(*arguments); });
}

void add_stability(CommandLine& line) {
  Command verb = line.verb("stability", "Run every stiff and extreme case through the real code");
  auto arguments = std::make_shared<StabilityArguments>();
  verb.option("--device", arguments->device,
              "cpu: double and single precision; gl, all: and the formulas on OpenGL")
      .one_of({"cpu", "gl", "all"})
      .show_default();
  add_output_options(verb, arguments->output, {"text", "json"});
  verb.footer("Exit status: 0 every case as expected, 1 some not.\nExample:\n  etak stability");
  verb.runs([arguments] { return show_stability(*arguments); });
}

}  // namespace etak::cli
