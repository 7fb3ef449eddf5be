// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk407_albedo_stored_linear{
    .id = "ETK407",
    .slug = "albedo-stored-linear",
    .title = "Diffuse is declared linear",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::header},
    .source = "etak: dark albedo is legal, so brightness alone says nothing",
    .what =
        "The diffuse file declares a linear colour space while its codes are taken as sRGB. ETK404 judges the histogram.",
    .why = "Codes and curve do not match.",
    .example = "An albedo saved from a linear working space with its tag.",
    .fix = "Convert to sRGB on export, or remove a wrong tag.",
    .check = [](RuleCheck& check) {
      const auto& a = check.evidence.a;
      if (!a || a->header.floating || a->header.colour_space != "linear" ||
          check.settings.transfer == TextureTransfer::linear)
        return;
      Finding& finding = check.report(*a);
      finding.value = "declared linear";
      finding.limit = name(check.settings.transfer);
      finding.message = "diffuse is declared linear and read as " + finding.limit;
    }};

}  // namespace etak
