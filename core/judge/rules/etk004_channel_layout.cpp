// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

// Roughness, metallic and occlusion are one number a texel: another picture stands in their place where the channels
// differ.
//   coloured   of that many texels of `texels` they do
template <class Place>
void report_colours(RuleCheck& check, const Place& place, std::uint64_t coloured, std::uint64_t texels) {
  const double share = texels == 0 ? 0 : static_cast<double>(coloured) / static_cast<double>(texels);
  if (texels == 0 || share < check.parameter("coloured_share")) return;
  Finding& finding = check.report(place);
  finding.severity = check.at_least(Severity::error);
  finding.area_share = share;
  finding.value = "channels differ on " + percent(share);
  finding.limit = "equal channels";
  finding.message = std::string(name(place.role)) +
                    " picture holds colours: its channels differ by more than 10 codes on " + percent(share) +
                    " of the texels";
  finding.cause = "possible cause: a colour or normal map, or a packed picture, in the place of " +
                  std::string(name(place.role));
  finding.fix = "Put the grey picture there, or name the picture after what it holds.";
}

// Colours become brighter and darker, normals turn.
void report_normals(RuleCheck& check, const PictureEvidence& picture) {
  if (!are_normals(picture.data->normals)) return;
  Finding& finding = check.report(picture);
  finding.severity = check.at_least(Severity::error);
  finding.area_share = picture.data->normals.unit_share();
  finding.value = "normals";
  finding.limit = "colours";
  finding.message = std::string(name(picture.role)) +
                    " picture holds normals: " + percent(finding.area_share) +
                    " of the texels are vectors of length 1";
  finding.cause = "possible cause: the normal map of the set in the place of its colours";
  finding.fix = "Put the colours there, or name the picture after what it holds.";
}

}  // namespace

constinit const Rule etk004_channel_layout{
    .id = "ETK004",
    .slug = "channel-layout",
    .title = "The channels are not those of the role",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::header, Need::maps},
    .parameters =
        {{"coloured_share", 0.1, 0.1, "",
          "share of the texels of a roughness, metallic or occlusion picture from which colours are an error"}},
    .source = "Schueler 2009",
    .what =
        "A diffuse or specular picture without four channels, a palette picture, or grey where colour is expected. An error: roughness, metallic or occlusion, each in a file of its own, whose three channels differ by more than 10 codes on a tenth of the texels; and a base colour, or diffuse with gloss in a file of its own, whose texels are normals.",
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
        if (picture.data && grey)
          report_colours(check, picture, picture.data->coloured, picture.data->texels);
        if (picture.data && picture.role == FileRole::base_color) report_normals(check, picture);
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
      for_each_map(check, FileRole::occlusion, [&](const MapEvidence& map) {
        report_colours(check, map, map.grey.coloured, map.grey.texels);
      });
    }};

}  // namespace etak
