// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/cli/validate/validate.h"
#include "core/validate/config.h"
#include "core/validate/validate.h"

namespace etak::cli {

/// The materials of the library that the line and the environment ask for; null where that is the built-in
/// one alone. Throws Error for a folder that cannot be read.
std::shared_ptr<const KnownMaterials> asked_materials(Library& library);

/// "info", "warning" or "error".
std::optional<Severity> told_severity(const std::string& text);

/// From etak.toml (of --config, else of the first path's folder or the nearest one above it) and the command
/// line, which wins. Throws Error.
///   known   what textures are judged by; null: the built-in library
ValidateConfig validate_config(const ValidateArguments& arguments,
                               std::shared_ptr<const KnownMaterials> known);

/// What the line asks for. Throws Error.
ValidationRequest validation_request(ValidateArguments& arguments);

}  // namespace etak::cli
