// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk902_rule_skipped{
    .id = "ETK902",
    .slug = "rule-skipped",
    .title = "A rule was not run",
    .severity = Severity::warning,
    .source = "etak",
    .what =
        "A rule was left out because of a limit of memory or time, or because what it needs is not there.",
    .why = "A rule that did not run has found nothing, which is not the same as nothing being there.",
    .example = "A picture of more than 16,384 texels a side.",
    .fix = "Raise the limit, or check the file in parts.",
};

}  // namespace etak
