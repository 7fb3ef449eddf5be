// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/option_table.h"

namespace etak::cli {

/// Completion scripts made of the option table: verbs, options, words of options, files, and the names that
/// `etak completion --words KIND` prints when asked.

/// For bash 4 and newer, such as in share/bash-completion/completions/etak.
std::string bash_completion(const std::vector<VerbRow>& table);

/// For zsh, such as in a file _etak of $fpath.
std::string zsh_completion(const std::vector<VerbRow>& table);

/// For fish 3 and newer, such as in share/fish/vendor_completions.d/etak.fish.
std::string fish_completion(const std::vector<VerbRow>& table);

/// The manual page of section 1 of `verb`, of etak itself where it is empty, in the man macros of roff. Without a
/// date, so that the page is that of the program alone. Throws Error for a verb that the table does not have.
std::string manual_page(const std::vector<VerbRow>& table, std::string_view verb);

}  // namespace etak::cli
