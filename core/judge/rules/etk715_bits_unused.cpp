// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk715_bits_unused{
    .id = "ETK715",
    .slug = "bits-unused",
    .title = "A picture of 16 bits holds what 8 bits hold",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::wide},
    .source = "PNG specification, 13.12: 8 bits become 16 by repeating or by zeros",
    .what =
        "All values of a picture of 16 bits are multiples of 257, or all of 256, and there are two or more of them.",
    .why =
        "The file takes twice the space for nothing. What was cut to 8 bits before stays cut: heights and normals show steps.",
    .example = "A height map that went through an 8-bit program, saved again at 16 bits.",
    .fix = "Export it again from what has 16 bits, or save it with 8.",
    .check = [](RuleCheck& check) {
      for (const PictureLook& look : check.evidence.looks) {
        if (!look.narrow) continue;
        Finding& finding = check.report();
        finding.file = look.label;
        finding.value = "values of 8 bits";
        finding.limit = "values between them";
        finding.message = "the file has 16 bits a value, and every value is one of 8 bits";
      }
    }};

}  // namespace etak
