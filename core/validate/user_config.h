// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace etak {

/// What a user has set for every call of etak: $XDG_CONFIG_HOME/etak/config.toml, else
/// ~/.config/etak/config.toml. Unlike etak.toml it never lies beside inputs, which may be somebody else's.
struct UserConfig {
  bool force = false;  // outputs may replace what is there, as --force says
};

/// Throws Error with file and line for what is no TOML, unknown keys and other kinds of values. In target
/// etak::validate_config, the door to toml++.
UserConfig parse_user_config(std::string_view text, std::string_view file);

}  // namespace etak
