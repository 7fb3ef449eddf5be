// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk611_schema{
    .id = "ETK611",
    .slug = "schema",
    .title = "The file does not follow its schema",
    .severity = Severity::error,
    .needs = {Need::material},
    .source = "resources/schema/material.schema.json",
    .what =
        "A material file that the strict reader refuses: unknown or missing keys, wrong types, twice the same key.",
    .why = "What is misspelt is not read.",
    .example = "\"licens\" for \"licence\".",
    .fix = "Correct the file at the pointer that the message names.",
    .check = [](RuleCheck& check) {
      const auto& material = check.evidence.material;
      if (!material) return;
      if (material->schema_error.empty()) return;
      Finding& finding = check.report();
      finding.pointer = material->schema_pointer;
      finding.message = material->schema_error;
    }};

}  // namespace etak
