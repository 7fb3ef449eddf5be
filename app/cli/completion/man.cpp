// SPDX-License-Identifier: Apache-2.0
#include "app/cli/completion/man.h"

#include <algorithm>

#include "app/cli/completion/kinds.h"
#include "app/cli/usage.h"
#include "core/base/text/ascii.h"
#include "core/base/text/text.h"

namespace etak::cli {
namespace {

// Text of a line: no character of it is a request of roff or a hyphen that a reader could not paste.
std::string roff(std::string_view plain) {
  std::string out;
  for (const char c : plain) out += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

std::string upper(std::string_view plain) {
  std::string out(plain);
  for (char& c : out)
    if (is_lower(c)) c = static_cast<char>(c - 'a' + 'A');
  return out;
}

std::string tag(const OptionRow& option) {
  std::string out;
  for (const std::string& each : option.names)
    out += (out.empty() ? "" : ", ") + ("\\fB" + roff(each) + "\\fR");
  if (!option.value.empty()) {
    const std::string value = option.words.empty() ? option.value : joined(option.words, value_separator);
    out += (out.empty() ? "" : " ") + ("\\fI" + roff(value) + "\\fR");
  }
  if (option.repeats) out += " ...";
  return out;
}

std::string described(const OptionRow& option) {
  std::string out = roff(option.help);
  if (!option.range.empty()) out += " (" + roff(option.range) + ")";
  if (!option.standard.empty()) out += "; default " + roff(option.standard);
  return ".TP\n" + tag(option) + '\n' + out + '\n';
}

std::string options_of(const VerbRow& verb) {
  std::string out, group;
  for (const OptionRow& option : verb.options) {
    const std::string heading = option.names.empty() ? "Arguments" : option.group;
    if (heading != group) out += ".SH " + upper(roff(heading)) + '\n';
    group = heading;
    out += described(option);
  }
  return out;
}

// The lines below the options; what follows "Example:" is a command.
std::string footer_of(const VerbRow& verb) {
  std::string out;
  bool in_example = false;
  for (std::string_view rest = verb.footer; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line == "Example:") {
      out += ".SH EXAMPLE\n.EX\n";
      in_example = true;
    } else {
      out += (out.empty() ? ".SH NOTES\n" : in_example ? "" : ".br\n") + roff(line) + '\n';
    }
  }
  return in_example ? out + ".EE\n" : out;
}

}  // namespace

std::string manual_page(const std::vector<VerbRow>& table, std::string_view verb) {
  const auto found = std::ranges::find(table, verb, &VerbRow::name);
  if (found == table.end()) throw unknown_verb(verb, verb_names(table));
  const bool top = verb.empty();
  const std::string_view title = "etak: ";
  const std::string_view summary =
      std::string_view(found->help).substr(found->help.starts_with(title) ? title.size() : 0);
  const std::string called = top ? "etak" : "etak-" + std::string(verb);
  std::string out = ".TH " + upper(roff(called)) + " 1 \"\" \"etak " ETAK_VERSION "\" \"etak\"\n.SH NAME\n" +
                    roff(called) + " \\- " + roff(summary) + "\n.SH SYNOPSIS\n.B etak" +
                    (top ? "\n.I VERB" : " " + roff(verb)) + "\n[\\fIOPTIONS\\fR]";
  std::vector<std::string> others;
  for (const OptionRow& option : found->options)
    if (option.names.empty()) out += " [\\fI" + roff(option.value) + "\\fR" + (option.repeats ? "...]" : "]");
  out += '\n';
  if (top) {
    out += ".SH VERBS\n";
    for (const VerbRow& each : table)
      if (!each.name.empty()) out += ".TP\n\\fB" + roff(each.name) + "\\fR\n" + roff(each.help) + '\n';
  }
  out += options_of(*found) + footer_of(*found) + ".SH SEE ALSO\n";
  for (const VerbRow& each : table)
    if (each.name != verb)
      others.push_back(".BR " + roff(each.name.empty() ? "etak" : "etak-" + each.name) + " (1)");
  return out + joined(others, ",\n") + '\n';
}

}  // namespace etak::cli
