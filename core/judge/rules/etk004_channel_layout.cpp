// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

void etk004(RuleCheck& check) {
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
        (h.palette ? "a palette" : std::to_string(h.channels) + " channel" + (h.channels == 1 ? "" : "s")) +
        ", expected " + finding.limit;
  }
}

}  // namespace

constinit const Rule etk004_channel_layout{
    "ETK004",
    "channel-layout",
    "The channels are not those of the role",
    Severity::warning,
    Severity::error,
    {Need::header},
    {},
    "Schueler 2009",
    "A diffuse or specular picture without four channels, a palette picture, or grey where "
    "colour is expected.",
    "A missing fourth channel means no alpha or no gloss; a palette holds at most 256 "
    "colours of a texture.",
    "Specular saved as RGB: gloss is lost. A colour picture saved as 'indexed'.",
    "Save as RGBA, 8 bits a channel or more.",
    &etk004};

}  // namespace etak
