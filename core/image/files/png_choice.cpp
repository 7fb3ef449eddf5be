// SPDX-License-Identifier: Apache-2.0
#include "core/image/files/png_choice.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>

namespace etak {
namespace {

constexpr double sent_per_second = 1e6, times_sent = 10;
constexpr std::size_t most_sample_bytes = std::size_t{1} << 20;
constexpr int sample_bands = 4;

// Seconds that a level takes on one core, by the bytes of the pixels and by those of the file: the slower
// levels search for as long as there is something left to write. Measured as processor time of
// `etak pack --png-level LEVEL -j 1` on one core of an AVX-512 machine, over pages of the flight helmet, the
// racquet and the chair: `small` writes 2.8 to 4.0 MB of file a second (12 to 100 MB of pixels), `smallest`
// 0.3 to 0.8 (2 to 12).
struct LevelCost {
  PngLevel level;
  double per_pixel_byte, per_file_byte;
};
constexpr std::array costs{LevelCost{PngLevel::fast, 1 / 400e6, 0}, LevelCost{PngLevel::small, 0, 1 / 3.5e6},
                           LevelCost{PngLevel::smallest, 0, 1 / 0.5e6}};

std::uint64_t size_of(const PngRows& rows, PngLevel level) {
  PngOptions options;
  options.level = level;
  std::uint64_t out = 0;
  write_png(rows, options, [&](std::string_view piece) { out += piece.size(); });
  return out;
}

// The bits that hold so many different codes.
int bits_for(std::size_t count) {
  return count <= 2 ? 1 : count <= 4 ? 2 : count <= 16 ? 4 : 8;
}

std::uint32_t key_of(const std::uint8_t* texel, int channels) {
  std::uint32_t out = 0;
  for (int c = 0; c < channels; ++c) out = out << 8 | texel[c];
  return channels == 3 ? out << 8 | 255U : out;
}

// Codes of `bits` each, the first in the highest bits of a byte.
template <class CodeAt>
PackedPng packed(const Image8& image, int bits, const CodeAt& code_at) {
  PackedPng out;
  out.header = {image.width, image.height, 1, bits};
  out.stride = (static_cast<std::size_t>(image.width) * static_cast<std::size_t>(bits) + 7) / 8;
  out.rows.resize(out.stride * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    std::uint8_t* const row = out.rows.data() + out.stride * static_cast<std::size_t>(y);
    for (int x = 0; x < image.width; ++x) {
      const int at = x * bits;
      row[at / 8] =
          static_cast<std::uint8_t>(row[at / 8] | code_at(image.at(x, y).data()) << (8 - bits - at % 8));
    }
  }
  return out;
}

std::optional<PackedPng> packed_grey(const Image8& image) {
  int bits = 1;
  for (const std::uint8_t v : image.values) {
    while (bits < 8 && v % (255 / ((1 << bits) - 1)) != 0) bits *= 2;
    if (bits == 8) return std::nullopt;
  }
  const int step = 255 / ((1 << bits) - 1);
  return packed(image, bits, [step](const std::uint8_t* texel) { return texel[0] / step; });
}

std::optional<PackedPng> packed_colours(const Image8& image) {
  constexpr std::size_t most = 256;
  std::unordered_map<std::uint32_t, int> codes;
  std::uint32_t last = 0;
  const auto channels = static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < image.values.size(); i += channels) {
    const std::uint32_t key = key_of(image.values.data() + i, image.channels);
    if (i > 0 && key == last) continue;
    last = key;
    codes.try_emplace(key, 0);
    if (codes.size() > most) return std::nullopt;
  }
  // Colours that are seen through come first: the others need no entry in the table of alphas.
  std::vector<std::uint32_t> colours;
  for (const auto& [key, code] : codes) colours.push_back(key);
  std::sort(colours.begin(), colours.end(), [](std::uint32_t a, std::uint32_t b) {
    const bool full_a = (a & 255U) == 255, full_b = (b & 255U) == 255;
    return full_a != full_b ? full_b : a < b;
  });
  if (image.channels == 4 && (colours.front() & 255U) == 255) return std::nullopt;
  PngPalette palette;
  for (const std::uint32_t key : colours) {
    codes[key] = static_cast<int>(palette.size());
    palette.push_back({static_cast<std::uint8_t>(key >> 24), static_cast<std::uint8_t>(key >> 16),
                       static_cast<std::uint8_t>(key >> 8), static_cast<std::uint8_t>(key)});
  }
  PackedPng out = packed(image, bits_for(palette.size()), [&](const std::uint8_t* texel) {
    return codes.find(key_of(texel, image.channels))->second;
  });
  out.palette = std::move(palette);
  return out;
}

}  // namespace

PngLevel png_level_for(const PngRows& image) {
  const PictureHeader& info = image.header;
  const std::size_t row_bytes =
      static_cast<std::size_t>(info.width) * static_cast<std::size_t>(info.channels * info.bits / 8);
  const auto rows = static_cast<int>(std::clamp<std::size_t>(most_sample_bytes / sample_bands / row_bytes, 1,
                                                             static_cast<std::size_t>(info.height)));
  std::array<std::uint64_t, costs.size()> bytes{};
  std::uint64_t sampled = 0;
  for (int s = 0; s < sample_bands; ++s) {
    const int first = static_cast<int>(static_cast<long long>(info.height - rows) * s / (sample_bands - 1));
    PngRows part = image;
    part.header.height = rows;
    part.rows = image.rows + static_cast<std::size_t>(first) * image.stride;
    for (std::size_t l = 0; l < costs.size(); ++l) bytes[l] += size_of(part, costs[l].level);
    sampled += row_bytes * static_cast<std::uint64_t>(rows);
    if (rows == info.height) break;
  }
  const auto seconds = [&](std::size_t l) {
    const auto file = static_cast<double>(bytes[l]);
    return file * (times_sent / sent_per_second + costs[l].per_file_byte) +
           static_cast<double>(sampled) * costs[l].per_pixel_byte;
  };
  std::size_t best = 0;
  for (std::size_t l = 1; l < costs.size(); ++l)
    if (seconds(l) < seconds(best)) best = l;
  return costs[best].level;
}

std::optional<PackedPng> packed_png(const Image8& image) {
  if (image.channels == 1) return packed_grey(image);
  if (image.channels >= 3) return packed_colours(image);
  return std::nullopt;
}

std::string least_png(const Image8& image, const PngOptions& options) {
  PngOptions plain = options;
  plain.palette.clear();
  std::string out = png_bytes(image, plain);
  if (std::optional<PackedPng> packed = packed_png(image)) {
    plain.palette = std::move(packed->palette);
    std::string small = png_bytes(packed->view(), plain);
    if (small.size() < out.size()) out = std::move(small);
  }
  return out;
}

}  // namespace etak
