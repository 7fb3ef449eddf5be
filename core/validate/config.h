// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/judge/settings.h"
#include "core/judge/target.h"
#include "core/names/names.h"

namespace etak {

// The configuration of a check: etak.toml, and the options of the program over it. Target
// etak::validate_config reads TOML (config_toml.cpp, the only source that includes toml++).

/// Files whose path matches `pattern` (glob_matches in suppress.h) have this role.
struct RolePattern {
  FileRole role = FileRole::specular_gloss;
  std::string pattern;
  friend bool operator==(const RolePattern&, const RolePattern&) = default;
};

/// What an etak.toml holds.
struct ValidateConfig {
  Settings settings;
  std::vector<RolePattern> roles;    // in the order of the file; they are tried before all endings
  std::vector<std::string> sets;     // [sets]: patterns with {set} and {role}, tried after [roles]
  std::vector<OwnName> names;        // [names]: endings that are tried before the built-in ones
  std::string file;                  // that was read; empty: none
  std::string root;                  // absolute path of the file's folder, which labels are relative to
  std::vector<std::string> remarks;  // on words that are now called otherwise
  friend bool operator==(const ValidateConfig&, const ValidateConfig&) = default;
};

/// Reads an etak.toml document. Throws Error with `file` and line for unknown keys, ids that no rule has
/// (ETK904), values out of range, and [[allow]] without a reason.
ValidateConfig parse_config(std::string_view text, std::string_view file);

/// The text of an [[allow]] entry, to be put behind that of an etak.toml.
std::string allow_text(const AllowEntry& entry);

/// Path of the etak.toml in the folder that `path` is or lies in, else of the nearest one above; empty: there
/// is none.
std::string find_config(const std::string& path);

/// The configuration in `file`, with the file's folder as root; where `file` is empty the default
/// configuration, with the working folder as root. Throws Error.
ValidateConfig read_config(const std::string& file);

/// The rules that the settings only, select, extend-select and ignore name, by whole ids, prefixes of ids, or
/// slugs.
///   only            every other rule is off, these are on whatever the configuration says
///   select          every other rule is off; these keep what the configuration says
///   extend_select   these are on, in addition to the others
///   ignore          these are off, whatever the other three say
struct RuleChoice {
  std::vector<std::string> only, select, extend_select, ignore;
};

/// Changes the settings by the choice. Throws Error (ETK904) naming the setting for an id that no rule has.
void apply_choice(const RuleChoice& choice, Settings& settings);

/// The value of the setting fail-on with which findings fail nothing.
inline constexpr std::string_view never_fails = "never";

/// How to check, as a person writes it: options of a command line, keywords of a call. Empty texts stand for
/// what the file says, or for the default.
///   config      file of the configuration; empty: find_config()
///   no_config   no file is looked for
struct ValidateSettings {
  std::string config, profile, transfer, fail_on, alpha;
  bool no_config = false;
  RuleChoice choice;
};

/// The file of the configuration that validate_config() reads; empty: none. In target etak::validate_config.
std::string config_of(const ValidateSettings& settings, const std::string& near);

/// The configuration of the file and of the settings, which win. A fail_on of never_fails changes no limit: the
/// caller then ignores findings. Throws Error. In target etak::validate_config.
///   near    a path to be checked, from whose folder upwards the file is looked for; empty: the working folder
///   known   the materials that textures are compared with; null: the built-in library
ValidateConfig validate_config(const ValidateSettings& settings, const std::string& near,
                               std::shared_ptr<const KnownMaterials> known);

/// Throws the Error for an id that no rule has; it names the nearest ids.
[[noreturn]] void unknown_rule(std::string_view place, std::string_view id);

/// Whether a configuration or an option may turn the rule off. False for the rules that tell what was not
/// checked: ETK001, and 9xx except for ETK903.
bool can_be_turned_off(const Rule& rule);

/// The severity that "on" stands for: that of the profile (of "custom": of the default profile), where that
/// is off that of the strict profile, and where that is off as well, a warning.
Severity severity_when_on(const Rule& rule, Profile profile);

}  // namespace etak
