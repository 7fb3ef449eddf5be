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

/// Throws Error for a form that does not go with the rest of the line. It names --format and the forms that
/// would go, or -o, its ending and the endings that would.
///   verb     as above
///   beside   what the form does not go with: "without names", "with --to gltf"
///   forms    those that go
///   else_    what would make this form go; may be empty
[[noreturn]] void refuse_form(const OutputArguments& arguments, const std::string& verb,
                              const std::string& beside, const std::vector<std::string>& forms,
                              const std::string& else_ = {});

}  // namespace etak::cli
