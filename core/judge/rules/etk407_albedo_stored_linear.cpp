// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

void etk407(RuleCheck& check) {
  const auto& a = check.evidence.a;
  if (!a || a->header.floating || a->header.colour_space != "linear" ||
      check.settings.transfer == TextureTransfer::linear)
    return;
  Finding& finding = check.report(*a);
  finding.value = "declared linear";
  finding.limit = name(check.settings.transfer);
  finding.message = "diffuse is declared linear and read as " + finding.limit;
}

}  // namespace

constinit const Rule etk407_albedo_stored_linear{
    "ETK407",
    "albedo-stored-linear",
    "Diffuse is declared linear",
    Severity::info,
    Severity::warning,
    {Need::header},
    {},
    "etak: dark albedo is legal, so brightness alone says nothing",
    "The diffuse file declares a linear colour space while its codes are taken as sRGB. "
    "ETK404 judges the histogram.",
    "Codes and curve do not match.",
    "An albedo saved from a linear working space with its tag.",
    "Convert to sRGB on export, or remove a wrong tag.",
    &etk407};

}  // namespace etak
