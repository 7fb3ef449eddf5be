// SPDX-License-Identifier: Apache-2.0
#include "core/validate/config.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/base/error.h"
#include "core/base/files/paths.h"
#include "core/base/json/json_text.h"
#include "core/base/setting.h"
#include "core/base/system.h"
#include "core/base/text/text.h"
#include "core/judge/rules.h"

namespace etak {
namespace {

std::set<const Rule*> chosen_rules(const std::vector<std::string>& ids, std::string_view option) {
  std::set<const Rule*> out;
  for (const std::string& id : ids) {
    const auto found = rules_with_prefix(id);
    if (found.empty()) unknown_rule(option, id);
    out.insert(found.begin(), found.end());
  }
  return out;
}

}  // namespace

std::string find_config(const std::string& path) {
  namespace fs = std::filesystem;
  fs::path folder = sys::absolute(path).lexically_normal();
  if (!is_folder(sys::path_text(folder))) folder = folder.parent_path();
  for (;; folder = folder.parent_path()) {
    const fs::path candidate = folder / "etak.toml";
    if (is_file(sys::path_text(candidate))) {
      // Messages name the file relative to the working folder where it lies below that.
      const fs::path near = candidate.lexically_relative(sys::working_folder());
      return near.empty() || *near.begin() == ".." ? sys::path_text(candidate) : sys::path_text(near);
    }
    if (folder == folder.parent_path()) return {};
  }
}

std::string allow_text(const AllowEntry& entry) {
  std::string out = "\n[[allow]]\n";
  const auto add = [&](const char* key, const std::string& value) {
    // A basic string of TOML has the escapes of JSON.
    if (!value.empty()) out += std::string(key) + " = " + json(value) + '\n';
  };
  add("rule", entry.rule);
  add("file", entry.file);
  add("material", entry.material);
  add("tile", entry.tile);
  add("reason", entry.reason);
  add("expires", entry.expires);
  return out;
}

bool can_be_turned_off(const Rule& rule) {
  return !is_of_the_tool(rule.id) || rule.id == "ETK903";
}

void unknown_rule(std::string_view place, std::string_view id) {
  throw Error::at(place, "ETK904 unknown-rule: no rule is called " + in_quotes(id),
                  "an id or a prefix such as ETK101 or ETK1; nearest: " + joined(nearest_rules(id)));
}

Severity severity_when_on(const Rule& rule, Profile profile) {
  if (profile == Profile::standard || profile == Profile::custom)
    if (rule.severity.standard != Severity::off) return rule.severity.standard;
  return rule.severity.strict != Severity::off ? rule.severity.strict : Severity::warning;
}

void apply_choice(const RuleChoice& choice, Settings& settings) {
  const auto turn_on = [&](const Rule& rule) {
    if (severity_of(rule, settings) == Severity::off)
      settings.rules[std::string(rule.id)].severity = severity_when_on(rule, settings.profile);
  };
  const auto turn_off = [&](const Rule& rule) {
    if (can_be_turned_off(rule)) settings.rules[std::string(rule.id)].severity = Severity::off;
  };
  const auto only = chosen_rules(choice.only, setting("only"));
  const auto select = chosen_rules(choice.select, setting("select"));
  const auto extend = chosen_rules(choice.extend_select, setting("extend-select"));
  const auto ignore = chosen_rules(choice.ignore, setting("ignore"));
  for (const Rule* rule : rules()) {
    if (only.contains(rule)) turn_on(*rule);
    const bool named = only.contains(rule) || select.contains(rule);
    if (!named && (!only.empty() || !select.empty())) turn_off(*rule);
    if (extend.contains(rule)) turn_on(*rule);
    if (ignore.contains(rule)) turn_off(*rule);
  }
}

}  // namespace etak
