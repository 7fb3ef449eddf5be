// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/completion/kinds.h"
#include "app/cli/completion/shells.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/text/text.h"

namespace etak::cli {
namespace {

struct CompletionArguments {
  std::string shell, words;
  Library library;
  OutputArguments output;
};

int run(CompletionArguments& arguments, const std::vector<VerbRow>& table) {
  if (arguments.shell.empty() == arguments.words.empty())
    throw Error::at("etak completion", "not one question", "bash, zsh or fish, or --words KIND");
  write_output(arguments.output,
               !arguments.words.empty()
                   ? joined(names_of(arguments.words, table, arguments.library), "\n") + '\n'
               : arguments.shell == "bash" ? bash_completion(table)
               : arguments.shell == "zsh"  ? zsh_completion(table)
                                           : fish_completion(table));
  return exit_ok;
}

}  // namespace

void add_completion(CommandLine& line) {
  const auto arguments = std::make_shared<CompletionArguments>();
  Command verb = line.verb("completion", "the script by which a shell completes what follows etak");
  verb.option("SHELL", arguments->shell, "whose script").one_of({"bash", "zsh", "fish"});
  verb.option("--words", arguments->words,
              "print the names that etak knows, one a line: what the scripts ask for")
      .words(named_kinds());
  add_library_options(verb, arguments->library);
  add_output_options(verb, arguments->output, {"text"});
  verb.footer(
      "bash: etak completion bash >~/.local/share/bash-completion/completions/etak\n"
      "zsh: etak completion zsh >DIR/_etak, where DIR is in $fpath\n"
      "fish: etak completion fish >~/.config/fish/completions/etak.fish\n"
      "An installed etak brings them along.\n"
      "Example:\n  etak completion bash");
  // The table is asked for when the verb runs: all verbs are there by then.
  verb.runs([arguments, &line] { return run(*arguments, line.table()); });
}

}  // namespace etak::cli
