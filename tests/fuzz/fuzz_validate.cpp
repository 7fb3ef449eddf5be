// SPDX-License-Identifier: Apache-2.0
// Whatever the texels, and whatever a layout says of them: the rules answer, and never with an internal
// error. Up to the first NUL an input is a layout; then come a byte for the settings, two for the picture's
// sides, and texels, which repeat to the end of the picture. Pictures are small and one thread checks them,
// because what finds something is many inputs; that several threads find the same, and the pictures of
// regions, are asked of a few inputs.
#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/judge/check_pictures.h"
#include "core/judge/engine.h"
#include "core/validate/files/layout_targets.h"

using namespace etak;

namespace {

constexpr int least_side = 4, most_side = 16;

Image8 picture(int width, int height, int channels, std::string_view bytes, std::size_t from) {
  Image8 out(width, height, channels);
  for (std::size_t i = 0; i < out.values.size(); ++i)
    out.values[i] = bytes.empty() ? 0 : static_cast<std::uint8_t>(bytes[(from + i) % bytes.size()]);
  return out;
}

void check_all(const CheckTarget& target, std::string_view rest) {
  const auto byte = [&](std::size_t i) { return i < rest.size() ? static_cast<std::uint8_t>(rest[i]) : 0; };
  Settings settings;
  if ((byte(0) & 1) != 0) settings.profile = Profile::strict;
  if ((byte(0) & 2) != 0) settings.zone.metric = ZoneMetric::max;
  if ((byte(0) & 4) != 0) settings.alpha_is_transparency = true;
  settings.zone.erode = 1 + 2 * ((byte(0) >> 3) % 3);
  const bool metal_rough = (byte(0) & 64) != 0;
  const int width = least_side + byte(1) % (most_side - least_side + 1),
            height = least_side + byte(2) % (most_side - least_side + 1);
  const std::string_view texels = rest.substr(std::min<std::size_t>(3, rest.size()));
  const Pictures pictures{picture(width, height, 4, texels, 0),
                          picture(width, height, 4, texels, texels.size() / 2),
                          metal_rough ? picture(width, height, 1, texels, 7) : Image8()};
  const CheckedFile one = check_pictures(target, pictures, settings, 1);
  assert(std::ranges::none_of(one.findings, [](const Finding& f) { return f.rule == "ETK901"; }));
  if (byte(0) == 0xff && byte(1) % 16 == 7) {
    const CheckedFile three = check_pictures(target, pictures, settings, 3);
    assert(one.findings == three.findings && one.counts == three.counts);
  }
  if ((byte(0) & 0x80) != 0 && byte(1) % 16 == 3) {
    const Image8 regions = region_picture(RegionKind::zone, pictures, target, settings);
    assert(regions.width == width && regions.height == height);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(input.find('\0'), size);
  const std::string_view rest = input.substr(std::min(end + 1, size));
  CheckTarget plain;
  try {
    const auto targets =
        targets_of_layout_text(std::string(input.substr(0, end)), "layout.json", "layout.json");
    if (targets.empty()) return 0;
    // One page of it; which one, the first texel says.
    const std::size_t which = rest.size() > 3 ? static_cast<std::uint8_t>(rest[3]) : 0;
    check_all(targets[which % targets.size()], rest);
    return 0;
  } catch (const Error&) {
    // no layout: the pictures alone
  }
  check_all(plain, rest);
  return 0;
}
