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

constexpr double steepest_code = 12.92 * 255;  // codes per unit of linear light, in the darkest colours

double unrounded_code(double linear) {
  return 255 * srgb_encode(std::clamp(linear, 0.0, 1.0));
}

double light_of(double code) {
  return srgb_decode(std::min(code, 255.0) / 255);
}

double largest_channel(const Vec3& v) {
  return std::max({v[0], v[1], v[2]});
}

// A picture as a sampler magnifies it: colours in linear light, other channels as fractions.
class Magnified {
 public:
  ///   color   the first three channels are sRGB codes
  Magnified(const Image8& image, const GltfSampler& sampler, bool color)
      : image_(image), sampler_(sampler), color_(color) {}

  ///   u, v   in periods of the picture
  std::array<double, 4> at(double u, double v) const {
    const double x = u * image_.width, y = v * image_.height;
    if (sampler_.nearest) return texel(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));
    const int left = static_cast<int>(std::floor(x - 0.5)), top = static_cast<int>(std::floor(y - 0.5));
    const double right_share = x - 0.5 - left, low_share = y - 0.5 - top;
    std::array<double, 4> out{};
    for (int k = 0; k < 4; ++k) {
      const double share =
          (k % 2 == 0 ? 1 - right_share : right_share) * (k / 2 == 0 ? 1 - low_share : low_share);
      const std::array<double, 4> corner = texel(left + k % 2, top + k / 2);
      for (std::size_t c = 0; c < 4; ++c) out[c] += share * corner[c];
    }
    return out;
  }

 private:
  std::array<double, 4> texel(int x, int y) const {
    const auto codes = four_channels(image_
                                         .at(wrapped_texel(x, image_.width, sampler_.wrap_u),
                                             wrapped_texel(y, image_.height, sampler_.wrap_v))
                                         .data(),
                                     static_cast<std::size_t>(image_.channels), std::uint8_t{255});
    std::array<double, 4> out{};
    for (std::size_t c = 0; c < 4; ++c)
      out[c] = color_ && c < 3 ? double{linear_tables().srgb[codes[c]]} : codes[c] / 255.0;
    return out;
  }

  const Image8& image_;
  const GltfSampler& sampler_;
  bool color_;
};

// Diffuse, F0, gloss and alpha, and what is left of diffuse light behind F0, as codes.
using Look = std::array<double, 11>;
constexpr std::size_t without_light = 8;

///   reduced_by   F0 that is taken from diffuse light
Look look_of(const DiffuseSpecular& texel, double gloss, double alpha, double reduced_by) {
  Look out;
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = unrounded_code(texel.diffuse[c]), out[3 + c] = unrounded_code(texel.f0[c]);
  out[6] = 255 * std::clamp(gloss, 0.0, 1.0);
  out[7] = 255 * alpha;
  for (std::size_t c = 0; c < 3; ++c)
    out[without_light + c] = unrounded_code(texel.diffuse[c] * (1 - reduced_by));
  return out;
}

// The largest difference among the values from `begin` to before `end`.
double largest_difference(const Look& a, const Look& b, std::size_t begin, std::size_t end) {
  double out = 0;
  for (std::size_t c = begin; c < end; ++c) out = std::max(out, std::abs(a[c] - b[c]));
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

  double alpha_of(double value) const { return m.alpha_mode == AlphaMode::opaque ? 1 : value; }

  // The look that a shader makes of the texels that samplers find at u, v.
  Look at(double u, double v) const {
    const auto a = found(color(), true, u, v), b = found(second(), m.specular_glossiness, u, v);
    DiffuseSpecular ds;
    if (m.specular_glossiness) {
      for (std::size_t c = 0; c < 3; ++c)
        ds.diffuse[c] = a[c] * m.diffuse[c], ds.f0[c] = b[c] * m.specular_f0[c];
      return look_of(ds, converted_gloss(b[3] * m.glossiness, GlossForm::one_minus_roughness, gloss),
                     alpha_of(a[3] * m.diffuse[3]), largest_channel(ds.f0));
    }
    const auto tint = found(m.specular_color_texture, true, u, v);
    const double strength = found(m.specular_texture, false, u, v)[3];
    const Vec3 dielectric = dielectric_f0(
        m.ior, m.specular * strength,
        {m.specular_color[0] * tint[0], m.specular_color[1] * tint[1], m.specular_color[2] * tint[2]});
    ds = diffuse_specular({a[0] * m.base_color[0], a[1] * m.base_color[1], a[2] * m.base_color[2]},
                          b[2] * m.metallic, dielectric);
    return look_of(ds, converted_gloss(b[1] * m.roughness, GlossForm::roughness, gloss),
                   alpha_of(a[3] * m.base_color[3]), largest_channel(dielectric));
  }
};

