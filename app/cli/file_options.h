// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace etak::cli {

/// Marks an option or argument whose values name files to read: a pipe that is named there may be read, - and
/// /dev/stdin among them (core/base/input.h). A second standard input on the line throws Error.
CLI::Option* reads_file(CLI::Option* option);

/// Adds --follow-links to a verb that reads what scenes, manifests and folders name (core/base/links.h).
void add_follow_links(CLI::App& verb);

/// Adds --input-timeout to every verb of `app`.
void add_input_timeout(CLI::App& app);

}  // namespace etak::cli
