// SPDX-License-Identifier: Apache-2.0
#include "app/cli/completion/kinds.h"
#include "app/cli/completion/shells.h"
#include "core/base/text/text.h"

namespace etak::cli {
namespace {

// The command that offers what may stand for the option's value; empty where nothing is known of it.
std::string bash_offer(const OptionRow& option) {
  if (!option.words.empty()) return "_etak_words '" + joined(option.words, " ") + "'";
  const std::string kind(completes(option));
  if (kind.empty()) return "";
  if (kind == "files" || kind == "folders") return "_etak_" + kind;
  return "_etak_names " + kind + (kind == "materials" ? "; _etak_files" : "");
}

constexpr const char* bash_begin = R"sh(# bash completion of etak; made by: etak completion bash
_etak_words() {
  # The value may be a list with ',' between: its last name is completed.
  local begun=
  case $word in *,*) begun=${word%,*}, ;; esac
  COMPREPLY+=($(compgen -P "$begun" -W "$1" -- "${word##*,}"))
}
_etak_names() { _etak_words "$("${COMP_WORDS[0]}" completion --words "$1" 2>/dev/null)"; }
_etak_files() {
  local IFS=$'\n'
  compopt -o filenames 2>/dev/null
  COMPREPLY+=($(compgen -f -- "$word"))
}
_etak_folders() {
  local IFS=$'\n'
  compopt -o filenames 2>/dev/null
  COMPREPLY+=($(compgen -d -- "$word"))
}
_etak() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} verb= i
  COMPREPLY=()
  # bash takes "--format=csv" for three words.
  if [ "$word" = = ]; then
    word=
  elif [ "$before" = = ]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  for ((i = 1; i < COMP_CWORD; i++)); do
    case ${COMP_WORDS[i]} in -*) ;; *) verb=${COMP_WORDS[i]}; break ;; esac
  done
  case $verb:$before in
)sh";

constexpr const char* bash_end = R"sh(  esac
}
complete -F _etak etak
)sh";

}  // namespace

std::string bash_completion(const std::vector<VerbRow>& table) {
  std::string values, options, arguments;
  for (const VerbRow& verb : table) {
    std::vector<std::string> all;
    for (const OptionRow& option : verb.options) {
      const std::string offered = bash_offer(option);
      if (option.names.empty()) {
        if (!offered.empty()) arguments += "    " + verb.name + ") " + offered + " ;;\n";
        continue;
      }
      all.insert(all.end(), option.names.begin(), option.names.end());
      if (option.value.empty()) continue;
      std::vector<std::string> places;
      for (const std::string& each : option.names) places.push_back(verb.name + ":" + each);
      values += "    " + joined(places, "|") + ") " + offered + (offered.empty() ? "" : "; ") + "return ;;\n";
    }
    const std::string shown = verb.name.empty() ? "''" : verb.name;
    options += "        " + shown + ") _etak_words '" + joined(all, " ") + "' ;;\n";
  }
  return bash_begin + values + "  esac\n  case $word in\n    -*)\n      case $verb in\n" + options +
         "      esac\n      return ;;\n  esac\n  case $verb in\n    '') _etak_names verbs ;;\n" + arguments +
         bash_end;
}

}  // namespace etak::cli
