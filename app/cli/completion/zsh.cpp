// SPDX-License-Identifier: Apache-2.0
#include "app/cli/completion/kinds.h"
#include "app/cli/completion/shells.h"
#include "core/base/text/text.h"

namespace etak::cli {
namespace {

// `text` inside single quotes, with a '\' before each of `special`.
std::string quoted(std::string_view text, std::string_view special) {
  std::string out;
  for (const char c : text) {
    if (special.find(c) != special.npos) out += '\\';
    out += c == '\'' ? "'\\''" : c == '\n' ? " " : std::string(1, c);
  }
  return out;
}

// ":VALUE:ACTION" of _arguments.
std::string value_of(const OptionRow& option) {
  if (option.value.empty()) return "";
  const std::string shown = ":" + quoted(option.value, ":\\") + ":";
  if (!option.words.empty()) return shown + "(" + joined(option.words, " ") + ")";
  const std::string kind(completes(option));
  return shown + (kind.empty()        ? ""
                  : kind == "files"   ? "_files"
                  : kind == "folders" ? "_files -/"
                                      : "{_etak_names " + kind + "}");
}

// The specifications of _arguments: one for each name of an option, which exclude each other.
std::string specifications(const OptionRow& option) {
  if (option.names.empty())
    return std::string(" \\\n        '") + (option.repeats ? "*" : "") + value_of(option) + "'";
  std::string out;
  for (const std::string& each : option.names) {
    const std::string once = option.repeats ? "*" : "(" + joined(option.names, " ") + ")";
    out += " \\\n        '" + once + each + "[" + quoted(option.help, "[]\\") + "]" + value_of(option) + "'";
  }
  return out;
}

constexpr const char* zsh_begin = R"sh(#compdef etak
# zsh completion of etak; made by: etak completion zsh
_etak_names() {
  # The value may be a list with ',' between: its last name is completed.
  compset -P '*,'
  local -a found
  found=(${(f)"$(etak completion --words $1 2>/dev/null)"})
  compadd -a found
  [[ $1 = materials ]] && _files
}
_etak() {
  local curcontext=$curcontext state line
  typeset -A opt_args
  local -a verbs
  verbs=(
)sh";

constexpr const char* zsh_choice = R"sh( \
        '1: :->verb' \
        '*:: :->rest'
  case $state in
    verb) _describe verb verbs; return ;;
    rest) ;;
    *) return ;;
  esac
  case $words[1] in
)sh";

constexpr const char* zsh_end = R"sh(  esac
}
[[ $funcstack[1] = _etak ]] && _etak "$@" || compdef _etak etak
)sh";

}  // namespace

std::string zsh_completion(const std::vector<VerbRow>& table) {
  std::string verbs, cases, top;
  for (const VerbRow& verb : table) {
    std::string all;
    for (const OptionRow& option : verb.options) all += specifications(option);
    if (verb.name.empty()) {
      top = all;
      continue;
    }
    verbs += "    '" + verb.name + ":" + quoted(verb.help, ":\\") + "'\n";
    cases += "    " + verb.name + ")\n      _arguments -s" + all + "\n      ;;\n";
  }
  return zsh_begin + verbs + "  )\n  _arguments -C" + top + zsh_choice + cases + zsh_end;
}

}  // namespace etak::cli
