// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/arguments.h"
#include "core/base/files/output.h"
#include "core/base/text/csv.h"
#include "core/base/text/text.h"

namespace etak::cli {

/// Exit status of every verb.
enum Exit : int { exit_ok = 0, exit_findings = 1, exit_failure = 2 };

/// The options that say where the data of a run go, and in which form.
struct OutputArguments {
  std::string format;
  std::string form_asked_by = "--format";  // or "-o FILE", where the ending of the file decides
  std::string file;                        // empty or "-": standard output
  bool force = false;
  bool quiet = false;
  std::string color = "auto";
  std::string progress = "auto";  // --progress of verbs with long work: see progress.h
  std::vector<std::string> read;  // inputs that the line does not name, which -o must not be written over
};

/// Adds --format (one of `formats`; by default the form of the ending of -o, else the first), -o, --force, -q
/// and --color.
void add_output_options(Command verb, OutputArguments& arguments, const std::vector<std::string>& formats);

/// Whether the data go to standard output.
bool is_standard_output(const OutputArguments& arguments);

/// Whether the output may have 24-bit colours. --color decides where it is "always" or "never", then NO_COLOR
/// and CLICOLOR_FORCE. Else a terminal gets colours, unless CLICOLOR=0 or TERM=dumb.
bool use_color(const OutputArguments& arguments);

/// The data of the run as an output to the file of -o or to standard output. Throws Error.
///   most_mode   permissions beyond these are taken away from the file (strictest_mode)
/// Among several outputs it must be the last: data that a pipe has taken cannot be taken back, so the others must be ready
/// by then; where standard output cannot be written, they are not put in place.
std::unique_ptr<Output> output(const OutputArguments& arguments, std::string bytes,
                               unsigned most_mode = 0777);

/// Writes the data of the run at once to the file of -o or to standard output. Throws Error.
void write_output(const OutputArguments& arguments, std::string_view bytes);

/// Writes "etak: " and the message as one line to standard error. line_text() keeps it to one line, because
/// messages hold names of files, options and keys.
void complain(std::string_view message);

/// Writes a remark in the same way as complain(), unless -q is given.
void remark(const OutputArguments& arguments, std::string_view message);

/// The number of columns for text on `descriptor` (standard_output of core/base/system.h): COLUMNS of the environment
/// where it is a number above 0, else the width of the terminal. 0 where neither is known: lines are then not
/// broken, as in files and pipes.
std::size_t columns_of(int descriptor);

}  // namespace etak::cli
