// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/options/options.h"
#include "app/cli/output/progress.h"
#include "app/cli/pictures/pictures.h"
#include "app/cli/pictures/report.h"
#include "app/cli/verbs.h"

namespace etak::cli {

void add_report(CommandLine& line) {
  Command verb = line.verb("report", "error against run time of every shortcut");
  auto arguments = std::make_shared<ReportArguments>();
  verb.option("--family", arguments->families,
              "only these, such as fresnel,transfer; see the page for the names")
      .separated_by(',')
      .value_name("FAMILY,...");
  verb.option("-o,--output", arguments->folder,
              "folder for report.html, report.json, report.csv and a plot per table")
      .required()
      .value_name("DIR");
  const Option quick =
      verb.flag("--quick", arguments->quick, "coarser grids, fewer repeats: under a minute (the default)");
  verb.flag("--full", arguments->full, "the whole grids and repeats: some minutes").excludes(quick);
  verb.option("--device", arguments->device, "what pictures are timed on; auto: cpu")
      .one_of({"auto", "cpu", "gl", "all"})
      .show_default();
  verb.flag("--force", arguments->force, "replace an earlier report; ETAK_FORCE=1 says the same");
  verb.flag("-q,--quiet", arguments->quiet, "no remarks and no progress");
  add_progress_option(verb, arguments->progress);
  add_thread_option(verb, arguments->threads);
  verb.footer(
      "Errors are the same in every run; times are of this machine, median and quartiles of interleaved repeats.\n"
      "Example:\n  etak report --family transfer -o report");
  verb.runs([arguments] { return pictures("etak report").measure(*arguments); });
}

}  // namespace etak::cli