// The cost of texels that are partly metal, whose F0 lies above the dielectric's.
double of_partly_metal(const GltfMaterial& m, const MaterialPair& pair, const std::uint8_t* used) {
  const Vec3 dielectric =
      dielectric_f0(m.ior, m.specular, {m.specular_color[0], m.specular_color[1], m.specular_color[2]});
  const double reduced_by = std::max({dielectric[0], dielectric[1], dielectric[2]});
  const std::uint8_t least = srgb_u8(reduced_by);
  // Which pairs of codes of diffuse and F0 were looked at: most pairs come again and again.
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

// F0 of metal comes from base colour, so that vertex colours multiply it; F0 in a texture of its own they do not.
double of_tinted_metal(const GltfMaterial& m, const Image8& metallic, const MaterialPair& pair,
                       const std::uint8_t* used, const VertexColors& colors) {
  // Where textures change the dielectric's F0, that is taken to be 0, so that no metal counts as less than it is.
  const bool varies = m.specular_texture || m.specular_color_texture;
  const Vec3 dielectric =
      varies
          ? Vec3{0, 0, 0}
          : dielectric_f0(m.ior, m.specular, {m.specular_color[0], m.specular_color[1], m.specular_color[2]});
  double worst = 0;
  for (std::size_t i = 0; i < pair.specular_gloss.pixel_count(); ++i) {
    const double metal = metallic.values[i] / 255.0;
    if (metal == 0 || (used != nullptr && used[i] == 0)) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const double f0 = double{linear_tables().srgb[pair.specular_gloss.values[4 * i + c]]};
      double of_metal = std::max(0.0, f0 - dielectric[c] * (1 - metal));
      // Diffuse is what base colour is where there is no metal.
      if (varies && metal < 1)
        of_metal =
            std::min(of_metal, light_of(pair.diffuse_alpha.values[4 * i + c] + 0.5) * metal / (1 - metal));
      for (const double factor : {colors.least[c], colors.most[c]})
        worst = std::max(worst, std::abs(unrounded_code(f0) - unrounded_code(f0 - of_metal * (1 - factor))));
    }
  }
  return worst;
}

// The cost at places between texels, where a sampler mixes them in equal parts. There diffuse of the material's own textures
// is that of the pair plus, and F0 that of the pair less, what base colour and metal vary together by: their mean
// product less the product of their means.
class BetweenTexels {
 public:
  BetweenTexels(const GltfMaterial& m, const Image8& base, const Image8& metal, const MaterialPair& pair,
                const std::uint8_t* used)
      : m_(m), base_(base), metal_(metal), pair_(pair), used_(used) {}

  double worst() {
    const int width = pair_.diffuse_alpha.width, height = pair_.diffuse_alpha.height;
    const GltfSampler& sampler = m_.base_color_texture->sampler;
    const auto at = [&](int x, int y) {
      return static_cast<std::size_t>(wrapped_texel(y, height, sampler.wrap_v)) *
                 static_cast<std::size_t>(width) +
             static_cast<std::size_t>(wrapped_texel(x, width, sampler.wrap_u));
    };
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const std::array<std::size_t, 4> corner{at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)};
        compare<2>({corner[0], corner[1]});
        compare<2>({corner[0], corner[2]});
        compare<4>(corner);
      }
    return worst_;
  }

 private:
  template <std::size_t count>
  void compare(const std::array<std::size_t, count>& texels) {
    const auto metal_of = [&](std::size_t i) {
      const auto channels = static_cast<std::size_t>(metal_.channels);
      return metal_.values[channels * i + (channels >= 3 ? 2 : 0)] * m_.metallic / 255;
    };
    double metal = 0;
    bool same = true;
    for (const std::size_t i : texels) {
      if (used_ != nullptr && used_[i] == 0) return;
      metal += metal_of(i) / count;
      same = same && metal_of(i) == metal_of(texels[0]);
    }
    if (same) return;
    for (std::size_t c = 0; c < 3; ++c) {
      double color = 0, product = 0;
      for (const std::size_t i : texels) {
        const auto channels = static_cast<std::size_t>(base_.channels);
        const double here =
            linear_tables().srgb[base_.values[channels * i + (channels < 3 ? 0 : c)]] * m_.base_color[c];
        color += here / count;
        product += here * metal_of(i) / count;
      }
      const double shift = product - color * metal;
      if (std::abs(shift) * steepest_code <= worst_) continue;
      differs(pair_.diffuse_alpha, texels, c, shift);
      differs(pair_.specular_gloss, texels, c, -shift);
    }
  }

  template <std::size_t count>
  void differs(const Image8& texture, const std::array<std::size_t, count>& texels, std::size_t c,
               double by) {
    double mean = 0;
    for (const std::size_t i : texels)
      mean += linear_tables().srgb[texture.values[4 * i + c]] / double{count};
    worst_ = std::max(worst_, std::abs(unrounded_code(mean + by) - unrounded_code(mean)));
  }

  const GltfMaterial& m_;
  const Image8& base_;
  const Image8& metal_;
  const MaterialPair& pair_;
  const std::uint8_t* const used_;
  double worst_ = 0;
};

