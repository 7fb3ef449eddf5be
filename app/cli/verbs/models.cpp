// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/pages/lists/lists.h"

namespace etak::cli {

void add_models(CommandLine& line) {
  const auto output = std::make_shared<OutputArguments>();
  Command verb =
      line.verb("models", "shading models, their terms and the kinds of light, with what they claim");
  add_output_options(verb, *output, {"table", "json", "csv"});
  verb.footer("Example:\n  etak models --format csv");
  verb.runs([output] {
    write_output(*output, output->format == "json"  ? models_json()
                          : output->format == "csv" ? models_csv()
                                                    : models_table(!output->quiet));  // the legend is no data
    return exit_ok;
  });
}

}  // namespace etak::cli
