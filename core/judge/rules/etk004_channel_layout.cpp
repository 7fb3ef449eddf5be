// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk004_channel_layout{
    .id = "ETK004",
    .slug = "channel-layout",
    .title = "The channels are not those of the role",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::header},
    .source = "Schueler 2009",
    .what =
        "A diffuse or specular picture without four channels, a palette picture, or grey where colour is expected.",
    .why =
        "A missing fourth channel means no alpha or no gloss; a palette holds at most 256 colours of a texture.",
    .example = "Specular saved as RGB: gloss is lost. A colour picture saved as 'indexed'.",
    .fix = "Save as RGBA, 8 bits a channel or more.",
    .check = [](RuleCheck& check) {
      for (const PictureEvidence& picture : check.evidence.headers) {
        const PictureHeader& h = picture.header;
        const bool pair = picture.role == FileRole::diffuse_alpha || picture.role == FileRole::specular_gloss;
        const bool grey = picture.role == FileRole::metallic || picture.role == FileRole::roughness;
        const int wanted = pair ? 4 : grey ? 1 : 3;
        if (!h.palette && h.channels >= wanted) continue;
        Finding& finding = check.report(picture);
        finding.value = h.palette ? "palette" : std::to_string(h.channels) + " channels";
        finding.limit = std::to_string(wanted) + " channels";
        finding.message =
            std::string(name(picture.role)) + " picture has " +
            (h.palette ? "a palette"
                       : std::to_string(h.channels) + " channel" + (h.channels == 1 ? "" : "s")) +
            ", expected " + finding.limit;
      }
    }};

}  // namespace etak
