// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace etak {

/// The settings of a user for every call of etak: $XDG_CONFIG_HOME/etak/config.toml, else
/// ~/.config/etak/config.toml. Unlike etak.toml the file never lies beside inputs, which may come from
/// others.
struct UserConfig {
  bool force = false;  // outputs may replace what is there, as --force says
};

/// Reads that file. Throws Error with file and line for a text that is no TOML, for unknown keys and for
/// values of another type. In target etak::validate_config.
UserConfig parse_user_config(std::string_view text, std::string_view file);

}  // namespace etak
