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

/// The request for validate() that the line describes. Throws Error.
ValidationRequest validation_request(ValidateArguments& arguments);

}  // namespace etak::cli
