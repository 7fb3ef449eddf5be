// SPDX-License-Identifier: Apache-2.0
#include "core/study/choose/texture_filter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/color/gloss.h"
#include "core/color/luminance.h"
#include "core/color/srgb.h"
#include "core/math/functions.h"

namespace etak {
namespace {

// Sorts colours by luminance; those of equal luminance keep their order.
void sort_by_luminance(std::vector<std::uint32_t>& codes) {
  std::array<double, 256> linear{};
  for (std::size_t code = 0; code < 256; ++code) linear[code] = srgb_decode(static_cast<double>(code) / 255);
  const auto luminance = [&](std::uint32_t code) {
    return luminance_of(linear[code >> 16 & 255u], linear[code >> 8 & 255u], linear[code & 255u]);
  };
  std::vector<std::pair<double, std::uint32_t>> keyed;
  keyed.reserve(codes.size());
  for (const std::uint32_t code : codes) keyed.emplace_back(luminance(code), code);
  std::stable_sort(keyed.begin(), keyed.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = keyed[i].second;
}

}  // namespace

std::string_view name(TextureFilter filter) {
  constexpr std::array<std::string_view, 5> names{"constant", "nearest", "bilinear", "nearest-mip",
                                                  "trilinear"};
  return names[static_cast<std::size_t>(filter)];
}

const float* TexelChain::Level::at(int x, int y) const {
  const auto column = static_cast<std::size_t>(std::clamp(x, 0, width - 1));
  const auto row = static_cast<std::size_t>(std::clamp(y, 0, height - 1));
  return values.data() + numbers * (row * static_cast<std::size_t>(width) + column);
}

TexelChain::TexelChain(const ConstPixelsView8& diffuse_alpha, const ConstPixelsView8& specular_gloss,
                       const PixelBox& box, GlossForm gloss) {
  std::array<float, 256> linear{}, inverse_exponent{};
  for (std::size_t code = 0; code < 256; ++code) {
    const double value = static_cast<double>(code) / 255;
    linear[code] = static_cast<float>(srgb_decode(value));
    const double g = std::clamp(converted_gloss(value, gloss, GlossForm::schueler), 0.0, 1.0);
    inverse_exponent[code] = static_cast<float>(variance_of_gloss(g));
  }
  Level first{box.width, box.height, {}};
  first.values.reserve(numbers * static_cast<std::size_t>(box.width) * static_cast<std::size_t>(box.height));
  std::array<double, channel_count> sums{};
  ChannelRange range;
  for (int y = box.y; y < box.y + box.height; ++y) {
    const auto row = static_cast<std::size_t>(box.width);
    add_texels(range, Texture::diffuse_alpha, diffuse_alpha.at(box.x, y), row);
    add_texels(range, Texture::specular_gloss, specular_gloss.at(box.x, y), row);
    for (int x = box.x; x < box.x + box.width; ++x) {
      const std::uint8_t *a = diffuse_alpha.at(x, y), *b = specular_gloss.at(x, y);
      for (std::size_t c = 0; c < 3; ++c) first.values.push_back(linear[a[c]]);
      for (std::size_t c = 0; c < 3; ++c) first.values.push_back(linear[b[c]]);
      first.values.push_back(inverse_exponent[b[3]]);
      for (std::size_t c = 0; c < 3; ++c)
        sums[c] += static_cast<double>(linear[a[c]]), sums[4 + c] += static_cast<double>(linear[b[c]]);
      sums[3] += a[3];
      sums[7] += static_cast<double>(inverse_exponent[b[3]]);
      f0_codes_.push_back(static_cast<std::uint32_t>(b[0] << 16 | b[1] << 8 | b[2]));
    }
  }
  std::sort(f0_codes_.begin(), f0_codes_.end());
  f0_codes_.erase(std::unique(f0_codes_.begin(), f0_codes_.end()), f0_codes_.end());
  sort_by_luminance(f0_codes_);
  varying_ = !range.constant(Texture::diffuse_alpha) + !range.constant(Texture::specular_gloss);

  const double count = static_cast<double>(box.width) * box.height;
  for (std::size_t c = 0; c < 3; ++c)
    for (const std::size_t first_of : {std::size_t{0}, specular_channel})
      mean_codes_[first_of + c] = srgb_u8(sums[first_of + c] / count);
  mean_codes_[alpha_channel] = static_cast<std::uint8_t>(sums[alpha_channel] / count + 0.5);
  const double mean_gloss = gloss_of_variance(sums[gloss_channel] / count);
  mean_codes_[gloss_channel] = plain_u8(converted_gloss(mean_gloss, GlossForm::schueler, gloss));
  // A channel that does not vary keeps its code, whatever the last digits of the sums are.
  for (std::size_t c = 0; c < channel_count; ++c)
    if (range.constant(c)) mean_codes_[c] = range.least[c];

  levels_.push_back(std::move(first));
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    const Level& fine = levels_.back();
    Level coarse{std::max(1, fine.width / 2), std::max(1, fine.height / 2), {}};
    for (int y = 0; y < coarse.height; ++y)
      for (int x = 0; x < coarse.width; ++x) {
        // The coarse texel is the mean of all fine texels under it; of an odd side the last one has three.
        const int left = x * fine.width / coarse.width, right = (x + 1) * fine.width / coarse.width;
        const int top = y * fine.height / coarse.height, bottom = (y + 1) * fine.height / coarse.height;
        Values sum{};
        for (int v = top; v < bottom; ++v)
          for (int u = left; u < right; ++u)
            for (std::size_t i = 0; i < numbers; ++i) sum[i] += static_cast<double>(fine.at(u, v)[i]);
        for (const double value : sum)
          coarse.values.push_back(static_cast<float>(value / ((right - left) * (bottom - top))));
      }
    levels_.push_back(std::move(coarse));
  }
}

TexelChain::Values TexelChain::bilinear(const Level& level, double x, double y) {
  const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
  const double fx = x - 0.5 - left, fy = y - 0.5 - top;
  const int column = static_cast<int>(left), row = static_cast<int>(top);
  const float *a = level.at(column, row), *b = level.at(column + 1, row), *c = level.at(column, row + 1),
              *d = level.at(column + 1, row + 1);
  Values out{};
  for (std::size_t i = 0; i < numbers; ++i)
    out[i] = (1 - fy) * ((1 - fx) * static_cast<double>(a[i]) + fx * static_cast<double>(b[i])) +
             fy * ((1 - fx) * static_cast<double>(c[i]) + fx * static_cast<double>(d[i]));
  return out;
}

SurfaceTexel TexelChain::texel(const Values& v) {
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, -math::log2(v[6]) / 12};
}

