// SPDX-License-Identifier: Apache-2.0
// The one door to toml++.
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

// toml++ 3.3 asserts, or with NDEBUG takes for granted, what a document such as "[[[" breaks; here that is
// one more kind of document that cannot be read.
#undef NDEBUG
#define TOML_ASSERT(condition) ((condition) ? void() : no_toml())
namespace {
struct NoToml {};
[[noreturn]] void no_toml() {
  throw NoToml();
}
}  // namespace
#include <toml++/toml.h>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/validate/config.h"
#include "core/validate/rules.h"
#include "core/validate/suppress.h"
#include "core/validate/user_config.h"

namespace etak {
namespace {

// A value and the words for messages: "etak.toml:12: FOUND; expected EXPECTED".
struct Node {
  const toml::node& value;
  std::string_view file;
  std::string name;  // "[zone] low"

  [[noreturn]] void fail(std::string_view found, std::string_view expected) const {
    throw Error::at_line(file, value.source().begin.line, name + ": " + std::string(found), expected);
  }
  [[noreturn]] void fail_value(std::string_view expected) const {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    value.visit([&](const auto& node) { text << node; });
    fail(printable(text.str(), 60), expected);
  }
  std::string text(std::string_view expected = "a string") const {
    if (const auto* string = value.as_string()) return string->get();
    fail_value(expected);
  }
  double number(double least, double most, std::string_view expected) const {
    const auto number = value.is_number() ? value.value<double>() : std::nullopt;
    if (!number || !std::isfinite(*number) || *number < least || *number > most) fail_value(expected);
    return *number;
  }
};

using Handler = void (*)(const Node&, ValidateConfig&);
struct Key {
  std::string_view name;
  Handler read;
};

std::string quoted_names(std::span<const Key> keys) {
  std::string out;
  for (const Key& key : keys) out += (out.empty() ? "" : ", ") + std::string(key.name);
  return out;
}

// Calls the handler of every key of `table`; `place` names the table in messages.
void read_keys(const toml::table& table, std::string_view file, const std::string& place,
               std::span<const Key> keys, ValidateConfig& config) {
  for (const auto& [key, value] : table) {
    const auto known = std::find_if(keys.begin(), keys.end(),
                                    [&, name = key.str()](const Key& k) { return k.name == name; });
    if (known == keys.end())
      throw Error::at_line(file, key.source().begin.line,
                           place + "unknown key \"" + printable(key.str()) + '"',
                           "one of " + quoted_names(keys));
    known->read({value, file, place + std::string(known->name)}, config);
  }
}

const toml::table& table_of(const Node& node) {
  if (const auto* table = node.value.as_table()) return *table;
  node.fail_value("a table");
}

std::optional<Severity> severity_named(std::string_view text) {
  for (const Severity severity : {Severity::off, Severity::info, Severity::warning, Severity::error})
    if (text == name(severity)) return severity;
  return std::nullopt;
}

// ---- top level

void read_profile(const Node& node, ValidateConfig& config) {
  constexpr std::string_view expected = "default, strict, film or custom";
  const auto profile = profile_named(node.text(expected));
  if (!profile) node.fail_value(expected);
  config.settings.profile = *profile;
}

void read_transfer(const Node& node, ValidateConfig& config) {
  constexpr std::string_view expected = "srgb, gamma22 or linear";
  const auto transfer = texture_transfer_named(node.text(expected));
  if (!transfer) node.fail_value(expected);
  config.settings.transfer = *transfer;
  config.settings.transfer_stated = true;
}

void read_fail_on(const Node& node, ValidateConfig& config) {
  constexpr std::string_view expected = "error, warning or info";
  const auto severity = severity_named(node.text(expected));
  if (!severity || *severity == Severity::off) node.fail_value(expected);
  config.settings.fail_on = *severity;
}

void read_alpha(const Node& node, ValidateConfig& config) {
  constexpr std::string_view expected = "mask or transparency";
  const std::string text = node.text(expected);
  if (text != "mask" && text != "transparency") node.fail_value(expected);
  config.settings.alpha_is_transparency = text == "transparency";
}

// ---- [roles]

void read_roles(const Node& node, ValidateConfig& config) {
  for (const auto& [key, value] : table_of(node)) {
    std::string role_name(key.str());
    std::replace(role_name.begin(), role_name.end(), '_', '-');
    const auto role = role_named(role_name);
    if (!role)
      throw Error::at_line(node.file, key.source().begin.line,
                           "[roles] unknown role \"" + printable(key.str()) + '"',
                           "one of diffuse, specular, f0, base-color, metal-rough");
    const Node patterns{value, node.file, "[roles] " + role_name};
    const auto add = [&](const toml::node& pattern) {
      const std::string text = Node{pattern, node.file, patterns.name}.text("a pattern such as \"*_spec.*\"");
      if (text.empty()) patterns.fail("an empty pattern", "a pattern such as \"*_spec.*\"");
      config.roles.push_back({*role, text});
    };
    if (const auto* list = value.as_array())
      for (const toml::node& pattern : *list) add(pattern);
    else
      add(value);
  }
}

// ---- [rules]

void read_rule(const Node& node, const std::vector<const Rule*>& meant, ValidateConfig& config) {
  const auto set_severity = [&](const Node& word) {
    const std::string text = word.text("off, info, warning, error or on");
    const auto severity = severity_named(text);
    if (!severity && text != "on") word.fail_value("off, info, warning, error or on");
    const bool off = severity == Severity::off;
    if (off && meant.size() == 1 && !can_be_turned_off(*meant.front()))
      word.fail("off", "info, warning or error: it tells what was not checked");
    for (const Rule* rule : meant)
      if (!off || can_be_turned_off(*rule))
        config.settings.rules[std::string(rule->id)].severity =
            severity ? *severity : severity_when_on(*rule, config.settings.profile);
  };
  const auto* table = node.value.as_table();
  if (table == nullptr) return set_severity(node);
  for (const auto& [key, value] : *table) {
    const Node entry{value, node.file, node.name + '.' + std::string(key.str())};
    if (key.str() == "severity") {
      set_severity(entry);
      continue;
    }
    std::string known = "severity";
    bool taken = false;
    for (const Rule* rule : meant)
      for (const RuleParameter& parameter : rule->parameters) {
        if (known.find(parameter.name) == known.npos) known += ", " + std::string(parameter.name);
        if (parameter.name != key.str()) continue;
        constexpr double most = std::numeric_limits<double>::max();
        config.settings.rules[std::string(rule->id)].parameters[std::string(parameter.name)] =
            entry.number(-most, most, "a number");
        taken = true;
      }
    if (!taken)
      throw Error::at_line(node.file, key.source().begin.line,
                           node.name + " has no parameter \"" + printable(key.str()) + '"',
                           "one of " + known);
  }
}

void read_rules(const Node& node, ValidateConfig& config) {
  struct Entry {
    std::string id;
    const toml::node* value;
    toml::source_index line;
  };
  std::vector<Entry> entries;
  for (const auto& [key, value] : table_of(node))
    entries.push_back({std::string(key.str()), &value, key.source().begin.line});
  // The longer name is the closer one: ETK202 wins over ETK2, wherever they stand.
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.id.size() < b.id.size(); });
  for (const Entry& entry : entries) {
    const auto meant = rules_with_prefix(entry.id);
    if (meant.empty()) unknown_rule(std::string(node.file) + ':' + std::to_string(entry.line), entry.id);
    read_rule({*entry.value, node.file, "[rules] " + entry.id}, meant, config);
  }
}

