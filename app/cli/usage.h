// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/option_table.h"
#include "core/base/error.h"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace etak::cli {

/// "a, b or c".
std::string listed(const std::vector<std::string>& words, const char* between, const char* last);

/// The error for a verb that does not exist, with the name in `verbs` that the user most likely meant.
Error unknown_verb(std::string_view typed, const std::vector<std::string>& verbs);

/// Makes the help of `app` and its verbs show what the declarations of options say: values as "table | csv" and
/// "1 to 256" instead of as types of the parser. `traits` has to live as long as the app.
void use_plain_help(CLI::App& app, const TraitsOfOptions& traits);

/// The message for a mistake on the line, "PLACE: FOUND; expected EXPECTED", without the program's name.
std::string message_of(const CLI::App& app, const TraitsOfOptions& all, const CLI::ParseError& error);

/// The help of the verb `name`, or of etak itself where it is empty: `whole` with every group of options, else with
/// the first group alone. Throws Error for a verb that does not exist.
std::string verb_help(const CLI::App& app, const std::string& name, bool whole);

/// etak itself and its verbs with all they take, in the order of the help.
std::vector<VerbRow> option_table(const CLI::App& app, const TraitsOfOptions& traits);

}  // namespace etak::cli
