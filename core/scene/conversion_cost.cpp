// SPDX-License-Identifier: Apache-2.0
#include "core/scene/conversion_cost.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/text/text.h"
#include "core/color/gloss.h"
#include "core/color/srgb.h"
#include "core/image/linear_tables.h"
#include "core/image/wrap.h"
#include "core/scene/material_texels.h"

namespace etak {
namespace {

constexpr double least_told = 1;               // codes
constexpr double steepest_code = 12.92 * 255;  // codes per unit of linear light, in the darkest colours

double unrounded_code(double linear) {
  return 255 * srgb_encode(std::clamp(linear, 0.0, 1.0));
}

// A picture as a sampler magnifies it: colours in linear light, other channels as fractions.
class Magnified {
 public:
  ///   color   the first three channels are sRGB codes
  Magnified(const Image8& image, const GltfSampler& sampler, bool color)
      : image_(image), sampler_(sampler), color_(color) {}

  ///   u, v   in periods of the picture
  std::array<double, 4> at(double u, double v) const {
    const double x = u * image_.width - 0.5, y = v * image_.height - 0.5;
    const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
    const double right_share = x - left, low_share = y - top;
    std::array<double, 4> out{};
    for (int k = 0; k < 4; ++k) {
      const double share =
          (k % 2 == 0 ? 1 - right_share : right_share) * (k / 2 == 0 ? 1 - low_share : low_share);
      const auto channels = static_cast<std::size_t>(image_.channels);
      const auto texel = four_channels(image_
                                           .at(wrapped_texel(left + k % 2, image_.width, sampler_.wrap_u),
                                               wrapped_texel(top + k / 2, image_.height, sampler_.wrap_v))
                                           .data(),
                                       channels, std::uint8_t{255});
      for (std::size_t c = 0; c < 4; ++c)
        out[c] += share * (color_ && c < 3 ? double{linear_tables().srgb[texel[c]]} : texel[c] / 255.0);
    }
    return out;
  }

 private:
  const Image8& image_;
  const GltfSampler& sampler_;
  bool color_;
};

// Diffuse, F0 and gloss, as codes.
using Look = std::array<double, 7>;

Look look_of(const DiffuseSpecular& texel, double gloss) {
  Look out;
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = unrounded_code(texel.diffuse[c]), out[3 + c] = unrounded_code(texel.f0[c]);
  out[6] = 255 * std::clamp(gloss, 0.0, 1.0);
  return out;
}

double largest_difference(const Look& a, const Look& b) {
  double out = 0;
  for (std::size_t c = 0; c < a.size(); ++c) out = std::max(out, std::abs(a[c] - b[c]));
  return out;
}

// The textures of a material that the pair is made of.
struct Sources {
  const GltfMaterial& m;
  const SceneImages<std::uint8_t>& images;
  GlossForm gloss;

  const std::optional<GltfTexture>& color() const {
    return m.specular_glossiness ? m.diffuse_texture : m.base_color_texture;
  }
  const std::optional<GltfTexture>& second() const {
    return m.specular_glossiness ? m.specular_glossiness_texture : m.metallic_roughness_texture;
  }
  std::array<double, 4> found(const std::optional<GltfTexture>& texture, bool is_color, double u,
                              double v) const {
    if (!texture) return {1, 1, 1, 1};
    return Magnified(images(texture->image), texture->sampler, is_color).at(u, v);
  }

