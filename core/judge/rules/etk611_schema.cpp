// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

void etk611(RuleCheck& check) {
  const auto& material = check.evidence.material;
  if (!material) return;
  if (material->schema_error.empty()) return;
  Finding& finding = check.report();
  finding.pointer = material->schema_pointer;
  finding.message = material->schema_error;
}

}  // namespace

constinit const Rule etk611_schema{
    "ETK611",
    "schema",
    "The file does not follow its schema",
    Severity::error,
    Severity::error,
    {Need::material},
    {},
    "resources/schema/material.schema.json",
    "A material file that the strict reader refuses: unknown or missing keys, wrong types, "
    "twice the same key.",
    "What is misspelt is not read.",
    "\"licens\" for \"licence\".",
    "Correct the file at the pointer that the message names.",
    &etk611};

}  // namespace etak
