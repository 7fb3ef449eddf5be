// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace etak::cli {

struct OutputArguments;

/// Settles the form of the output once the line is read: the form of --format, else that of the ending of -o,
/// else the first of `formats`. A file without an ending, standard output and pipes have no ending to decide.
/// A remark tells the user where --format and the ending differ. Throws Error for an ending that belongs to
/// none of `formats`.
///   verb    as the user types it: "etak f0"
///   given   --format stands on the line
void settle_form(OutputArguments& arguments, const std::vector<std::string>& formats, const std::string& verb,
                 bool given);

/// Throws Error for a form that the rest of the line does not allow. The message names --format and the forms
/// that are allowed, or -o, its ending and the endings that are allowed.
///   verb     as above
///   beside   the part of the line that does not allow the form: "without names", "with --to gltf"
///   forms    the forms that are allowed
///   else_    what would make this form allowed; may be empty
[[noreturn]] void refuse_form(const OutputArguments& arguments, const std::string& verb,
                              const std::string& beside, const std::vector<std::string>& forms,
                              const std::string& else_ = {});

}  // namespace etak::cli
