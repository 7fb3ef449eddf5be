// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk904_unknown_rule{
    .id = "ETK904",
    .slug = "unknown-rule",
    .title = "The configuration names no rule",
    .severity = Severity::error,
    .source = "etak",
    .what = "An id or prefix in the configuration or on the command line that no rule has. Exit status 2.",
    .why = "A misspelt id has no effect.",
    .example = "ETK11O with the letter O.",
    .fix = "etak validate --list-rules prints all ids.",
};

}  // namespace etak
