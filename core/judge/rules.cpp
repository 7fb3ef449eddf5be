// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>

#include "core/base/files/input.h"
#include "core/base/text/edit_distance.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

constexpr const Rule* rows[] = {
#define ETAK_RULE(name) &name,
#include "core/judge/rules/rules.inc"
#undef ETAK_RULE
};

std::string upper(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return out;
}

}  // namespace

std::span<const Rule* const> rules() {
  return rows;
}

std::string_view Rule::family() const {
  constexpr std::string_view families[] = {"Input",
                                           "Specular and F0",
                                           "Diffuse and energy",
                                           "Gloss",
                                           "Encoding and precision",
                                           "Alpha, mips and atlas",
                                           "Material and spectral data",
                                           "Normal, occlusion and emissive maps",
                                           "Values of material documents",
                                           "Tool"};
  return families[static_cast<std::size_t>(id[3] - '0')];
}

const Rule* find_rule(std::string_view id_or_slug) {
  const std::string id = upper(id_or_slug);
  for (const Rule* rule : rows)
    if (rule->id == id || rule->slug == id_or_slug) return rule;
  return nullptr;
}

const Rule& rule_of_unreadable(std::string_view message) {
  return message.find(git_lfs_pointer) == message.npos ? etk001_unreadable : etk011_git_lfs_pointer;
}

bool is_of_the_tool(std::string_view rule) {
  return rule == etk001_unreadable.id || rule == etk011_git_lfs_pointer.id || rule.starts_with("ETK9");
}

std::vector<const Rule*> rules_with_prefix(std::string_view prefix) {
  if (const Rule* rule = find_rule(prefix)) return {rule};
  std::vector<const Rule*> found;
  const std::string id = upper(prefix);
  if (!id.starts_with("ETK")) return found;
  for (const Rule* rule : rows)
    if (rule->id.starts_with(id)) found.push_back(rule);
  return found;
}

std::vector<std::string_view> nearest_rules(std::string_view id, std::size_t count) {
  std::vector<const Rule*> sorted(std::begin(rows), std::end(rows));
  const auto distance = [&](const Rule* rule) {
    return std::min(edit_distance(id, rule->id), edit_distance(id, rule->slug));
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const Rule* a, const Rule* b) { return distance(a) < distance(b); });
  std::vector<std::string_view> nearest;
  for (std::size_t i = 0; i < std::min(count, sorted.size()); ++i) nearest.push_back(sorted[i]->id);
  return nearest;
}

}  // namespace etak
