// SPDX-License-Identifier: Apache-2.0
#include "core/image/dilate.h"
#include "core/judge/pixels/code_tables.h"
#include "core/validate/repairs/rows.h"

namespace etak {

namespace {

constexpr int fringe_width = 2;  // texels, as far as ETK502 looks

// A texel is hidden where rules see alpha 0, which rounding to 8 bits decides.
class HiddenTexels {
 public:
  explicit HiddenTexels(const RepairPicture& a) : hidden_(a.codes.pixel_count()) {
    const auto channels = static_cast<std::size_t>(a.codes.channels);
    for (std::size_t i = 0; i < hidden_.size(); ++i)
      hidden_[i] = 255 * a.value(a.codes.values[i * channels + channels - 1]) < 0.5;
  }
  bool operator[](std::size_t i) const { return hidden_[i] != 0; }

 private:
  std::vector<char> hidden_;
};

// Colour from the visible texels around, by pull-push on values of the kind that `in` makes of a code.
// Visible texels and all alphas stay.
template <class Value, class In, class Out>
void bleed_as(RepairPicture& a, const HiddenTexels& hidden, Value full, const In& in, const Out& out) {
  const std::size_t colours = a.colour_channels();
  Pixels<Value> whole(a.codes.width, a.codes.height, 4);
  for (std::size_t i = 0; i < whole.pixel_count(); ++i) {
    const auto texel = a.texel(i);
    for (std::size_t c = 0; c < 3; ++c) whole.values[4 * i + c] = in(texel[colours == 3 ? c : 0]);
    whole.values[4 * i + 3] = hidden[i] ? Value{} : full;
  }
  Pixels<Value> nothing;
  bleed_under_alpha(whole, nothing);
  for (std::size_t i = 0; i < whole.pixel_count(); ++i)
    for (std::size_t c = 0; hidden[i] && c < colours; ++c) a.texel(i)[c] = out(whole.values[4 * i + c]);
}

void bleed_colour(RepairPicture& a, const HiddenTexels& hidden, TextureTransfer transfer) {
  const auto is_byte = a.most == 255 && transfer == TextureTransfer::srgb;
  if (is_byte)
    return bleed_as(
        a, hidden, std::uint8_t{255}, [](std::uint16_t code) { return static_cast<std::uint8_t>(code); },
        [](std::uint8_t code) { return std::uint16_t{code}; });
  bleed_as(
      a, hidden, 1.0f,
      [&](std::uint16_t code) { return static_cast<float>(decode_of(transfer, a.value(code))); },
      [&](float light) { return a.code(encode_of(transfer, std::clamp(double{light}, 0.0, 1.0))); });
}

// Hidden texels that filtering reads beside visible ones get the channels [first, last) of the nearest of them.
void repeat_edge(RepairPicture& picture, const HiddenTexels& hidden, std::size_t first, std::size_t last) {
  const int width = picture.codes.width, height = picture.codes.height;
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (!hidden[index(x, y)]) continue;
      int least = 2 * fringe_width * fringe_width + 1;
      std::size_t nearest = 0;
      for (int v = std::max(0, y - fringe_width); v <= std::min(height - 1, y + fringe_width); ++v)
        for (int u = std::max(0, x - fringe_width); u <= std::min(width - 1, x + fringe_width); ++u) {
          const int distance = (u - x) * (u - x) + (v - y) * (v - y);
          if (hidden[index(u, v)] || distance >= least) continue;
          least = distance;
          nearest = index(u, v);
        }
      if (least > 2 * fringe_width * fringe_width) continue;
      const auto from = picture.texel(nearest), to = picture.texel(index(x, y));
      std::copy(from.begin() + static_cast<std::ptrdiff_t>(first),
                from.begin() + static_cast<std::ptrdiff_t>(last),
                to.begin() + static_cast<std::ptrdiff_t>(first));
    }
}

RepairOutcome bleed_hidden(const RepairBench& bench) {
  RepairPicture* a = bench.with_role({FileRole::diffuse_alpha, FileRole::base_color});
  if (a == nullptr || a->codes.channels % 2 != 0) return {"", "alpha is in no channel of the file"};
  const HiddenTexels hidden(*a);
  bleed_colour(*a, hidden, bench.settings.transfer);
  repeat_edge(*a, hidden, 0, a->colour_channels());
  // Filtering mixes base colour and metallic, each by itself; the rule sees the diffuse colour of both.
  RepairPicture* metal = bench.with_role({FileRole::metallic, FileRole::metal_rough});
  if (metal != nullptr && metal->codes.width == a->codes.width && metal->codes.height == a->codes.height) {
    const auto [first, last] = metallic_channels(*metal);
    repeat_edge(*metal, hidden, first, last);
  }
  return {"let visible colour bleed under alpha 0"};
}

}  // namespace

constinit const Repair repair_etk502{"ETK502", &bleed_hidden};

}  // namespace etak
