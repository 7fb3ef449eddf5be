// SPDX-License-Identifier: Apache-2.0
#include "app/cli/choose.h"
#include "app/cli/image_program.h"
#include "app/cli/report.h"
#include "core/pages/stability_report.h"

namespace etak::cli {

int measure(ReportArguments&) {
  become_image_program("etak report", "the program that measures is missing",
                       "an etak built with Google Benchmark, OpenImageIO and OpenColorIO");
}

int choose_materials(ChooseArguments&) {
  become_image_program("etak choose", "the program that measures is missing",
                       "an etak built with Google Benchmark, OpenImageIO and OpenColorIO");
}

int show_stability(StabilityArguments& arguments) {
  if (arguments.device != "cpu")
    become_image_program("etak stability --device " + arguments.device, "the program that draws is missing",
                         "an etak built with OpenGL, OpenImageIO and OpenColorIO");
  const auto cases = stability_cases();
  write_output(arguments.output,
               arguments.output.format == "json" ? stability_json(cases) : stability_text(cases));
  return all_passed(cases) ? exit_ok : exit_findings;
}

}  // namespace etak::cli