SurfaceTexel TexelChain::read(TextureFilter filter, double x, double y, double level) const {
  const auto in_level = [&](int index) {
    const Level& of = levels_[static_cast<std::size_t>(std::clamp(index, 0, levels() - 1))];
    return bilinear(of, x * of.width / width(), y * of.height / height());
  };
  switch (filter) {
    case TextureFilter::constant: {
      const float* mean = levels_.back().at(0, 0);
      Values values{};
      std::copy(mean, mean + numbers, values.begin());
      return texel(values);
    }
    case TextureFilter::nearest: {
      const float* at = levels_[0].at(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));
      Values values{};
      std::copy(at, at + numbers, values.begin());
      return texel(values);
    }
    case TextureFilter::bilinear:
      return texel(in_level(0));
    case TextureFilter::nearest_mip:
      return texel(in_level(static_cast<int>(std::lround(std::max(0.0, level)))));
    case TextureFilter::trilinear:
      break;
  }
  const double clamped = std::clamp(level, 0.0, levels() - 1.0), lower = std::floor(clamped);
  Values values = in_level(static_cast<int>(lower));
  if (const double share = clamped - lower; share > 0) {
    const Values coarser = in_level(static_cast<int>(lower) + 1);
    for (std::size_t i = 0; i < numbers; ++i) values[i] += share * (coarser[i] - values[i]);
  }
  return texel(values);
}

std::vector<Vec3> TexelChain::some_f0(std::size_t most) const {
  std::vector<Vec3> out;
  const std::size_t count = std::min(most, f0_codes_.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t code = f0_codes_[count == 1 ? 0 : i * (f0_codes_.size() - 1) / (count - 1)];
    out.push_back({srgb_decode((code >> 16 & 255u) / 255.0), srgb_decode((code >> 8 & 255u) / 255.0),
                   srgb_decode((code & 255u) / 255.0)});
  }
  return out;
}

}  // namespace etak
