// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/output/output.h"

namespace etak::cli {

/// Whether outputs may replace existing files. --force allows it; else ETAK_FORCE=1 or 0 in the environment
/// decides, else `force` in the user's own configuration (core/validate/user_config.h). Throws Error where
/// ETAK_FORCE or the configuration cannot be understood.
bool may_replace(bool force);

/// Checks before long work whether the file of -o can be written: throws the Error that write_output() would
/// throw after it. Standard output always passes.
void check_output(const OutputArguments& arguments);

}  // namespace etak::cli
