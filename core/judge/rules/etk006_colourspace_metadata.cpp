// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk006_colourspace_metadata{
    .id = "ETK006",
    .slug = "colourspace-metadata",
    .title = "The declared colour space contradicts the role",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::header},
    .source = "glTF-Validator, IMAGE_FEATURES_UNSUPPORTED; profiles by ICC.1:2010",
    .what =
        "The file declares a linear or other curve where codes are taken as sRGB (or another transfer), or sRGB where the role is plain data, as roughness and metallic are. Or a colour profile in it, or a cICP or cHRM chunk of PNG, "
        "declares other primaries than sRGB's, such as Display P3 or Adobe RGB. A profile is judged by its curves and primaries, not by its name: curves within 2 codes of sRGB's are sRGB. One of tables "
        "(A2B0) in place of curves is not judged, nor one on plain data, where editors of pictures leave it.",
    .why = "Programs that obey the declaration and programs that ignore it show different materials.",
    .example = "A gAMA chunk of 1.0 left in a specular map by a compositor.",
    .fix = "Remove the declaration or convert the codes to what it says.",
    .check = [](RuleCheck& check) {
      for (const PictureEvidence& picture : check.evidence.headers) {
        if (picture.header.floating) continue;
        const std::string &curve = picture.header.colour_space, &primaries = picture.header.primaries;
        const std::string role(name(picture.role));
        // Roughness and metallic have no curve; an sRGB chunk of PNG on them is common and wrong. Colour profiles
        // on them are let pass, because editors of pictures put them into all files, and so are profiles whose
        // curves cannot be read.
        const bool data = traits(picture.role).data && picture.role != FileRole::gloss;
        const std::string expected(data ? "linear" : name(check.settings.transfer));
        const bool right_curve = curve.empty() || curve == expected || curve.starts_with("icc") ||
                                 (data && !primaries.empty()) || (curve == "power-2.2" && expected == "srgb");
        const bool right_primaries = data || primaries.empty() || primaries == "sRGB" || primaries == "greys";
        if (right_curve && right_primaries) continue;
        Finding& finding = check.report(picture);
        if (!right_curve) {
          finding.value = curve;
          finding.limit = expected;
          finding.message = "declares \"" + curve + "\", but " + role + " is taken as " + expected;
        }
        if (right_primaries) continue;
        if (right_curve) {
          finding.value = primaries;
          finding.limit = "primaries of sRGB";
        }
        finding.message += (right_curve ? "declares" : "; and it declares") +
                           std::string(" the primaries of ") + primaries + ", but " + role +
                           " is taken for colours of sRGB";
      }
    }};

}  // namespace etak