  // What a shader makes of what samplers find there.
  Look at(double u, double v) const {
    const auto a = found(color(), true, u, v), b = found(second(), m.specular_glossiness, u, v);
    DiffuseSpecular ds;
    if (m.specular_glossiness) {
      for (std::size_t c = 0; c < 3; ++c)
        ds.diffuse[c] = a[c] * m.diffuse[c], ds.f0[c] = b[c] * m.specular_f0[c];
      return look_of(ds, converted_gloss(b[3] * m.glossiness, GlossForm::one_minus_roughness, gloss));
    }
    ds = diffuse_specular(
        {a[0] * m.base_color[0], a[1] * m.base_color[1], a[2] * m.base_color[2]}, b[2] * m.metallic,
        dielectric_f0(m.ior, m.specular, {m.specular_color[0], m.specular_color[1], m.specular_color[2]}));
    return look_of(ds, converted_gloss(b[1] * m.roughness, GlossForm::roughness, gloss));
  }
};

// Of texels that are partly metal, whose F0 lies above the dielectric's.
double of_partly_metal(const GltfMaterial& m, const MaterialPair& pair, const std::uint8_t* used) {
  const Vec3 dielectric =
      dielectric_f0(m.ior, m.specular, {m.specular_color[0], m.specular_color[1], m.specular_color[2]});
  const double reduced_by = std::max({dielectric[0], dielectric[1], dielectric[2]});
  const std::uint8_t least = srgb_u8(reduced_by);
  // By codes of diffuse and F0: most pairs of codes come again and again.
  std::vector<bool> seen(256 * 256, false);
  double worst = 0;
  for (std::size_t i = 0; i < pair.diffuse_alpha.pixel_count(); ++i) {
    if (used != nullptr && used[i] == 0) continue;
    const std::uint8_t *d = pair.diffuse_alpha.values.data() + 4 * i,
                       *f = pair.specular_gloss.values.data() + 4 * i;
    const std::size_t f0 = std::max({f[0], f[1], f[2]}), diffuse = std::max({d[0], d[1], d[2]});
    if (f0 <= least || diffuse == 0 || seen[256 * diffuse + f0]) continue;
    seen[256 * diffuse + f0] = true;
    const double light = linear_tables().srgb[diffuse];
    worst = std::max(worst, unrounded_code(light * (1 - reduced_by)) -
                                unrounded_code(light * (1 - double{linear_tables().srgb[f0]})));
  }
  return worst;
}

// Half way between two texels diffuse of the material's own textures is that of the pair plus, and F0 that of
// the pair less a quarter of what base colour differs by times what metal differs by.
double between_texels(const GltfMaterial& m, const Image8& base, const Image8& metal,
                      const MaterialPair& pair, const std::uint8_t* used) {
  const LinearTables& tables = linear_tables();
  const auto width = static_cast<std::size_t>(pair.diffuse_alpha.width);
  const auto base_channels = static_cast<std::size_t>(base.channels),
             metal_channels = static_cast<std::size_t>(metal.channels);
  const std::size_t metal_channel = metal_channels >= 3 ? 2 : 0;
  double worst = 0;
  const auto compare = [&](std::size_t i, std::size_t j) {
    const int metal_steps =
        metal.values[metal_channels * i + metal_channel] - metal.values[metal_channels * j + metal_channel];
    if (metal_steps == 0 || (used != nullptr && (used[i] == 0 || used[j] == 0))) return;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t from = base_channels < 3 ? 0 : c;
      const double color = (double{tables.srgb[base.values[base_channels * i + from]]} -
                            double{tables.srgb[base.values[base_channels * j + from]]}) *
                           m.base_color[c];
      const double shift = color * metal_steps * m.metallic / (4 * 255);
      if (std::abs(shift) * steepest_code <= worst) continue;
      const auto differs = [&](const Image8& texture, double by) {
        const double mean = 0.5 * (double{tables.srgb[texture.values[4 * i + c]]} +
                                   double{tables.srgb[texture.values[4 * j + c]]});
        worst = std::max(worst, std::abs(unrounded_code(mean + by) - unrounded_code(mean)));
      };
      differs(pair.diffuse_alpha, shift);
      differs(pair.specular_gloss, -shift);
    }
  };
  for (std::size_t i = 0; i < pair.diffuse_alpha.pixel_count(); ++i) {
    if ((i + 1) % width != 0) compare(i, i + 1);
    if (i + width < pair.diffuse_alpha.pixel_count()) compare(i, i + width);
  }
  return worst;
}

std::string size_text(const Image8& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height);
}

// At the centres of the texels of one texture.
double at_centres(const Sources& sources, const Image8& texture, const MaterialPair& pair,
                  const GltfSampler& sampler, const std::uint8_t* used) {
  const Magnified a(pair.diffuse_alpha, sampler, true), b(pair.specular_gloss, sampler, true);
  const int width = pair.diffuse_alpha.width, height = pair.diffuse_alpha.height;
  double worst = 0;
  for (int y = 0; y < texture.height; ++y)
    for (int x = 0; x < texture.width; ++x) {
      const int column = texel_under(x, texture.width, width), row = texel_under(y, texture.height, height);
      const std::size_t texel =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
      if (used != nullptr && used[texel] == 0) continue;
      const double u = (x + 0.5) / texture.width, v = (y + 0.5) / texture.height;
      const auto diffuse = a.at(u, v), specular = b.at(u, v);
      const Look of_pair = look_of(
          {{diffuse[0], diffuse[1], diffuse[2]}, {specular[0], specular[1], specular[2]}}, specular[3]);
      worst = std::max(worst, largest_difference(sources.at(u, v), of_pair));
    }
  return worst;
}

}  // namespace

ConversionCost conversion_cost(const GltfMaterial& material, const SceneImages<std::uint8_t>& images,
                               const MaterialPair& pair, GlossForm gloss, const std::uint8_t* used) {
  ConversionCost out;
  if (material.specular_texture || material.specular_color_texture) return out;
  if (!material.specular_glossiness) out.partial = of_partly_metal(material, pair, used);
  const Sources sources{material, images, gloss};
  if (!sources.color() || !sources.second() || sources.color()->sampler.nearest) return out;
  const Image8 &color = images(sources.color()->image), &second = images(sources.second()->image);
  const auto smaller = [&](const Image8& image) {
    return image.pixel_count() < pair.diffuse_alpha.pixel_count();
  };
  if (!smaller(color) && !smaller(second)) {
    if (!material.specular_glossiness && material.metallic > 0)
      out.between = between_texels(material, color, second, pair, used);
    return out;
  }
  out.sizes = size_text(color) + " and " + size_text(second);
  for (const Image8* image : {&color, &second})
    if (smaller(*image))
      out.resized = std::max(out.resized, at_centres(sources, *image, pair, sources.color()->sampler, used));
  return out;
}

std::optional<std::string> sentence_of(const ConversionCost& cost) {
  if (cost.is_exact()) return std::nullopt;
  std::vector<std::string> parts;
  const auto codes = [](double value) { return fixed(value, 1) + " codes"; };
  if (cost.partial >= 1)
    parts.push_back("diffuse light of texels that are partly metal differs by up to " + codes(cost.partial));
  if (cost.between >= 1)
    parts.push_back("diffuse and F0 between texels where metal meets what is less metal differ by up to " +
                    codes(cost.between));
  if (cost.resized >= 1)
    parts.push_back(
        "its textures of " + cost.sizes +
        " were filtered to one size, and at texel centres of the smaller one diffuse, F0 or gloss differ by up to " +
        codes(cost.resized));
  return "as diffuse and F0 it is not quite what it was: " + joined(parts, "; ");
}

}  // namespace etak
