// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/cli/arguments.h"
#include "core/base/error.h"

namespace etak::cli {

/// Adds --allow-empty, which goes with --files-from: a pipeline whose list may be empty says so.
void add_allow_empty_option(Command verb, bool& allow_empty);

/// For a --files-from that names nothing: most often the program that made the list has failed.
Error empty_list(const std::string& list);

}  // namespace etak::cli
