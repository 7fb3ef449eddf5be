// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

void etk010(RuleCheck& check) {
  for (const TargetFile& file : check.target.files) {
    if (!file.guessed) continue;
    Finding& finding = check.report();
    finding.file = file.label;
    finding.value = name(file.role);
    finding.message = "taken for a " + finding.value + " picture because of its name";
  }
}

}  // namespace

constinit const Rule etk010_role_guessed{
    "ETK010",
    "role-guessed",
    "The role was taken from the file name",
    Severity::info,
    Severity::warning,
    {},
    {},
    "etak",
    "What the picture holds is stated nowhere; its role was taken from its name.",
    "A wrong guess makes every other verdict on the file meaningless.",
    "metal_spec_sheet.png, a picture of a document, taken for a specular map.",
    "Name the role: --role, [roles] in etak.toml, or a layout.",
    &etk010};

}  // namespace etak
