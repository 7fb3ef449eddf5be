// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk901_internal_error{
    .id = "ETK901",
    .slug = "internal-error",
    .title = "The validator failed",
    .severity = Severity::error,
    .source = "etak",
    .what =
        "A rule or reader failed in a way that is etak's own mistake. Exit status 2; file and rule are named.",
    .why = "What was not checked must not pass for clean.",
    .example = "An exception inside a rule.",
    .fix = "Please report it with the file.",
};

}  // namespace etak
