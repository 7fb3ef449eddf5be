// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/option_table.h"

namespace etak::cli {

/// The manual page of section 1 of `verb`, of etak itself where it is empty, in the man macros of roff. Without a
/// date, so that the page is that of the program alone. Throws Error for a verb that the table does not have.
std::string manual_page(const std::vector<VerbRow>& table, std::string_view verb);

}  // namespace etak::cli
