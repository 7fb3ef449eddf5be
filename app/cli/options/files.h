// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/arguments.h"

namespace etak::cli {

/// Adds --follow-links to a verb that reads files named by scenes, manifests and folders
/// (core/base/files/links.h).
void add_follow_links(Command verb);

/// Adds --input-timeout to every verb of `line`.
void add_input_timeout(CommandLine& line);

}  // namespace etak::cli
