// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace etak {

/// A setting as the user of the program knows it, for messages that say what would help: "allow
/// extrapolation" of "allow-extrapolation". A program whose settings are options of a command line says so
/// once at its start (settings_are_options()); the same is then "--allow-extrapolation".
std::string setting(std::string_view name);

/// To be called at the start of a program, before any thread calls setting().
void settings_are_options();

}  // namespace etak
