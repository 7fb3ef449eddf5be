// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/arguments.h"
#include "core/base/csv.h"
#include "core/base/files/output.h"
#include "core/base/text.h"

namespace etak::cli {

/// Exit status of every verb.
enum Exit : int { exit_ok = 0, exit_findings = 1, exit_failure = 2 };

/// Where the data of a run go, and in which form.
struct OutputArguments {
  std::string format;
  std::string form_asked_by = "--format";  // or "-o FILE", where its ending tells the form
  std::string file;                        // empty or "-": standard output
  bool force = false;
  bool quiet = false;
  std::string color = "auto";
  std::string progress = "auto";  // of verbs with long work: see progress.h
};

/// Adds --format (one of `formats`; by default that of the ending of -o, else the first), -o, --force, -q and
/// --color.
void add_output_options(Command verb, OutputArguments& arguments, const std::vector<std::string>& formats);

/// Whether the data go to standard output.
bool is_standard_output(const OutputArguments& arguments);

/// Whether 24-bit colour may go into the output: --color; else NO_COLOR and CLICOLOR_FORCE; else a terminal,
/// unless CLICOLOR=0 or TERM=dumb.
bool use_color(const OutputArguments& arguments);

/// The data of the run, for the file of -o or standard output. Throws Error. Among several outputs it comes
/// last: what a pipe has taken cannot be taken back, so the others are ready by then, and where it takes
/// nothing they are not put in place.
std::unique_ptr<Output> output(const OutputArguments& arguments, std::string bytes);

/// The same, written at once.
void write_output(const OutputArguments& arguments, std::string_view bytes);

/// One line on standard error, "etak: " before it: line_text(), for messages name files, options and keys.
void complain(std::string_view message);

/// The same for remarks that -q silences.
void remark(const OutputArguments& arguments, std::string_view message);

}  // namespace etak::cli
