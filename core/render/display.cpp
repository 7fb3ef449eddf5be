// SPDX-License-Identifier: Apache-2.0
#include "core/render/display.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/color/srgb.h"
#include "core/math/functions.h"

namespace etak {
namespace {

constexpr std::array<std::pair<Transfer, std::string_view>, 5> names{{{Transfer::srgb, "srgb"},
                                                                      {Transfer::power_22, "power-2.2"},
                                                                      {Transfer::power_045, "power-0.45"},
                                                                      {Transfer::square_root, "sqrt"},
                                                                      {Transfer::linear, "linear"}}};
constexpr std::array<std::pair<Tone, std::string_view>, 5> tone_names{{{Tone::plain, "plain"},
                                                                       {Tone::neutral, "neutral"},
                                                                       {Tone::agx_like, "agx-like"},
                                                                       {Tone::filament, "filament"},
                                                                       {Tone::false_color, "false-color"}}};

template <class Names, class Value>
std::string_view name_in(const Names& list, Value value) {
  for (const auto& [each, text] : list)
    if (each == value) return text;
  return {};
}
template <class Value, std::size_t size>
std::optional<Value> named_in(const std::array<std::pair<Value, std::string_view>, size>& list,
                              std::string_view text) {
  for (const auto& [each, known] : list)
    if (known == text) return each;
  return std::nullopt;
}

namespace f64 {
#include "core/math/real_f64.h"

#include "core/light/transfer.glsl"
// The encoded value of a linear one.
real encode(Transfer transfer, real x) {
  switch (transfer) {
    case Transfer::srgb:
      return srgb_encode(x);
    case Transfer::power_22:
      return power22_encode(x);
    case Transfer::power_045:
      return power045_encode(x);
    case Transfer::square_root:
      return root_encode(x);
    case Transfer::linear:
      break;
  }
  return x;
}
// The linear value of an encoded one, by the decoding curve that the sources print beside each encoding. It
// need not be the exact inverse: CodeTable only starts its search there.
real decode(Transfer transfer, real y) {
  switch (transfer) {
    case Transfer::srgb:
      return srgb_decode(y);
    case Transfer::power_22:
    case Transfer::power_045:
      return power22_decode(y);
    case Transfer::square_root:
      return square_decode(y);
    case Transfer::linear:
      break;
  }
  return y;
}
}  // namespace f64

// The tone curves need two of the functions of transfer.glsl and one of marks.glsl.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
namespace f32 {
#include "core/math/real_f32.h"

#include "core/light/transfer.glsl"

#include "core/light/tone.glsl"

#include "core/light/marks.glsl"

#include "core/light/false_color.glsl"
// A pixel of four channels, exposed: what the display is to emit.
vec3 toned(Tone tone, const float* pixel, float exposure) {
  const vec3 scene(pixel[0] * exposure, pixel[1] * exposure, pixel[2] * exposure);
  switch (tone) {
    case Tone::neutral:
      return tone_neutral(scene);
    case Tone::agx_like:
      return tone_agx_like(scene);
    case Tone::filament:
      return tone_filament(scene);
    case Tone::false_color:
      return tone_false_color(scene);
    case Tone::plain:
      break;
  }
  return scene;
}
}  // namespace f32
#pragma GCC diagnostic pop

// Finds the code of a value by one look-up, because computing a power for each channel would cost more than
// the shading. Values between 2^-21 and 1 fall into buckets by the leading 16 bits of the float; a bucket is
// 1/256 to 1/128 of its values wide, and at most one code begins in it. The upper half of an entry is the
// first code of the bucket. The lower half is chosen so that adding the lower 16 bits of the value carries
// into the upper half where the next code begins.
class CodeTable {
 public:
  explicit CodeTable(Transfer transfer) {
    std::array<std::uint32_t, 257> first{};  // for each code, the bits of its least value
    for (int i = 1; i < 256; ++i) first[static_cast<std::size_t>(i)] = bits(least_value(transfer, i));
    first[256] = ~std::uint32_t{0};
    std::size_t code = 0;
    for (std::uint32_t i = 0; i < entries_.size(); ++i) {
      const std::uint32_t begin = (i + first_bucket) << 16;
      while (first[code + 1] <= begin) ++code;
      const std::uint32_t next = first[code + 1] - begin;
      entries_[i] = static_cast<std::uint32_t>(code << 16) + (next < 0x10000 ? 0x10000 - next : 0);
    }
  }

  std::uint8_t of(float value) const {
    const float high = value > least ? value : least;  // NaN becomes `least` too
    const std::uint32_t at = bits(high < 1 ? high : 1);
    return static_cast<std::uint8_t>((entries_[(at >> 16) - first_bucket] + (at & 0xffff)) >> 16);
  }

 private:
  static constexpr float least = 0x1p-21f;  // below the first code of every curve
  static std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }
  static constexpr std::uint32_t first_bucket = std::bit_cast<std::uint32_t>(least) >> 16,
                                 last_bucket = std::bit_cast<std::uint32_t>(1.0f) >> 16;

