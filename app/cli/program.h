// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/cli/arguments.h"

namespace etak::cli {

/// A line without verbs and options, for run_line().
CommandLine empty_line();

/// Does what a line of words asks for, and tells on standard error why where it cannot. Returns the exit status.
///   words   the name of the program and its arguments
///   line    an empty_line(), which takes the options; they must live until the work is done
int run_line(const std::vector<std::string>& words, CommandLine& line);

}  // namespace etak::cli
