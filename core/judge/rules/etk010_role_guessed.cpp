// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk010_role_guessed{
    .id = "ETK010",
    .slug = "role-guessed",
    .title = "The role was taken from the file name",
    .severity = {Severity::info, Severity::warning},
    .source = "etak",
    .what = "What the picture holds is stated nowhere; its role was taken from its name.",
    .why = "A wrong guess makes every other verdict on the file meaningless.",
    .example = "metal_spec_sheet.png, a picture of a document, taken for a specular map.",
    .fix = "Name the role: --role, [roles] in etak.toml, or a layout.",
    .check = [](RuleCheck& check) {
      for (const TargetFile& file : check.target.files) {
        if (!file.guessed) continue;
        Finding& finding = check.report();
        finding.file = file.label;
        finding.value = name(file.role);
        finding.message = "taken for a " + finding.value + " picture because of its name";
      }
    }};

}  // namespace etak
