// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/validate/validate.h"

namespace etak::cli {

/// Checks the files, and again whenever one of them changes, until the process is interrupted. Throws Error for
/// options that do not go with it, and what the first check throws.
int watch_files(ValidateArguments& arguments);

}  // namespace etak::cli
