// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/pages/lists/lists.h"

namespace etak::cli {

void add_models(CommandLine& line) {
  struct ModelsArguments {
    std::string search;
    OutputArguments output;
  };
  const auto arguments = std::make_shared<ModelsArguments>();
  Command verb =
      line.verb("models", "shading models, their terms and the kinds of light, with what they claim");
  verb.option("TEXT", arguments->search, "only what has TEXT in id, kind or title, such as ggx or transfer")
      .value_name("");
  add_output_options(verb, arguments->output, {"table", "json", "csv"});
  verb.footer("Example:\n  etak models --format csv");
  verb.runs([arguments] {
    const auto& [search, output] = *arguments;
    write_output(output, output.format == "json" ? models_json(search)
                         : output.format == "csv"
                             ? models_csv(search)
                             : models_table(!output.quiet, search));  // the legend is no data
    return exit_ok;
  });
}

}  // namespace etak::cli
