// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/option_table.h"
#include "app/cli/options/options.h"

namespace etak::cli {

/// What a shell offers for the value of an option: files, or names that etak knows.
enum class Completes {
  nothing,
  files,
  folders,
  materials,  // and files, since every verb that takes the name of a material takes its file too
  classes,
  rules,
  models,
  diffuse_models,
  functions,
  targets,
  spaces,
  verbs
};
std::string_view name(Completes kind);  // "materials"

/// The kinds whose values etak knows: all but nothing, files and folders.
std::vector<std::string> named_kinds();

/// By what stands for the option's value in the help. `nothing` where the value is no name, and where the
/// option lists its words itself.
Completes completes(const OptionRow& option);

/// Whether the value is a list of names with ',' between.
bool is_list(const OptionRow& option);

/// The names of `kind`, one of named_kinds(), sorted as etak lists them. Throws Error for another kind.
///   library   whose materials are offered; opened for them alone
std::vector<std::string> names_of(std::string_view kind, const std::vector<VerbRow>& table, Library& library);

/// The verbs of the table.
std::vector<std::string> verb_names(const std::vector<VerbRow>& table);

}  // namespace etak::cli
