// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/output/replace.h"
#include "app/cli/verbs.h"
#include "core/pages/lists/sources.h"

namespace etak::cli {
namespace {

int show_sources(const OutputArguments& output) {
  check_output(output);
  const std::vector<SourceRow> rows = source_rows(MaterialLibrary::builtin());
  write_output(output, output.format == "json"       ? sources_json(rows)
                       : output.format == "csv"      ? sources_csv(rows)
                       : output.format == "markdown" ? sources_markdown(rows)
                                                     : sources_table(rows));
  return exit_ok;
}

}  // namespace

void add_sources(CommandLine& line) {
  Command verb = line.verb("sources", "every printed row of etak's three sources, with etak's value");
  const auto output = std::make_shared<OutputArguments>();
  add_output_options(verb, *output, {"table", "csv", "json", "markdown"});
  verb.footer("Example:\n  etak sources");
  verb.runs([output] { return show_sources(*output); });
}

}  // namespace etak::cli
