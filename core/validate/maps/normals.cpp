// SPDX-License-Identifier: Apache-2.0
#include "core/validate/maps/normals.h"

#include <algorithm>
#include <cmath>

#include "core/color/srgb.h"

namespace etak {

namespace {

constexpr int unit_length = 255;  // length 1 in the unit of 2 c - 255
constexpr std::int64_t squared_value(std::int64_t v) {
  return v * v;
}
// Squared lengths, rounded outwards.
constexpr auto least_unit =
    static_cast<std::int64_t>((1 - normal_tolerance) * (1 - normal_tolerance) * unit_length * unit_length);
constexpr auto most_unit =
    static_cast<std::int64_t>((1 + normal_tolerance) * (1 + normal_tolerance) * unit_length * unit_length) +
    1;

bool is_unit(std::int64_t squared) {
  return squared >= least_unit && squared <= most_unit;
}

// 2 c - 255 of each code, after one of sRGB's curves.
struct ComponentsOfCodes {
  std::array<std::int32_t, 256> as_is{}, decoded{}, encoded{};
};

const ComponentsOfCodes& components_of_codes() {
  static const ComponentsOfCodes table = [] {
    ComponentsOfCodes out;
    for (std::size_t code = 0; code < 256; ++code) {
      const double value = static_cast<double>(code) / unit_length;
      const auto component = [](double v) {
        return static_cast<std::int32_t>(std::lround(2 * unit_length * v - unit_length));
      };
      out.as_is[code] = component(value);
      out.decoded[code] = component(srgb_decode(value));
      out.encoded[code] = component(srgb_encode(value));
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

void add_normals(NormalFacts& facts, const std::uint8_t* rgba, int width) {
  const ComponentsOfCodes& table = components_of_codes();
  for (int i = 0; i < width; ++i, rgba += 4) {
    const auto squared = [&](const std::array<std::int32_t, 256>& of) {
      return squared_value(of[rgba[0]]) + squared_value(of[rgba[1]]) + squared_value(of[rgba[2]]);
    };
    const std::int64_t length = squared(table.as_is);
    facts.shortest = facts.texels == 0 ? length : std::min(facts.shortest, length);
    facts.longest = std::max(facts.longest, length);
    ++facts.texels;
    facts.not_unit += !is_unit(length);
    facts.not_unit_decoded += !is_unit(squared(table.decoded));
    facts.not_unit_encoded += !is_unit(squared(table.encoded));
    facts.below += rgba[2] < least_upward_code;
    facts.outside += squared_value(table.as_is[rgba[0]]) + squared_value(table.as_is[rgba[1]]) > most_unit;
    for (std::size_t c = 0; c < 3; ++c) {
      facts.least[c] = std::min(facts.least[c], rgba[c]);
      facts.most[c] = std::max(facts.most[c], rgba[c]);
      facts.sum[c] += table.as_is[rgba[c]];
    }
    const bool is_flat =
        rgba[2] >= 254 && (rgba[0] == 127 || rgba[0] == 128) && (rgba[1] == 127 || rgba[1] == 128);
    if (!is_flat) continue;
    ++facts.flat;
    for (std::size_t axis = 0; axis < 2; ++axis) ++facts.flat_codes[axis][rgba[axis] - 127u];
  }
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
  return is_all_over(255) && fits_in_two ? NormalCodes::two_channels : NormalCodes::unclear;
}

bool is_constant(const NormalFacts& facts) {
  return facts.texels != 0 && facts.least == facts.most;
}

bool is_flat_in_two_codes(const NormalFacts& facts) {
  if (facts.flat == 0 || 10 * facts.flat < facts.texels) return false;
  return std::ranges::any_of(facts.flat_codes, [&](const auto& counts) {
    return 100 * counts[0] >= facts.flat && 100 * counts[1] >= facts.flat;
  });
}

}  // namespace etak
