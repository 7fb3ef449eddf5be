// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk901_internal_error{
    "ETK901",
    "internal-error",
    "The validator failed",
    Severity::error,
    Severity::error,
    {},
    {},
    "etak",
    "A rule or reader failed in a way that is etak's own mistake. Exit status 2; file and "
    "rule are named.",
    "What was not checked must not pass for clean.",
    "An exception inside a rule.",
    "Please report it with the file.",
    nullptr};

}  // namespace etak
