// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/options/common.h"
#include "app/cli/output/output.h"
#include "app/cli/output/replace.h"
#include "app/cli/verbs.h"
#include "core/base/json/json_text.h"
#include "core/base/text/text_table.h"

namespace etak::cli {
namespace {

int show_config(const OutputArguments& output, Library& library) {
  check_output(output);
  std::vector<std::string> lines;
  std::vector<TextRow> rows{{{"setting", "value", "from"}}};
  for (const InForce& each : in_force(library)) {
    lines.push_back(
        json_object({{"name", json(each.name)}, {"value", json(each.value)}, {"from", json(each.from)}}, -1));
    rows.push_back({{each.name, line_text(each.value), line_text(each.from)}});
  }
  write_output(output, output.format == "json"
                           ? json_document("etak-config/1", {{"settings", json_lines(lines, 2)}})
                           : text_table(rows));
  return exit_ok;
}

}  // namespace

void add_config(CommandLine& line) {
  struct ConfigArguments {
    OutputArguments output;
    Library library;
  };
  const auto arguments = std::make_shared<ConfigArguments>();
  Command verb = line.verb("config", "what configuration is in force here, and where it comes from");
  add_library_options(verb, arguments->library);
  add_output_options(verb, arguments->output, {"text", "json"});
  verb.footer("Example:\n  etak config");
  verb.runs([arguments] { return show_config(arguments->output, arguments->library); });
}

}  // namespace etak::cli
