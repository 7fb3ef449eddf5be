// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/options/options.h"
#include "app/cli/output/progress.h"
#include "app/cli/pictures/choose.h"
#include "app/cli/pictures/pictures.h"
#include "app/cli/verbs.h"

namespace etak::cli {

void add_choose(CommandLine& line) {
  Command verb = line.verb("choose", "the cheapest way to draw a material within a budget of error");
  auto arguments = std::make_shared<ChooseArguments>();
  verb.option(
          "what", arguments->materials,
          "a scene (glTF, pack manifest or folder of pictures), or materials of the library: ID or ID/DATASET")
      .reads_file()
      .value_name("SCENE|MATERIAL");
  verb.flag("--all", arguments->all, "every material of the library that has n and k");
  verb.option("--budget", arguments->budget,
              "largest difference of F at any angle and of any pixel, CIEDE2000; 0: the least there is")
      .show_default();
  verb.flag("--codes", arguments->codes, "the budget is in 8-bit sRGB codes of the worst channel");
  verb.option("--dataset", arguments->dataset, "dataset of each material instead of the preferred one")
      .value_name("ID");
  for (const char* option : {"--illuminant", "--observer", "--space", "--outside", "--axis-average"})
    verb.refuse(option, "a choice is for one n and k in air, in linear sRGB under D65 and the 1931 observer",
                std::string("etak f0 with ") + option);
  verb.refuse("--method,--integration", "etak choose itself finds the cheapest within --budget", "no method");
  add_table_options(verb, arguments->tables);
  add_roughness_options(verb, arguments->rough, "of a library material's sphere that is compared");
  const Option measure =
      verb.flag("--measure", arguments->measure,
                "time everything here (a minute) instead of taking the shipped costs; the choice may differ");
  verb.option("--costs", arguments->costs, "a cost table of --write-costs instead of the shipped one")
      .reads_file()
      .excludes(measure)
      .value_name("FILE");
  verb.flag("--write-costs", arguments->write_costs, "write the cost table itself, measured here");
  add_library_options(verb, arguments->library);
  add_follow_links(verb);
  add_thread_option(verb, arguments->threads);
  add_output_options(verb, arguments->output, {"text", "json"});
  add_progress_option(verb, arguments->output.progress);
  verb.footer(
      "The JSON form is what etak shader and etak pack take as --choice.\n"
      "Example:\n  etak choose gold silver water --budget 1");
  verb.runs([arguments] { return pictures("etak choose").choose_materials(*arguments); });
}

}  // namespace etak::cli
