// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/arguments.h"

namespace etak::cli {

// Each function add_NAME() adds its verb with options, help and work to `line`.
#define ETAK_VERB(name) void add_##name(CommandLine& line);
#include "app/cli/verbs.inc"
#undef ETAK_VERB

}  // namespace etak::cli