// ---- [zone]

constexpr Key zone_keys[] = {
    {"low",
     [](const Node& n, ValidateConfig& c) { c.settings.zone.low = n.number(0, 1, "a number from 0 to 1"); }},
    {"high",
     [](const Node& n, ValidateConfig& c) { c.settings.zone.high = n.number(0, 1, "a number from 0 to 1"); }},
    {"metric",
     [](const Node& n, ValidateConfig& c) {
       constexpr std::string_view expected = "luminance or max";
       const std::string text = n.text(expected);
       if (text != "luminance" && text != "max") n.fail_value(expected);
       c.settings.zone.metric = text == "max" ? ZoneMetric::max : ZoneMetric::luminance;
     }},
    {"erode",
     [](const Node& n, ValidateConfig& c) {
       const double side = n.number(1, 5, "1, 3 or 5");
       if (side != 1 && side != 3 && side != 5) n.fail_value("1, 3 or 5");
       c.settings.zone.erode = static_cast<int>(side);
     }},
    {"min_area_px",
     [](const Node& n, ValidateConfig& c) {
       const double area = n.number(1, 1e9, "a whole number from 1");
       if (area != std::floor(area)) n.fail_value("a whole number from 1");
       c.settings.zone.min_area_px = static_cast<int>(area);
     }},
    {"min_area_share", [](const Node& n, ValidateConfig& c) {
       c.settings.zone.min_area_share = n.number(0, 1, "a number from 0 to 1");
     }}};

