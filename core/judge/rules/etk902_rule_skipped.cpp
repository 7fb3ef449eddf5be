// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk902_rule_skipped{
    "ETK902",
    "rule-skipped",
    "A rule was not run",
    Severity::warning,
    Severity::warning,
    {},
    {},
    "etak",
    "A rule was left out because of a limit of memory or time, or because what it needs is "
    "not there.",
    "A rule that did not run has found nothing, which is not the same as nothing being there.",
    "A picture of more than 16,384 texels a side.",
    "Raise the limit, or check the file in parts.",
    nullptr};

}  // namespace etak
