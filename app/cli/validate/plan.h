// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "app/cli/validate/validate.h"
#include "core/base/files/output.h"
#include "core/validate/config.h"
#include "core/validate/finding.h"

namespace etak::cli {

/// What a check goes by: settings, roles, and the folder that labels are relative to.
struct ValidatePlan {
  ValidateConfig config;
  std::string config_file;  // empty: none
  std::string root;         // absolute
};

/// The materials of the library that the line and the environment ask for; null where that is the built-in
/// one alone. Throws Error for a folder that cannot be read.
std::shared_ptr<const KnownMaterials> asked_materials(Library& library);

/// From etak.toml (of --config, else of the first path's folder or the nearest one above it) and the command
/// line, which wins. Throws Error.
///   known   what textures are judged by; null: the built-in library
ValidatePlan validate_plan(const ValidateArguments& arguments, std::shared_ptr<const KnownMaterials> known);

/// Marks what [[allow]] entries and the baseline know. Returns the baseline that is asked for, to be put in
/// place with the other outputs of the run; null where none is.
std::unique_ptr<Output> take_out_known(ValidationReport& report, const ValidateArguments& arguments,
                                       const ValidatePlan& plan);

}  // namespace etak::cli
