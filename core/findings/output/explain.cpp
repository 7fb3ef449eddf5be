// SPDX-License-Identifier: Apache-2.0
#include "core/findings/output/explain.h"

#include <algorithm>

#include "core/base/json/json_text.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/base/text/wrap.h"
#include "core/judge/rules.h"

namespace etak {
namespace {

// Longer lines are hard to read, however wide the terminal is.
constexpr std::size_t widest_line = 100;

std::string profiles_of(const Rule& rule) {
  return std::string(name(rule.severity.standard)) + ", strict profile " +
         std::string(name(rule.severity.strict));
}

std::string value_of(const RuleParameter& parameter) {
  std::string out = number(parameter.value, 9);
  if (parameter.strict_value != parameter.value) out += " (strict " + number(parameter.strict_value, 9) + ")";
  if (!parameter.unit.empty()) out += ' ' + std::string(parameter.unit);
  return out;
}

}  // namespace

std::string explanation(const Rule& rule, std::size_t columns) {
  const std::size_t width = columns == 0 ? widest_line : std::min(columns, widest_line);
  const auto lines = [width](std::string_view text, std::size_t indent) {
    return wrapped(text, indent, width);
  };
  std::string out;
  append(out, lines(std::string(rule.id) + ' ' + std::string(rule.slug) + ": " + std::string(rule.title), 0));
  append(out, lines(std::string(rule.family()) + "; severity " + profiles_of(rule), 2), '\n');
  append(out, lines(rule.what, 2), "\n  Why\n", lines(rule.why, 4));
  append(out, "\n  Example\n", lines(rule.example, 4), "\n  Fix\n", lines(rule.fix, 4));
  if (!rule.parameters.empty()) {
    append(out, "\n",
           lines("Parameters, in etak.toml: [rules] " + std::string(rule.id) + " = { " +
                     std::string(rule.parameters.begin()->name) + " = " +
                     number(rule.parameters.begin()->value, 9) + " }",
                 2));
    for (const RuleParameter& parameter : rule.parameters)
      append(out, lines(std::string(parameter.name) + " = " + value_of(parameter) + ": " +
                            std::string(parameter.meaning),
                        4));
  }
  append(out, "\n  Source\n", lines(rule.source, 4));
  return out;
}

std::string explanation_markdown(const Rule& rule) {
  std::string out;
  append(out, "### ", rule.id, ' ', rule.slug, "\n\n", rule.title, ". Severity: ", profiles_of(rule),
         ".\n\n");
  append(out, rule.what, "\n\n**Why.** ", rule.why, "\n\n**Example.** ", rule.example, "\n\n**Fix.** ",
         rule.fix, '\n');
  for (const RuleParameter& parameter : rule.parameters)
    append(out, &parameter == rule.parameters.begin() ? "\n" : "", "- `", parameter.name,
           "` = ", value_of(parameter), ": ", parameter.meaning, '\n');
  append(out, "\n**Source.** ", rule.source, '\n');
  return out;
}

std::string rules_table() {
  std::size_t slug_width = 0;
  for (const Rule* rule : rules()) slug_width = std::max(slug_width, rule->slug.size());
  std::string out;
  append(out, padded("id", 8), padded("slug", slug_width + 2), padded("default", 9), padded("strict", 9),
         "title\n");
  for (const Rule* rule : rules())
    append(out, padded(rule->id, 8), padded(rule->slug, slug_width + 2),
           padded(name(rule->severity.standard), 9), padded(name(rule->severity.strict), 9), rule->title,
           '\n');
  return out;
}

std::string rules_json(std::span<const Rule* const> rules) {
  std::vector<std::string> rows;
  for (const Rule* rule : rules) {
    std::vector<std::string> parameters;
    for (const RuleParameter& parameter : rule->parameters) {
      const JsonMember members[] = {{"name", json(parameter.name)},
                                    {"value", json(parameter.value)},
                                    {"strict", json(parameter.strict_value)},
                                    {"unit", json(parameter.unit)},
                                    {"meaning", json(parameter.meaning)}};
      parameters.push_back(json_object(members, -1));
    }
    const JsonMember members[] = {{"id", json(rule->id)},
                                  {"slug", json(rule->slug)},
                                  {"title", json(rule->title)},
                                  {"family", json(rule->family())},
                                  {"severity", json(name(rule->severity.standard))},
                                  {"strict", json(name(rule->severity.strict))},
                                  {"needsPixels", json(rule->needs.pixels() || rule->needs.has(Need::maps))},
                                  {"what", json(rule->what)},
                                  {"why", json(rule->why)},
                                  {"example", json(rule->example)},
                                  {"fix", json(rule->fix)},
                                  {"source", json(rule->source)},
                                  {"parameters", json_array(parameters)}};
    rows.push_back("\n    " + json_object(members, 4));
  }
  return "{\n  \"schema\": \"etak-rules/1\",\n  \"rules\": [" + joined(rows, ",") + "\n  ]\n}\n";
}

}  // namespace etak
