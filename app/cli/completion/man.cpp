// SPDX-License-Identifier: Apache-2.0
#include "app/cli/completion/shells.h"

#include <algorithm>
#include <utility>

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

// The page of a verb among the documents (resources/doc/verbs), in Markdown; empty where it has none.
std::string_view document_of(std::string_view verb) {
  static constexpr std::pair<std::string_view, std::string_view> pages[] = {
#include "verb_pages.inc"
  };
  for (const auto& [name, text] : pages)
    if (name == verb) return text;
  return {};
}

// A paragraph of Markdown without the marks of code, and without where its links lead to.
std::string without_marks(std::string_view paragraph) {
  std::string out;
  for (std::size_t at = 0; at < paragraph.size(); ++at) {
    const char c = paragraph[at];
    if (c == ']' && paragraph.substr(at).starts_with("]("))
      at = std::min(paragraph.find(')', at), paragraph.size());
    else if (c != '`' && c != '[' && c != '*')
      out += c;
  }
  return out;
}

// What the document tells before its first heading, and the commands that it shows.
struct Told {
  std::string description, examples;
};

Told told_by(std::string_view document) {
  Told out;
  bool heading = false, paragraph = false;
  for (std::string_view rest = document; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    heading = heading || line.starts_with("## ");
    if (line.starts_with("    $ ")) out.examples += roff(line.substr(6)) + '\n';
    const bool plain =
        !line.empty() && !heading && std::string_view(" #|-!`").find(line[0]) == std::string_view::npos;
    if (plain && !paragraph && !out.description.empty()) out.description += ".PP\n";
    if (plain) out.description += roff(without_marks(line)) + '\n';
    paragraph = plain;
  }
  return out;
}

// The sections of every page that tell what of the environment etak reads, and its files.
constexpr std::string_view environment_and_files =
    ".SH ENVIRONMENT\n"
    ".TP\n\\fBETAK_LIBRARY\\fR\na folder of materials that is laid over the library, as \\-\\-library does\n"
    ".TP\n\\fBETAK_FORCE\\fR\n1: outputs may replace files, as \\-\\-force does\n"
    ".TP\n\\fBOCIO\\fR\nthe OpenColorIO configuration, as \\-\\-ocio does\n"
    ".TP\n\\fBNO_COLOR\\fR\nno colours on a terminal\n"
    ".TP\n\\fBCOLUMNS\\fR\nthe width of a terminal\n"
    ".SH FILES\n"
    ".TP\n\\fI$XDG_CONFIG_HOME/etak/config.toml\\fR\nthe user's settings; else in \\fI~/.config\\fR\n"
    ".TP\n\\fIetak.toml\\fR\na project's settings of the validator, searched from the inputs upwards\n";

// The lines below the options; what follows "Example:" is a command.
//   examples   commands that stand instead of those of the footer, where there are any
std::string footer_of(const VerbRow& verb, const std::string& examples) {
  std::string out;
  bool in_example = false;
  for (std::string_view rest = verb.footer; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line == "Example:") {
      if (!examples.empty()) break;
      out += ".SH EXAMPLES\n.EX\n";
      in_example = true;
    } else {
      out += (out.empty() ? ".SH NOTES\n" : in_example ? "" : ".br\n") + roff(line) + '\n';
    }
  }
  if (!examples.empty()) return out + ".SH EXAMPLES\n.EX\n" + examples + ".EE\n";
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
  const auto [description, examples] = told_by(document_of(verb));
  out += '\n';
  if (!description.empty()) out += ".SH DESCRIPTION\n" + description;
  if (top) {
    append(
        out,
        ".SH DESCRIPTION\netak turns measured n and k into what renderers take: F0 as a colour, materials for ",
        "other programs, textures on shared pages, and findings about what in textures cannot be real. Each ",
        "verb has a page of its own.\n.SH VERBS\n");
    for (const VerbRow& each : table)
      if (!each.name.empty()) out += ".TP\n\\fB" + roff(each.name) + "\\fR\n" + roff(each.help) + '\n';
  }
  append(out, options_of(*found), footer_of(*found, examples), environment_and_files, ".SH SEE ALSO\n");
  for (const VerbRow& each : table)
    if (each.name != verb)
      others.push_back(".BR " + roff(each.name.empty() ? "etak" : "etak-" + each.name) + " (1)");
  return out + joined(others, ",\n") + '\n';
}

}  // namespace etak::cli
