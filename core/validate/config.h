// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/validate/names/names.h"
#include "core/validate/settings.h"
#include "core/validate/target.h"

namespace etak {

// The configuration of a check: etak.toml and what the program lays over it. Reading TOML is the business of
// target etak::validate_config (config_toml.cpp), the one door to toml++.

/// Files whose path matches `pattern` (glob_matches in suppress.h) have this role.
struct RolePattern {
  FileRole role = FileRole::specular_gloss;
  std::string pattern;
  friend bool operator==(const RolePattern&, const RolePattern&) = default;
};

struct ValidateConfig {
  Settings settings;
  std::vector<RolePattern> roles;  // in the file's order; they come before all endings
  std::vector<OwnName> names;      // [names]: endings that come before the built-in ones
  std::string file;                // that it was read from; empty: none
  std::string root;                // folder that labels are relative to, absolute: the file's
  friend bool operator==(const ValidateConfig&, const ValidateConfig&) = default;
};

/// An etak.toml document, everything checked: unknown keys, ids that no rule has (ETK904), values out of
/// range, [[allow]] without a reason. Throws Error naming `file` and line.
ValidateConfig parse_config(std::string_view text, std::string_view file);

/// etak.toml of the folder that `path` is or lies in, else the nearest one above; empty: there is none.
std::string find_config(const std::string& path);

/// The configuration in `file`, with the file's folder as root; where `file` is empty what holds without one,
/// with the working folder as root. Throws Error.
ValidateConfig read_config(const std::string& file);

/// What --select and its like name: whole ids, prefixes of ids, or slugs.
///   only            every other rule is off, these are on whatever the configuration says
///   select          every other rule is off; these keep what the configuration says
///   extend_select   on besides the others
///   ignore          off; goes last
struct RuleChoice {
  std::vector<std::string> only, select, extend_select, ignore;
};

/// Lays the choice over the settings. Throws Error (ETK904) naming the option for an id that no rule has.
void apply_choice(const RuleChoice& choice, Settings& settings);

/// The Error for an id that no rule has, with the nearest ones.
[[noreturn]] void unknown_rule(std::string_view place, std::string_view id);

/// False for what tells that something was not looked at (ETK001 and the 9xx rules but ETK903): no choice and
/// no prefix turns these off.
bool can_be_turned_off(const Rule& rule);

/// 32 hexadecimal digits, equal for settings that find the same: rules with severities and parameters, zone,
/// transfer and the meaning of alpha. Allowances and fail_on judge what was found and are left out.
std::string settings_hash(const Settings& settings);

/// The severity that "on" stands for: the profile's, and where that is off, the strict profile's.
Severity severity_when_on(const Rule& rule, Profile profile);

}  // namespace etak
