// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk903_unused_suppression{
    "ETK903",
    "unused-suppression",
    "An allow entry matches nothing",
    Severity::warning,
    Severity::error,
    {},
    {},
    "etak",
    "An [[allow]] entry of the configuration suppressed no finding, or has expired.",
    "Entries that outlive their reason hide the next mistake.",
    "The file was renamed, or the defect repaired.",
    "Remove the entry, or correct its pattern.",
    nullptr};

}  // namespace etak