std::string size_text(const Image8& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height);
}

// The pair as a sampler magnifies it, beside what its textures say there.
class Compared {
 public:
  Compared(const Sources& sources, const MaterialPair& pair, const GltfSampler& sampler,
           const std::uint8_t* used)
      : sources_(sources),
        pair_(pair),
        a_(pair.diffuse_alpha, sampler, true),
        b_(pair.specular_gloss, sampler, true),
        width_(pair.diffuse_alpha.width),
        height_(pair.diffuse_alpha.height),
        sampler_(sampler),
        used_(used) {}

  // The largest difference at the centres of the texels of a texture of this size, or so many texels beside them, and
  // at the edges where its sampler finds them again: of all places beyond there, some texels of the pair may be read alone.
  double worst(int width, int height, double right = 0, double down = 0,
               std::size_t values = without_light) const {
    double out = 0;
    for (const double v : places(height, down, sampler_.wrap_v))
      for (const double u : places(width, right, sampler_.wrap_u))
        if (is_read(u, v)) out = std::max(out, difference(u, v, values));
    return out;
  }

  // The worst difference at the pair's own texels and between them.
  double worst_everywhere() const {
    double out = worst(width_, height_, 0, 0, Look{}.size());
    if (sampler_.nearest) return out;
    for (const auto& [right, down] : {std::pair{0.5, 0.0}, {0.0, 0.5}, {0.5, 0.5}})
      out = std::max(out, worst(width_, height_, right, down));
    return out;
  }

  // The largest difference of diffuse light at the centres of texels whose F0 is bright, where it is more than a code.
  double worst_light() const {
    constexpr int least_bright =
        200;  // codes of F0 below which the rounding of codes cannot make a code of light
    double out = 0;
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        if (used_ != nullptr && used_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                      static_cast<std::size_t>(x)] == 0)
          continue;
        const auto f0 = pair_.specular_gloss.at(x, y), diffuse = pair_.diffuse_alpha.at(x, y);
        if (std::max({f0[0], f0[1], f0[2]}) < least_bright ||
            std::max({diffuse[0], diffuse[1], diffuse[2]}) == 0)
          continue;
        out =
            std::max(out, difference((x + 0.5) / width_, (y + 0.5) / height_, Look{}.size(), without_light));
      }
    return out > 1 ? out : 0;
  }

 private:
  static std::vector<double> places(int size, double shift, Wrap wrap) {
    std::vector<double> out;
    for (int i = 0; i < size; ++i) out.push_back((i + 0.5 + shift) / size);
    if (wrap != Wrap::repeat) out.insert(out.end(), {0, 1});
    return out;
  }

  // Whether one of the four texels that are mixed there is in use.
  bool is_read(double u, double v) const {
    if (used_ == nullptr) return true;
    const int left = static_cast<int>(std::floor(u * width_ - 0.5)),
              top = static_cast<int>(std::floor(v * height_ - 0.5));
    for (int k = 0; k < 4; ++k) {
      const int x = wrapped_texel(left + k % 2, width_, sampler_.wrap_u),
                y = wrapped_texel(top + k / 2, height_, sampler_.wrap_v);
      if (used_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                static_cast<std::size_t>(x)] != 0)
        return true;
    }
    return false;
  }

  double difference(double u, double v, std::size_t end, std::size_t begin = 0) const {
    const auto diffuse = a_.at(u, v), specular = b_.at(u, v);
    const Vec3 f0{specular[0], specular[1], specular[2]};
    const Look of_pair = look_of({{diffuse[0], diffuse[1], diffuse[2]}, f0}, specular[3],
                                 sources_.alpha_of(diffuse[3]), largest_channel(f0));
    return largest_difference(sources_.at(u, v), of_pair, begin, end);
  }

  const Sources& sources_;
  const MaterialPair& pair_;
  const Magnified a_, b_;
  const int width_, height_;
  const GltfSampler sampler_;
  const std::uint8_t* const used_;
};

}  // namespace

