// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

// Roughness and metallic are one number a texel: another picture stands in their place where the channels differ.
void report_colours(RuleCheck& check, const PictureEvidence& picture) {
  if (!picture.data || picture.data->texels == 0) return;
  const double share =
      static_cast<double>(picture.data->coloured) / static_cast<double>(picture.data->texels);
  if (share < check.parameter("coloured_share")) return;
  Finding& finding = check.report(picture);
  finding.severity = check.at_least(Severity::error);
  finding.area_share = share;
  finding.value = "channels differ on " + percent(share);
  finding.limit = "equal channels";
  finding.message = std::string(name(picture.role)) +
                    " picture holds colours: its channels differ by more than 10 codes on " + percent(share) +
                    " of the texels";
  finding.cause = "possible cause: a colour or normal map, or a packed picture, in the place of " +
                  std::string(name(picture.role));
  finding.fix = "Put the grey picture there, or name the picture after what it holds.";
}

}  // namespace

constinit const Rule etk004_channel_layout{
    .id = "ETK004",
    .slug = "channel-layout",
    .title = "The channels are not those of the role",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::header},
    .parameters =
        {{"coloured_share", 0.1, 0.1, "",
          "share of the texels of a roughness or metallic picture from which colours are an error"}},
    .source = "Schueler 2009",
    .what =
        "A diffuse or specular picture without four channels, a palette picture, or grey where colour is expected. An error: roughness or metallic, each in a file of its own, whose three channels differ by more than 10 codes on a tenth of the texels.",
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
        if (grey) report_colours(check, picture);
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
