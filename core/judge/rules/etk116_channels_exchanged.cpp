// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <optional>

#include "core/judge/rules/rows.h"

namespace etak {

namespace {

/// The channel of one quantity in a packed picture.
struct PackedChannel {
  const DataCodes& codes;
  std::size_t index;

  // Share of the texels at one of the ends, as metallic is but for filtered edges.
  double ends() const { return codes.share(index, 0, 12) + codes.share(index, 243, 255); }
  double black() const { return codes.share(index, 0, 25); }
  double white() const { return codes.share(index, 254, 255); }
  // The codes between which all but a hundredth of the texels lie.
  bool varies() const {
    int first = 0, last = 255;
    while (first < 255 && codes.share(index, 0, first) < 0.005) ++first;
    while (last > 0 && codes.share(index, last, 255) < 0.005) --last;
    return last - first >= 2;  // JPEG takes most of a noise away, and keeps one value as it is
  }
};

struct Exchange {
  std::string_view one, other, why;
};

// Two channels that cannot be what they are taken for, and can be each other.
std::optional<Exchange> exchange_in(const std::optional<PackedChannel>& occlusion,
                                    const PackedChannel& roughness, const PackedChannel& metallic) {
  constexpr double most = 0.8, few = 0.05;
  if (roughness.ends() >= most && metallic.ends() < 0.6 && metallic.varies())
    return Exchange{"roughness", "metallic", "roughness is 0 or 1 all over, and metallic lies between"};
  if (!occlusion) return std::nullopt;
  const bool is_metal_all_over = metallic.codes.share(metallic.index, 128, 255) >= 0.9;
  if (is_metal_all_over && occlusion->ends() >= most &&
      (occlusion->black() >= 0.95 || (occlusion->black() >= few && metallic.varies())))
    return Exchange{"occlusion", "metallic", "no light at all reaches a part of what is metal all over"};
  if (roughness.white() >= 0.25 && occlusion->white() <= few && occlusion->black() <= few &&
      occlusion->varies())
    return Exchange{"occlusion", "roughness",
                    "next to nothing is open to light, and a quarter or more is of roughness 1"};
  return std::nullopt;
}

}  // namespace

constinit const Rule etk116_channels_exchanged{
    .id = "ETK116",
    .slug = "channels-exchanged",
    .title = "Two channels of a packed picture are exchanged",
    .severity = Severity::error,
    .needs = {Need::metal_rough},
    .source = "etak: right sets of eight kinds of surface, and the same with two channels exchanged",
    .what =
        "Of occlusion, roughness and metallic in one picture, two cannot be what the picture's name says and can be each other: roughness that is 0 or 1 on 80 % beside metallic that lies between on 40 %; "
        "occlusion of 0 and 1 alone beside metallic above one half on 90 %; occlusion with at most 5 % of open texels beside roughness of 1 on a quarter. On a metal all over, occlusion and metallic are "
        "both about 1, and their exchange changes nothing.",
    .why =
        "A shader reads one quantity for another: dielectrics shine as metals, or highlights lie where light should be held off.",
    .example = "A picture packed in the order of another engine: ORM for RMA.",
    .fix = "Pack the channels in the order that the name says, or name the picture after its order.",
    .check = [](RuleCheck& check) {
      for (const PictureEvidence& picture : check.evidence.headers) {
        if (picture.role != FileRole::metal_rough || !picture.data) continue;
        const std::string_view letters =
            picture.channels.empty() ? "-rm-" : std::string_view(picture.channels);
        const auto channel = [&](std::string_view any) -> std::optional<PackedChannel> {
          const std::size_t at = letters.find_first_of(any);
          if (at > 2) return std::nullopt;
          return PackedChannel{*picture.data, at};
        };
        const auto occlusion = channel("o"), roughness = channel("rs"), metallic = channel("m");
        if (!roughness || !metallic) continue;
        const auto found = exchange_in(occlusion, *roughness, *metallic);
        if (!found) continue;
        Finding& finding = check.report(picture);
        finding.value = std::string(found->one) + " and " + std::string(found->other) + " exchanged";
        finding.limit = "the order of the name";
        finding.message = std::string(found->one) + " and " + std::string(found->other) +
                          " are exchanged: " + std::string(found->why);
      }
    }};

}  // namespace etak
