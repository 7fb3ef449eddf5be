// SPDX-License-Identifier: Apache-2.0
#include "core/render/display.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/color/srgb.h"

namespace etak {
namespace {

constexpr std::array<std::pair<Transfer, std::string_view>, 4> names{{{Transfer::srgb, "srgb"},
                                                                      {Transfer::power_045, "power-0.45"},
                                                                      {Transfer::square_root, "sqrt"},
                                                                      {Transfer::linear, "linear"}}};

namespace f64 {
using real = double;
[[maybe_unused]] constexpr real tiny = 1e-300;
// Not sorted: the text uses the types.
// clang-format off
#include "core/math/glsl.h"
#include "core/light/transfer.glsl"
// clang-format on
// What a display shows of a linear value.
real encode(Transfer transfer, real x) {
  switch (transfer) {
    case Transfer::srgb:
      return srgb_encode(x);
    case Transfer::power_045:
      return power045_encode(x);
    case Transfer::square_root:
      return root_encode(x);
    case Transfer::linear:
      break;
  }
  return x;
}
// The way back, of the curves' printed partners; where the inverse of a code boundary is looked for it is
// only a start.
real decode(Transfer transfer, real y) {
  switch (transfer) {
    case Transfer::srgb:
      return srgb_decode(y);
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

// From which float value on a code is shown, for all codes; and per bucket of [0, 1) the first code to look
// at. A table, because a power per channel costs more than the shading.
struct CodeTable {
  static constexpr int buckets = 1024;
  std::array<float, 257> first_value{};
  std::array<std::uint8_t, buckets + 1> first_code{};

  static std::uint8_t code(Transfer transfer, float value) {
    const double encoded = f64::encode(transfer, double{value});
    return static_cast<std::uint8_t>(std::floor(255 * f64::clamp(encoded, 0, 1) + 0.5));
  }

  explicit CodeTable(Transfer transfer) {
    first_value[0] = 0;
    for (int i = 1; i < 256; ++i) {
      // The smallest float whose code is at least i: from near it, step by step.
      auto at = static_cast<float>(f64::decode(transfer, (i - 0.5) / 255));
      float low = at * 0.9f, high = at * 1.1f + 1e-6f;
      while (std::nextafter(low, 2.0f) < high) {
        const float middle = low + (high - low) / 2;
        (code(transfer, middle) >= i ? high : low) = middle;
      }
      first_value[static_cast<std::size_t>(i)] = high;
    }
    first_value[256] = std::numeric_limits<float>::infinity();
    for (int i = 0; i <= buckets; ++i)
      first_code[static_cast<std::size_t>(i)] = code(transfer, static_cast<float>(i) / buckets);
  }

  std::uint8_t of(float value) const {
    if (!(value > 0)) return 0;
    if (value >= 1) return 255;
    std::size_t i = first_code[static_cast<std::size_t>(value * buckets)];
    while (value >= first_value[i + 1]) ++i;
    return static_cast<std::uint8_t>(i);
  }
};

const CodeTable& table_of(Transfer transfer) {
  static const std::array<CodeTable, 4> tables{CodeTable(Transfer::srgb), CodeTable(Transfer::power_045),
                                               CodeTable(Transfer::square_root), CodeTable(Transfer::linear)};
  return tables[static_cast<std::size_t>(transfer)];
}

}  // namespace

std::string_view name(Transfer transfer) {
  for (const auto& [each, text] : names)
    if (each == transfer) return text;
  return {};
}

std::optional<Transfer> transfer_named(std::string_view text) {
  for (const auto& [each, known] : names)
    if (known == text) return each;
  return std::nullopt;
}

Image exposed(const Image& picture, double exposure) {
  Image out(picture.width, picture.height, 3);
  const auto factor = static_cast<float>(exposure);
  const auto channels = static_cast<std::size_t>(picture.channels);
  for (std::size_t i = 0; i < picture.pixel_count(); ++i)
    for (std::size_t c = 0; c < 3; ++c) out.values[3 * i + c] = picture.values[channels * i + c] * factor;
  return out;
}

Image8 to_codes(const Image& picture, double exposure, Transfer transfer) {
  const CodeTable& table = table_of(transfer);
  Image8 out(picture.width, picture.height, 3);
  const auto factor = static_cast<float>(exposure);
  const auto channels = static_cast<std::size_t>(picture.channels);
  for (std::size_t i = 0; i < picture.pixel_count(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      out.values[3 * i + c] = table.of(picture.values[channels * i + c] * factor);
  return out;
}

}  // namespace etak
