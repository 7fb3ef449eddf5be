// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/base/system.h"
#include "core/findings/output/explain.h"
#include "core/judge/rules.h"
#include "core/validate/config.h"

namespace etak::cli {
namespace {

struct ExplainArguments {
  std::vector<std::string> ids;
  OutputArguments output;
};

int run(const ExplainArguments& arguments) {
  std::vector<const Rule*> meant;
  for (const std::string& id : arguments.ids) {
    const auto found = rules_with_prefix(id);
    if (found.empty()) unknown_rule("etak explain", id);
    meant.insert(meant.end(), found.begin(), found.end());
  }
  std::string out;
  if (arguments.output.format == "json") {
    out = rules_json(meant);
  } else {
    for (const Rule* rule : meant) {
      if (!out.empty()) out += '\n';
      out += arguments.output.format == "markdown" ? explanation_markdown(*rule)
                                                   : explanation(*rule, columns_of(sys::standard_output));
    }
  }
  write_output(arguments.output, out);
  return exit_ok;
}

}  // namespace

void add_explain(CommandLine& line) {
  const auto arguments = std::make_shared<ExplainArguments>();
  Command verb = line.verb("explain", "what a rule of etak validate says, why, and how to mend it");
  verb.option("id", arguments->ids, "ids such as ETK101, prefixes such as ETK1, or slugs")
      .value_name("RULE")
      .required();
  add_output_options(verb, arguments->output, {"text", "markdown", "json"});
  verb.footer("Example:\n  etak explain ETK101");
  verb.runs([arguments] { return run(*arguments); });
}

}  // namespace etak::cli
