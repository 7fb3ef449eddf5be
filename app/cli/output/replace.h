// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/output/output.h"

namespace etak::cli {

/// Whether an output may replace what stands in its place: --force, ETAK_FORCE=1 in the environment, or force
/// = true in the user's own configuration (core/validate/user_config.h). Throws Error where one of the two
/// cannot be understood.
bool may_replace(bool force);

/// Throws, before long work, the Error that write_output() would end with. Standard output is always fine.
void check_output(const OutputArguments& arguments);

}  // namespace etak::cli
