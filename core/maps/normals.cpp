// SPDX-License-Identifier: Apache-2.0
#include "core/maps/normals.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/color/srgb.h"

namespace etak {

namespace {

constexpr int unit_length = 255;  // length 1 in the unit of 2 c - 255
// Squared lengths, rounded outwards.
constexpr auto least_unit =
    static_cast<std::int64_t>((1 - normal_tolerance) * (1 - normal_tolerance) * unit_length * unit_length);
constexpr auto most_unit =
    static_cast<std::int64_t>((1 + normal_tolerance) * (1 + normal_tolerance) * unit_length * unit_length) +
    1;

bool is_unit(std::int64_t squared) {
  return squared >= least_unit && squared <= most_unit;
}

// The square of 2 c - 255 of each code, after one of sRGB's curves.
struct SquaresOfCodes {
  std::array<std::int32_t, 256> decoded{}, encoded{};
};

const SquaresOfCodes& squares_of_codes() {
  static const SquaresOfCodes table = [] {
    SquaresOfCodes out;
    for (std::size_t code = 0; code < 256; ++code) {
      const double value = static_cast<double>(code) / unit_length;
      const auto square = [](double v) {
        const auto component = static_cast<std::int32_t>(std::lround(2 * unit_length * v - unit_length));
        return component * component;
      };
      out.decoded[code] = square(srgb_decode(value));
      out.encoded[code] = square(srgb_encode(value));
    }
    return out;
  }();
  return table;
}

bool is_tenth_at_most(std::uint64_t count, const NormalFacts& facts) {
  return 10 * count <= facts.texels;
}

}  // namespace

void NormalFacts::add(const NormalFacts& o) {
  if (o.texels == 0) return;
  shortest = texels == 0 ? o.shortest : std::min(shortest, o.shortest);
  longest = std::max(longest, o.longest);
  texels += o.texels;
  not_unit += o.not_unit;
  not_unit_decoded += o.not_unit_decoded;
  not_unit_encoded += o.not_unit_encoded;
  below += o.below;
  outside += o.outside;
  flat += o.flat;
  nearly_flat += o.nearly_flat;
  for (std::size_t c = 0; c < 3; ++c) {
    least[c] = std::min(least[c], o.least[c]);
    most[c] = std::max(most[c], o.most[c]);
    sum[c] += o.sum[c];
  }
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t code = 0; code < 2; ++code) flat_codes[axis][code] += o.flat_codes[axis][code];
}

double NormalFacts::mean(std::size_t component) const {
  return texels == 0 ? 0 : static_cast<double>(sum[component]) / (unit_length * static_cast<double>(texels));
}

namespace {

// 2 c - 255 of a channel of texel `i`.
std::int32_t component_at(const std::uint8_t* rgba, std::size_t i, unsigned channel) {
  std::uint32_t texel = 0;
  std::memcpy(&texel, rgba + 4 * i, sizeof texel);
  const unsigned byte = std::endian::native == std::endian::little ? channel : 3 - channel;
  return 2 * static_cast<std::int32_t>(texel >> 8 * byte & 255) - unit_length;
}

// Adds the facts that every texel adds to in one way: loops of whole numbers without a branch, of which compilers make
// vector code. Squares are made by floats, which hold them exactly, because not every
// processor multiplies vectors of whole numbers.
void add_lengths(NormalFacts& facts, const std::uint8_t* rgba, std::size_t width) {
  constexpr auto least_length = static_cast<std::int32_t>(least_unit),
                 most_length = static_cast<std::int32_t>(most_unit);
  const auto square = [](std::int32_t v) { return static_cast<float>(v) * static_cast<float>(v); };
  std::uint32_t not_unit = 0, below = 0, outside = 0;
  std::int32_t shortest = std::numeric_limits<std::int32_t>::max(), longest = 0;
  for (std::size_t i = 0; i < width; ++i) {
    const std::int32_t z = component_at(rgba, i, 2);
    const float flat = square(component_at(rgba, i, 0)) + square(component_at(rgba, i, 1));
    const auto length = static_cast<std::int32_t>(flat + square(z));
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
    not_unit += (length < least_length ? 1u : 0u) + (length > most_length ? 1u : 0u);
    below += z < 2 * least_upward_code - unit_length ? 1u : 0u;
    outside += static_cast<std::int32_t>(flat) > most_length ? 1u : 0u;
  }
  for (unsigned c = 0; c < 3; ++c) {
    std::int32_t least = unit_length, most = -unit_length, sum = 0;
    for (std::size_t i = 0; i < width; ++i) {
      const std::int32_t v = component_at(rgba, i, c);
      least = std::min(least, v);
      most = std::max(most, v);
      sum += v;
    }
    const auto code = [](std::int32_t v) { return static_cast<std::uint8_t>((v + unit_length) / 2); };
    facts.least[c] = std::min(facts.least[c], code(least));
    facts.most[c] = std::max(facts.most[c], code(most));
    facts.sum[c] += sum;
  }
  facts.not_unit += not_unit;
  facts.below += below;
  facts.outside += outside;
  facts.shortest = facts.texels == 0 ? shortest : std::min<std::int64_t>(facts.shortest, shortest);
  facts.longest = std::max<std::int64_t>(facts.longest, longest);
  facts.texels += width;
}

}  // namespace

