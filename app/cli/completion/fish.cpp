// SPDX-License-Identifier: Apache-2.0
#include "app/cli/completion/kinds.h"
#include "app/cli/completion/shells.h"
#include "core/base/text/text.h"

namespace etak::cli {
namespace {

std::string fish_word(std::string_view text) {
  std::string out = "'";
  for (const char c : text)
    out += c == '\'' || c == '\\' ? std::string{'\\', c} : std::string(1, c == '\n' ? ' ' : c);
  return out + "'";
}

// What may stand for the value: the flags of complete(1) of fish.
std::string fish_offer(const OptionRow& option) {
  if (!option.words.empty()) return " -x -a " + fish_word(joined(option.words, " "));
  const std::string kind(completes(option)), words = "etak completion --words " + kind;
  if (kind.empty()) return " -x";
  if (kind == "files") return " -r -F";
  if (kind == "folders") return " -x -a '(__fish_complete_directories)'";
  if (kind == "materials") return " -r -F -a " + fish_word("(" + words + ")");
  return " -x -a " +
         fish_word(is_list(option) ? "(__fish_complete_list , " + fish_word(words) + ")" : "(" + words + ")");
}

}  // namespace

std::string fish_completion(const std::vector<VerbRow>& table) {
  std::string out = "# fish completion of etak; made by: etak completion fish\ncomplete -c etak -f\n";
  for (const VerbRow& verb : table) {
    const std::string when =
        verb.name.empty() ? "__fish_use_subcommand" : "'__fish_seen_subcommand_from " + verb.name + "'";
    const std::string line = "complete -c etak -n " + when;
    if (!verb.name.empty())
      out +=
          "complete -c etak -n __fish_use_subcommand -a " + verb.name + " -d " + fish_word(verb.help) + '\n';
    for (const OptionRow& option : verb.options) {
      if (option.names.empty()) {
        if (const std::string offered = fish_offer(option); offered != " -x") out += line + offered + '\n';
        continue;
      }
      std::string names;
      for (const std::string& each : option.names)
        names += each.starts_with("--") ? " -l " + each.substr(2) : " -s " + each.substr(1);
      out += line + names + (option.value.empty() ? "" : fish_offer(option)) + " -d " +
             fish_word(option.help) + '\n';
    }
  }
  return out;
}

}  // namespace etak::cli
