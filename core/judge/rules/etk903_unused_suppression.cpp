// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk903_unused_suppression{
    .id = "ETK903",
    .slug = "unused-suppression",
    .title = "An allow entry matches nothing",
    .severity = {Severity::warning, Severity::error},
    .source = "etak",
    .what = "An [[allow]] entry of the configuration suppressed no finding, or has expired.",
    .why = "Entries that outlive their reason hide the next mistake.",
    .example = "The file was renamed, or the defect repaired.",
    .fix = "Remove the entry, or correct its pattern.",
};

}  // namespace etak