void add_normals(NormalFacts& facts, const std::uint8_t* rgba, int width) {
  if (width <= 0) return;
  const auto texels = static_cast<std::size_t>(width);
  add_lengths(facts, rgba, texels);
  const SquaresOfCodes& table = squares_of_codes();
  const auto squared = [](const std::array<std::int32_t, 256>& of, const std::uint8_t* texel) {
    return of[texel[0]] + of[texel[1]] + of[texel[2]];
  };
  for (std::size_t i = 0; i < texels; ++i) {
    facts.not_unit_decoded += !is_unit(squared(table.decoded, rgba + 4 * i));
    facts.not_unit_encoded += !is_unit(squared(table.encoded, rgba + 4 * i));
  }
  if (facts.most[2] < 254) return;
  for (std::size_t i = 0; i < texels; ++i, rgba += 4) {
    const auto is_within = [&](int least, int most) {
      return std::min(rgba[0], rgba[1]) >= least && std::max(rgba[0], rgba[1]) <= most;
    };
    if (rgba[2] < 254 || !is_within(126, 129)) continue;
    if (!is_within(127, 128)) {
      ++facts.nearly_flat;
      continue;
    }
    ++facts.flat;
    for (std::size_t axis = 0; axis < 2; ++axis) ++facts.flat_codes[axis][rgba[axis] - 127u];
  }
}

// Whether the mean normal leans as a curve makes it lean, and stands up without the curve. It tells maps whose
// lengths lossy compression has spoilt.
bool leans_by_curve(const NormalFacts& facts, NormalCodes how) {
  constexpr double least_lean = 0.3, most_left = 0.15, least_up = 0.5;
  const bool is_encoded = how == NormalCodes::encoded;
  if (facts.mean(2) < least_up) return false;
  for (std::size_t c = 0; c < 2; ++c) {
    const double mean = facts.mean(c), code = (mean + 1) / 2;
    const double left = 2 * (is_encoded ? srgb_decode(code) : srgb_encode(code)) - 1;
    if ((is_encoded ? mean : -mean) < least_lean || std::abs(left) > most_left) return false;
  }
  return true;
}

std::optional<NormalCodes> normal_codes(const NormalFacts& facts) {
  if (facts.texels == 0) return std::nullopt;
  const auto is_all_over = [&](int blue) { return facts.least[2] == blue && facts.most[2] == blue; };
  const bool fits_in_two = is_tenth_at_most(facts.outside, facts);
  if (is_all_over(0) && fits_in_two) return NormalCodes::two_channels;
  if (is_tenth_at_most(facts.not_unit, facts)) return NormalCodes::as_is;
  const bool is_encoded = is_tenth_at_most(facts.not_unit_decoded, facts),
             is_decoded = is_tenth_at_most(facts.not_unit_encoded, facts);
  if (2 * facts.not_unit > facts.texels && is_encoded != is_decoded)
    return is_encoded ? NormalCodes::encoded : NormalCodes::decoded;
  if (2 * facts.not_unit > facts.texels)
    for (const NormalCodes how : {NormalCodes::encoded, NormalCodes::decoded})
      if (leans_by_curve(facts, how)) return how;
  return is_all_over(255) && fits_in_two ? NormalCodes::two_channels : NormalCodes::unclear;
}

bool is_constant(const NormalFacts& facts) {
  return facts.texels != 0 && facts.least == facts.most;
}

bool is_flat_in_two_codes(const NormalFacts& facts) {
  if (facts.flat == 0 || 10 * facts.flat < facts.texels || 2 * facts.nearly_flat > facts.flat) return false;
  return std::ranges::any_of(facts.flat_codes, [&](const auto& counts) {
    return 100 * counts[0] >= facts.flat && 100 * counts[1] >= facts.flat;
  });
}

}  // namespace etak
