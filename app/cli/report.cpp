// SPDX-License-Identifier: Apache-2.0
#include "app/cli/report.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>

#include "app/cli/options.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"

namespace etak::cli {

void add_report(CLI::App& app, Verb& chosen) {
  auto* verb = app.add_subcommand("report", "Measure error against run time of every shortcut");
  auto arguments = std::make_shared<ReportArguments>();
  verb->add_option("--family", arguments->families,
                   "only these, such as fresnel,transfer; see the page for the names")
      ->delimiter(',')
      ->type_name("NAME");
  verb->add_option("-o,--output", arguments->folder,
                   "folder for report.html, report.json, report.csv and a plot per table")
      ->required()
      ->type_name("DIR");
  auto* quick = verb->add_flag("--quick", arguments->quick,
                               "coarser grids, fewer repeats: under a minute (the default)");
  verb->add_flag("--full", arguments->full, "the whole grids and repeats: some minutes")->excludes(quick);
  verb->add_option("--device", arguments->device, "what pictures are timed on")
      ->check(CLI::IsMember({"cpu", "gl", "all"}))
      ->capture_default_str();
  verb->add_flag("--force", arguments->force, "replace an earlier report; ETAK_FORCE=1 says the same");
  verb->add_flag("-q,--quiet", arguments->quiet, "no remarks and no progress");
  add_progress_option(*verb, arguments->progress);
  add_thread_option(*verb, arguments->threads);
  verb->footer(
      "Errors are the same in every run; times are of this machine, median and quartiles of interleaved "
      "repeats.\n"
      "Example:\n  etak report --family transfer -o report");
  verb->callback([arguments, &chosen] { chosen = [arguments] { return measure(*arguments); }; });
}

void add_stability(CLI::App& app, Verb& chosen) {
  auto* verb = app.add_subcommand("stability", "Run every stiff and extreme case through the real code");
  auto arguments = std::make_shared<StabilityArguments>();
  verb->add_option("--device", arguments->device,
                   "cpu: double and single precision; gl, all: and the formulas on OpenGL")
      ->check(CLI::IsMember({"cpu", "gl", "all"}))
      ->capture_default_str();
  add_output_options(*verb, arguments->output, {"text", "json"});
  verb->footer("Exit status: 0 every case as expected, 1 some not.\nExample:\n  etak stability");
  verb->callback([arguments, &chosen] { chosen = [arguments] { return show_stability(*arguments); }; });
}

}  // namespace etak::cli
