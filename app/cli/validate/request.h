// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/cli/validate/validate.h"
#include "core/validate/config.h"
#include "core/validate/validate.h"

namespace etak::cli {

/// The materials of the library with the folders of --library and ETAK_LIBRARY; null where there are no such
/// folders, which stands for the built-in library. Throws Error for a folder that cannot be read.
std::shared_ptr<const KnownMaterials> asked_materials(Library& library);

/// The severity of that name ("info", "warning" or "error"), if there is one.
std::optional<Severity> told_severity(const std::string& text);

/// The settings of etak.toml (the file of --config, else that of the first path's folder or of the nearest
/// folder above it) and of the command line, which wins. Throws Error.
///   known   the materials that textures are compared with; null: the built-in library
ValidateConfig validate_config(const ValidateArguments& arguments,
                               std::shared_ptr<const KnownMaterials> known);

/// The request for validate() that the line describes. Throws Error.
ValidationRequest validation_request(ValidateArguments& arguments);

}  // namespace etak::cli