void read_zone(const Node& node, ValidateConfig& config) {
  read_keys(table_of(node), node.file, "[zone] ", zone_keys, config);
  if (config.settings.zone.low >= config.settings.zone.high)
    node.fail("low " + number(config.settings.zone.low, 6) + " is not below high " +
                  number(config.settings.zone.high, 6),
              "low < high");
}

// ---- [[allow]]

// A date as TOML knows it, or as a string.
std::string date_of(const Node& node) {
  constexpr std::string_view expected = "a date such as \"2027-01-01\"";
  if (const auto* date = node.value.as_date()) {
    const auto padded = [](int value, std::size_t width) {
      std::string text = std::to_string(value);
      return text.size() < width ? std::string(width - text.size(), '0') + text : text;
    };
    const toml::date& day = date->get();
    return padded(day.year, 4) + '-' + padded(day.month, 2) + '-' + padded(day.day, 2);
  }
  std::string text = node.text(expected);
  if (!is_date(text)) node.fail_value(expected);
  return text;
}

constexpr Key allow_keys[] = {
    {"rule",
     [](const Node& n, ValidateConfig& c) {
       const std::string id = n.text();
       if (rules_with_prefix(id).empty())
         unknown_rule(std::string(n.file) + ':' + std::to_string(n.value.source().begin.line), id);
       const Rule* rule = find_rule(id);
       c.settings.allow.back().rule = rule != nullptr ? std::string(rule->id) : id;
     }},
    {"file", [](const Node& n, ValidateConfig& c) { c.settings.allow.back().file = n.text(); }},
    {"material", [](const Node& n, ValidateConfig& c) { c.settings.allow.back().material = n.text(); }},
    {"tile", [](const Node& n, ValidateConfig& c) { c.settings.allow.back().tile = n.text(); }},
    {"reason", [](const Node& n, ValidateConfig& c) { c.settings.allow.back().reason = n.text(); }},
    {"expires", [](const Node& n, ValidateConfig& c) { c.settings.allow.back().expires = date_of(n); }}};

void read_allow(const Node& node, ValidateConfig& config) {
  const auto* list = node.value.as_array();
  if (list == nullptr) node.fail_value("tables [[allow]]");
  for (const toml::node& item : *list) {
    const Node entry{item, node.file, "[[allow]]"};
    config.settings.allow.emplace_back();
    read_keys(table_of(entry), node.file, "[[allow]] ", allow_keys, config);
    const AllowEntry& made = config.settings.allow.back();
    if (made.rule.empty()) entry.fail("no rule", "rule = \"ETK...\"");
    if (made.reason.find_first_not_of(" \t\n\r") == std::string::npos)
      entry.fail("no reason", "reason = \"why this is right\"");
  }
}

constexpr Key top_keys[] = {{"profile", read_profile}, {"transfer", read_transfer}, {"fail_on", read_fail_on},
                            {"alpha", read_alpha},     {"roles", read_roles},       {"rules", read_rules},
                            {"zone", read_zone},       {"allow", read_allow}};

toml::table document_of(std::string_view text, std::string_view file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw Error::at_line(file, error.source().begin.line, printable(error.description(), 200),
                         "a TOML document");
  } catch (const NoToml&) {
    throw Error::at(file, "a table or key that cannot be read", "a TOML document");
  }
}

}  // namespace

ValidateConfig parse_config(std::string_view text, std::string_view file) {
  const toml::table table = document_of(text, file);
  ValidateConfig out;
  // "on" in [rules] depends on the profile, and a table's keys come in the order of their names.
  if (const toml::node* profile = table.get("profile")) read_profile({*profile, file, "profile"}, out);
  read_keys(table, file, "", top_keys, out);
  return out;
}

UserConfig parse_user_config(std::string_view text, std::string_view file) {
  UserConfig out;
  const toml::table table = document_of(text, file);
  for (const auto& [key, value] : table) {
    if (key.str() != "force")
      throw Error::at_line(file, key.source().begin.line, "unknown key \"" + printable(key.str()) + '"',
                           "force");
    const auto* force = value.as_boolean();
    if (force == nullptr) Node{value, file, "force"}.fail_value("true or false");
    out.force = force->get();
  }
  return out;
}

}  // namespace etak
