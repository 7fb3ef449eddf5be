// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"

namespace etak {

/// How a program's users write its settings.
///   words      "allow extrapolation": fields of a window, or nothing that is written
///   options    "--allow-extrapolation", of a command line
///   keywords   "allow_extrapolation", of calls in a program
enum class SettingStyle { words, options, keywords };

/// A setting as the user of the program knows it, for messages that say what would help.
///   name   as options have it, without dashes in front: "allow-extrapolation"
std::string setting(std::string_view name);

/// To be called at the start of a program, before any thread calls setting(). Without it settings are words.
void settings_are(SettingStyle style);

/// The value of a setting that is a word, as `named` finds it; `standard` where the word is empty. Throws
/// Error for a word that `named` does not know.
///   name       of the setting
///   named      optional<Value>(const std::string&)
///   expected   the words that there are, for the message
template <class Value, class Named>
Value setting_value(std::string_view name, const std::string& word, Value standard, Named named,
                    std::string_view expected) {
  if (word.empty()) return standard;
  if (const auto value = named(word)) return *value;
  throw Error::at(setting(name), printable(word), expected);
}

}  // namespace etak
