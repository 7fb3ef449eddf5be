// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk405_linear8_f0{
    .id = "ETK405",
    .slug = "linear8-f0",
    .title = "F0 in 8-bit linear codes",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::header},
    .source =
        "Largest half-step error at F0 0.02 / 0.04 / 0.08: linear 9.8 / 4.9 / 2.5 %, sRGB 2.3 / 1.7 / 1.3 %, exponent 2.2 2.6 / 1.9 / 1.4 % (etak)",
    .what = "F0 is declared to be linear, by the file, the layout or the settings, and stored in 8 bits.",
    .why = "F0 of dielectrics is 5 to 20 of 255 steps then, wrong by up to 10 %.",
    .example = "An engine set to import specular as linear data.",
    .fix = "Store F0 with the sRGB curve, or with 16 bits.",
    .check = [](RuleCheck& check) {
      const auto& b = check.evidence.b;
      if (!b || b->header.bits != 8 || b->header.floating || check.evidence.metal_rough) return;
      const auto& stated = check.target.manifest.transfer;
      const bool linear = check.target.manifest.linear8_f0 ||
                          (stated ? *stated : check.settings.transfer) == TextureTransfer::linear ||
                          b->header.colour_space == "linear";
      if (!linear) return;
      Finding& finding = check.report(*b);
      finding.value = "8-bit linear";
      finding.message = "F0 is declared to be linear in 8 bits: up to 10 % wrong at F0 0.02";
    }};

}  // namespace etak
