// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace etak::cli {

struct OutputArguments;

/// Settles the form of the output once the line is read: that of --format, else of the ending of -o, else the
/// first of `formats`. A file without an ending, standard output and pipes say nothing. A form that --format
/// asks for in spite of the ending is told. Throws Error for an ending that none of `formats` goes with.
///   verb    as it is typed: "etak f0"
///   given   --format stands on the line
void settle_form(OutputArguments& arguments, const std::vector<std::string>& formats, const std::string& verb,
                 bool given);

}  // namespace etak::cli
