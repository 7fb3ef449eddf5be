// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk904_unknown_rule{
    "ETK904",
    "unknown-rule",
    "The configuration names no rule",
    Severity::error,
    Severity::error,
    {},
    {},
    "etak",
    "An id or prefix in the configuration or on the command line that no rule has. Exit "
    "status 2.",
    "A misspelt id has no effect.",
    "ETK11O with the letter O.",
    "etak validate --list-rules prints all ids.",
    nullptr};

}  // namespace etak
