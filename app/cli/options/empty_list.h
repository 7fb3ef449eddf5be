// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/cli/arguments.h"
#include "core/base/error.h"

namespace etak::cli {

/// Adds --allow-empty, for scripts whose list of --files-from may be empty.
void add_allow_empty_option(Command verb, bool& allow_empty);

/// The error for a list of --files-from that names nothing. Without --allow-empty that is an error, because
/// most often the program that made the list has failed.
Error empty_list(const std::string& list);

}  // namespace etak::cli