  static int code(Transfer transfer, float value) {
    const double encoded = f64::encode(transfer, double{value});
    return static_cast<int>(std::floor(255 * f64::clamp(encoded, 0, 1) + 0.5));
  }

  // The smallest float whose code is at least `wanted`.
  static float least_value(Transfer transfer, int wanted) {
    const auto at = static_cast<float>(f64::decode(transfer, (wanted - 0.5) / 255));
    float low = at * 0.9f, high = at * 1.1f + 1e-6f;
    while (std::nextafter(low, 2.0f) < high) {
      const float middle = low + (high - low) / 2;
      (code(transfer, middle) >= wanted ? high : low) = middle;
    }
    return high;
  }

  std::array<std::uint32_t, last_bucket - first_bucket + 1> entries_{};
};

const CodeTable& table_of(Transfer transfer) {
  static const std::array<CodeTable, 5> tables{CodeTable(Transfer::srgb), CodeTable(Transfer::power_22),
                                               CodeTable(Transfer::power_045),
                                               CodeTable(Transfer::square_root), CodeTable(Transfer::linear)};
  return tables[static_cast<std::size_t>(transfer)];
}

}  // namespace

std::string_view name(Transfer transfer) {
  return name_in(names, transfer);
}
std::optional<Transfer> transfer_named(std::string_view text) {
  return named_in(names, text);
}
std::string_view name(Tone tone) {
  return name_in(tone_names, tone);
}
std::optional<Tone> tone_named(std::string_view text) {
  return named_in(tone_names, text);
}

Vec3 toned(const float* pixel, double exposure, Tone tone) {
  if (tone == Tone::plain) return {exposure * pixel[0], exposure * pixel[1], exposure * pixel[2]};
  const f32::vec3 out = f32::toned(tone, pixel, static_cast<float>(exposure));
  return {double{out.x}, double{out.y}, double{out.z}};
}

Image exposed(const Image& picture, double exposure) {
  Image out(picture.width, picture.height, 3);
  const auto factor = static_cast<float>(exposure);
  const auto channels = static_cast<std::size_t>(picture.channels);
  for (std::size_t i = 0; i < picture.pixel_count(); ++i)
    for (std::size_t c = 0; c < 3; ++c) out.values[3 * i + c] = picture.values[channels * i + c] * factor;
  return out;
}

void to_codes(std::span<const float> pixels, double exposure, Transfer transfer, Tone tone,
              std::uint8_t* codes) {
  const CodeTable& table = table_of(transfer);
  const auto factor = static_cast<float>(exposure);
  if (tone != Tone::plain) {
    for (std::size_t i = 0; i + 4 <= pixels.size(); i += 4, codes += 3) {
      const f32::vec3 seen = f32::toned(tone, &pixels[i], factor);
      codes[0] = table.of(seen.x);
      codes[1] = table.of(seen.y);
      codes[2] = table.of(seen.z);
    }
    return;
  }
  for (std::size_t i = 0; i + 4 <= pixels.size(); i += 4, codes += 3) {
    // All three are computed before the first is written, because for the compiler a byte may alias the
    // pixels.
    const std::uint8_t red = table.of(pixels[i] * factor), green = table.of(pixels[i + 1] * factor),
                       blue = table.of(pixels[i + 2] * factor);
    codes[0] = red;
    codes[1] = green;
    codes[2] = blue;
  }
}

Image8 to_codes(const Image& picture, double exposure, Transfer transfer, Tone tone) {
  Image8 out(picture.width, picture.height, 3);
  if (picture.channels == 4) {
    to_codes(picture.values, exposure, transfer, tone, out.values.data());
    return out;
  }
  const auto channels = static_cast<std::size_t>(picture.channels);
  for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
    const float* const from = &picture.values[channels * i];
    const std::array<float, 4> pixel{from[0], from[1], from[2], 1};
    to_codes(pixel, exposure, transfer, tone, &out.values[3 * i]);
  }
  return out;
}

Image cut_out(const std::function<Image(const Vec3& background)>& drawn, bool see_through) {
  Image out = drawn({0, 0, 0});
  if (!see_through) return out;
  const Image over_white = drawn({1, 1, 1});
  for (std::size_t i = 0; i < out.values.size(); i += 4)
    out.values[i + 3] = std::clamp(1 - (over_white.values[i + 1] - out.values[i + 1]), 0.0f, 1.0f);
  return out;
}

Image unmultiplied(Image picture) {
  for (std::size_t i = 0; i < picture.values.size(); i += 4)
    if (const float opacity = picture.values[i + 3]; opacity > 0)
      for (std::size_t c = 0; c < 3; ++c) picture.values[i + c] /= opacity;
  return picture;
}

Image8 with_opacity(const Image8& codes, const Image& picture) {
  Image8 out(codes.width, codes.height, 4);
  for (std::size_t i = 0; i < codes.pixel_count(); ++i) {
    std::copy_n(&codes.values[3 * i], 3, &out.values[4 * i]);
    out.values[4 * i + 3] = to_code(picture.values[4 * i + 3]);
  }
  return out;
}

}  // namespace etak
