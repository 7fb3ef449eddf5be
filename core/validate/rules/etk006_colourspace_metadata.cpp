// SPDX-License-Identifier: Apache-2.0
#include "core/validate/rules/rows.h"

namespace etak {

namespace {

void etk006(RuleCheck& check) {
  for (const PictureEvidence& picture : check.evidence.headers) {
    const std::string& declared = picture.header.colour_space;
    if (declared.empty() || picture.header.floating) continue;
    // Roughness and metallic never have a curve; PNG's sRGB chunk on them is common and wrong.
    const bool data = picture.role >= FileRole::metal_rough && picture.role <= FileRole::roughness;
    const std::string expected(data ? "linear" : name(check.settings.transfer));
    if (declared == expected || declared.starts_with("icc") || (declared == "gamma22" && expected == "srgb"))
      continue;
    Finding& finding = check.report(picture);
    finding.value = declared;
    finding.limit = expected;
    finding.message =
        "declares \"" + declared + "\", but " + std::string(name(picture.role)) + " is taken as " + expected;
  }
}

}  // namespace

constinit const Rule etk006_colourspace_metadata{
    "ETK006",
    "colourspace-metadata",
    "The declared colour space contradicts the role",
    Severity::warning,
    Severity::error,
    {Need::header},
    {},
    "glTF-Validator, IMAGE_FEATURES_UNSUPPORTED",
    "The file declares a linear or other curve where codes are taken as sRGB (or another "
    "transfer), or sRGB where the role is plain data, as roughness and metallic are.",
    "Programs that obey the declaration and programs that ignore it show different materials.",
    "A gAMA chunk of 1.0 left in a specular map by a compositor.",
    "Remove the declaration or convert the codes to what it says.",
    &etk006};

}  // namespace etak
