// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/option_table.h"
#include "app/cli/options/options.h"

namespace etak::cli {

/// What a shell offers for the value of an option: "files", "folders", or one of named_kinds(), whose names etak
/// knows; empty where the value is no name, and where the option lists its words itself. By what stands for the
/// value in the help. Materials come with files, since every verb that takes the name of a material takes its
/// file too.
std::string_view completes(const OptionRow& option);

/// "materials", "classes", ...: the kinds whose names names_of() tells.
std::vector<std::string> named_kinds();

/// Whether the value is a list of names with ',' between.
bool is_list(const OptionRow& option);

/// The names of `kind`, one of named_kinds(), sorted as etak lists them. Throws Error for another kind.
///   library   whose materials are offered; opened for them alone
std::vector<std::string> names_of(std::string_view kind, const std::vector<VerbRow>& table, Library& library);

/// The verbs of the table.
std::vector<std::string> verb_names(const std::vector<VerbRow>& table);

}  // namespace etak::cli
