// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/output/output.h"
#include "app/cli/output/replace.h"
#include "app/cli/pictures/pictures.h"
#include "app/cli/verbs.h"
#include "core/pages/stability_report.h"

namespace etak::cli {
namespace {

struct StabilityArguments {
  OutputArguments output;
  std::string device = "cpu";
  bool all = false;
};

int show_stability(const StabilityArguments& arguments) {
  check_output(arguments.output);
  const std::vector<StabilityCase> cases = arguments.device == "cpu" || arguments.device == "auto"
                                               ? stability_cases()
                                               : pictures("--device").stability_on_gl(arguments.device);
  write_output(arguments.output, arguments.output.format == "json" ? stability_json(cases)
                                                                   : stability_text(cases, arguments.all));
  return all_passed(cases) ? exit_ok : exit_findings;
}

}  // namespace

void add_stability(CommandLine& line) {
  Command verb = line.verb("stability", "every stiff and extreme case, run through the real code");
  auto arguments = std::make_shared<StabilityArguments>();
  verb.option("--device", arguments->device,
              "cpu: double and single precision; gl, all: and the formulas on OpenGL; auto: cpu")
      .one_of({"auto", "cpu", "gl", "all"})
      .show_default();
  verb.flag("--all", arguments->all,
            "every case in the text, not only those in which the formula as usually written fails");
  add_output_options(verb, arguments->output, {"text", "json"});
  verb.footer("Exit status: 0 every case as expected, 1 some not.\nExample:\n  etak stability");
  verb.runs([arguments] { return show_stability(*arguments); });
}

}  // namespace etak::cli