ConversionCost conversion_cost(const GltfMaterial& material, const SceneImages<std::uint8_t>& images,
                               const MaterialPair& pair, GlossForm gloss, const std::uint8_t* used,
                               const VertexColors& colors) {
  ConversionCost out;
  const VertexColors none;
  if (!material.specular_glossiness && (colors.least != none.least || colors.most != none.most))
    out.tinted = of_tinted_metal(
        material, scene_metallic(material, images, pair.specular_gloss.width, pair.specular_gloss.height),
        pair, used, colors);
  const bool varies = material.specular_texture || material.specular_color_texture;
  if (!material.specular_glossiness && !varies) out.partial = of_partly_metal(material, pair, used);
  const std::vector<const GltfTexture*> textures = replaced_textures(material);
  if (textures.empty() || (textures.size() < 2 && !varies && !material.specular_glossiness)) return out;
  const Sources sources{material, images, gloss};
  const Compared compared(sources, pair, textures.front()->sampler, used);
  std::vector<std::string> sizes;
  bool is_resized = false;
  for (const GltfTexture* texture : textures) {
    const Image8& image = images(texture->image);
    if (std::ranges::find(sizes, size_text(image)) == sizes.end()) sizes.push_back(size_text(image));
    if (image.pixel_count() == pair.diffuse_alpha.pixel_count()) continue;
    is_resized = true;
    const int width = pair.diffuse_alpha.width, height = pair.diffuse_alpha.height;
    // Without a filter the borders of texels matter: where sizes are no multiples they lie amid the pair's texels.
    if (!texture->sampler.nearest)
      out.resized = std::max(out.resized, compared.worst(image.width, image.height));
    else if (width % image.width != 0 || height % image.height != 0)
      out.resized = std::max(out.resized, compared.worst(4 * width, 4 * height));
  }
  if (is_resized) out.sizes = joined(sizes, " and ");
  if (material.specular_glossiness && !is_resized) out.behind = compared.worst_light();
  if (varies)
    out.between = compared.worst_everywhere();
  else if (!is_resized && !material.specular_glossiness && material.metallic > 0 &&
           !textures.front()->sampler.nearest)
    out.between =
        BetweenTexels(material, images(sources.color()->image), images(sources.second()->image), pair, used)
            .worst();
  return out;
}

std::optional<std::string> sentence_of(const ConversionCost& cost) {
  if (cost.is_exact()) return std::nullopt;
  std::vector<std::string> parts;
  const auto codes = [](double value) { return fixed(value, 1) + " codes"; };
  if (cost.partial >= ConversionCost::least_told)
    parts.push_back("diffuse light of texels that are partly metal differs by up to " + codes(cost.partial));
  if (cost.between >= ConversionCost::least_told)
    parts.push_back(
        "diffuse and F0 differ between texels, where metal meets what is less metal or textures of specular vary, by up to " +
        codes(cost.between));
  if (cost.resized >= ConversionCost::least_told)
    parts.push_back(
        "its textures of " + cost.sizes +
        " were filtered to one size, and at texel centres of the smaller one diffuse, F0, gloss or alpha differ by up to " +
        codes(cost.resized));
  if (cost.tinted >= ConversionCost::least_told)
    parts.push_back("F0 of metal, which vertex colours no longer multiply, differs by up to " +
                    codes(cost.tinted));
  if (cost.behind >= ConversionCost::least_told)
    parts.push_back("diffuse light behind F0 near white, whose codes are rounded, differs by up to " +
                    codes(cost.behind));
  return "as diffuse and F0 it is not quite what it was: " + joined(parts, "; ");
}

}  // namespace etak
