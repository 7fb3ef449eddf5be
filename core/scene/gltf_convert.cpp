// SPDX-License-Identifier: Apache-2.0
#include "core/scene/gltf_convert.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/color/srgb.h"
#include "core/image/linear_tables.h"
#include "core/image/wrap.h"
#include "core/scene/material_texels.h"

namespace etak {
namespace {

// None for a transform that leaves no area.
std::optional<UvMatrix> inverse(const UvMatrix& m) {
  const double area = m[0] * m[4] - m[1] * m[3];
  if (std::abs(area) < 1e-12) return std::nullopt;
  const UvMatrix turn{m[4] / area, -m[1] / area, 0, -m[3] / area, m[0] / area, 0};
  const Uv origin = turn * Uv{m[2], m[5]};
  return UvMatrix{turn[0], turn[1], -origin[0], turn[3], turn[4], -origin[1]};
}

// A texture at the pair's size: four channels, where the picture has fewer as glTF fills them up.
class CodeLookup {
 public:
  CodeLookup(const std::optional<GltfTexture>& texture, const SceneImages& images, int width, int height,
             bool color) {
    if (!texture) return;
    const Image8& image = images(texture->image);
    if (image.width == width && image.height == height)
      source_ = &image;
    else
      scale(image, texture->sampler, width, height, color);
  }

  explicit operator bool() const { return source_ != nullptr || !scaled_.values.empty(); }

  std::array<std::uint8_t, 4> at(std::size_t texel) const {
    const Image8& image = source_ != nullptr ? *source_ : scaled_;
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::uint8_t* v = image.values.data() + texel * channels;
    switch (channels) {
      case 1:
        return {v[0], v[0], v[0], 255};
      case 2:
        return {v[0], v[0], v[0], v[1]};
      case 3:
        return {v[0], v[1], v[2], 255};
      default:
        return {v[0], v[1], v[2], v[3]};
    }
  }

 private:
  // Bilinear, texel centres at halves, as a sampler magnifies.
  void scale(const Image8& image, const GltfSampler& sampler, int width, int height, bool color) {
    scaled_ = Image8(width, height, image.channels);
    const auto& linear = linear_tables().srgb;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const double u = (x + 0.5) * image.width / width - 0.5, v = (y + 0.5) * image.height / height - 0.5;
        const int left = static_cast<int>(std::floor(u)), top = static_cast<int>(std::floor(v));
        const double right_share = sampler.nearest ? std::round(u - left) : u - left;
        const double low_share = sampler.nearest ? std::round(v - top) : v - top;
        const int xs[2] = {wrapped_texel(left, image.width, sampler.wrap_u),
                           wrapped_texel(left + 1, image.width, sampler.wrap_u)};
        const int ys[2] = {wrapped_texel(top, image.height, sampler.wrap_v),
                           wrapped_texel(top + 1, image.height, sampler.wrap_v)};
        for (std::size_t c = 0; c < static_cast<std::size_t>(image.channels); ++c) {
          const bool curve = color && c < 3;
          const auto value = [&](int i, int j) {
            const std::uint8_t one = image.at(xs[i], ys[j])[c];
            return curve ? double{linear[one]} : one / 255.0;
          };
          const double mean =
              (value(0, 0) * (1 - right_share) + value(1, 0) * right_share) * (1 - low_share) +
              (value(0, 1) * (1 - right_share) + value(1, 1) * right_share) * low_share;
          scaled_.at(x, y)[c] = curve ? srgb_u8(mean) : plain_u8(mean);
        }
      }
  }

  const Image8* source_ = nullptr;
  Image8 scaled_;
};

struct Target {
  std::uint8_t *a, *b;
};

class Converter {
 public:
  Converter(const GltfMaterial& material, const SceneImages& images, GlossForm gloss, bool keep_alpha)
      : m_(material), images_(images), gloss_(gloss), keep_alpha_(keep_alpha) {
    for (const GltfTexture* texture : replaced_textures(m_)) {
      const Image8& image = images_(texture->image);
      width_ = std::max(width_, image.width);
      height_ = std::max(height_, image.height);
    }
  }

  MaterialPair run(std::size_t& clamped) {
    MaterialPair out{Image8(width_, height_, 4), Image8(width_, height_, 4)};
    const std::size_t texels = out.diffuse_alpha.pixel_count();
    const auto target = [&](std::size_t i) {
      return Target{out.diffuse_alpha.values.data() + 4 * i, out.specular_gloss.values.data() + 4 * i};
    };
    if (m_.specular_glossiness)
      specular_glossiness(texels, target, clamped);
    else
      metal_rough(texels, target, clamped);
    return out;
  }

 private:
  CodeLookup lookup(const std::optional<GltfTexture>& texture, bool color) const {
    return {texture, images_, width_, height_, color};
  }

  std::uint8_t alpha(std::uint8_t texture, double factor) const {
    if (m_.alpha_mode == AlphaMode::opaque && !keep_alpha_) return 255;
    return plain_u8(texture / 255.0 * factor);
  }

  // Codes of gloss for codes of roughness (or of glossiness) under a factor.
  struct GlossTable {
    std::array<std::uint8_t, 256> codes{};
    std::array<bool, 256> clamped{};
  };
  GlossTable gloss_table(double factor, bool glossiness) const {
    GlossTable out;
    for (std::size_t i = 0; i < 256; ++i) {
      const double v = static_cast<double>(i) / 255 * factor;
      const double value =
          converted_gloss(v, glossiness ? GlossForm::one_minus_roughness : GlossForm::roughness, gloss_);
      out.codes[i] = plain_u8(value);
      out.clamped[i] = value < -1e-12 || value > 1 + 1e-12;
    }
    return out;
  }

  template <class At>
  void metal_rough(std::size_t texels, At at, std::size_t& clamped) const {
    const CodeLookup base = lookup(m_.base_color_texture, true),
                     rough = lookup(m_.metallic_roughness_texture, false),
                     specular = lookup(m_.specular_texture, false),
                     tint = lookup(m_.specular_color_texture, true);
    const Vec3 color{m_.base_color[0], m_.base_color[1], m_.base_color[2]};
    const Vec3 tint_factor{m_.specular_color[0], m_.specular_color[1], m_.specular_color[2]};
    const MetalRoughCodes codes(color, m_.metallic, dielectric_f0(m_.ior, m_.specular, tint_factor));
    const GlossTable gloss = gloss_table(m_.roughness, false);
    const auto& linear = linear_tables().srgb;
    for (std::size_t i = 0; i < texels; ++i) {
      const Target to = at(i);
      const auto b = base ? base.at(i) : std::array<std::uint8_t, 4>{255, 255, 255, 255};
      const auto r = rough ? rough.at(i) : std::array<std::uint8_t, 4>{255, 255, 255, 255};
      if (specular || tint) {
        const double scale = m_.specular * (specular ? specular.at(i)[3] / 255.0 : 1);
        Vec3 one = tint_factor;
        if (tint)
          for (std::size_t c = 0; c < 3; ++c) one[c] *= double{linear[tint.at(i)[c]]};
        Vec3 texel = color;
        for (std::size_t c = 0; c < 3; ++c) texel[c] *= double{linear[b[c]]};
        const DiffuseSpecular ds =
            diffuse_specular(texel, m_.metallic * r[2] / 255, dielectric_f0(m_.ior, scale, one));
        for (std::size_t c = 0; c < 3; ++c) to.a[c] = srgb_u8(ds.diffuse[c]), to.b[c] = srgb_u8(ds.f0[c]);
      } else {
        codes.convert(b.data(), r[2], to.a, to.b);
      }
      to.a[3] = alpha(b[3], m_.base_color[3]);
      to.b[3] = gloss.codes[r[1]];
      clamped += gloss.clamped[r[1]] ? 1 : 0;
    }
  }

  template <class At>
  void specular_glossiness(std::size_t texels, At at, std::size_t& clamped) const {
    const CodeLookup diffuse = lookup(m_.diffuse_texture, true),
                     f0 = lookup(m_.specular_glossiness_texture, true);
    std::array<std::array<std::uint8_t, 256>, 3> diffuse_codes, f0_codes;
    const auto& linear = linear_tables().srgb;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < 256; ++i) {
        diffuse_codes[c][i] = srgb_u8(double{linear[i]} * m_.diffuse[c]);
        f0_codes[c][i] = srgb_u8(double{linear[i]} * m_.specular_f0[c]);
      }
    const GlossTable gloss = gloss_table(m_.glossiness, true);
    for (std::size_t i = 0; i < texels; ++i) {
      const Target to = at(i);
      const auto d = diffuse ? diffuse.at(i) : std::array<std::uint8_t, 4>{255, 255, 255, 255};
      const auto s = f0 ? f0.at(i) : std::array<std::uint8_t, 4>{255, 255, 255, 255};
      for (std::size_t c = 0; c < 3; ++c) to.a[c] = diffuse_codes[c][d[c]], to.b[c] = f0_codes[c][s[c]];
      to.a[3] = alpha(d[3], m_.diffuse[3]);
      to.b[3] = gloss.codes[s[3]];
      clamped += gloss.clamped[s[3]] ? 1 : 0;
    }
  }

  const GltfMaterial& m_;
  const SceneImages& images_;
  const GlossForm gloss_;
  const bool keep_alpha_;
  int width_ = 1, height_ = 1;
};

}  // namespace

std::optional<TextureOnTexture> normals_on_pair(const GltfTexture& map, const GltfTexture& lead,
                                                const TexelUse& use) {
  const std::array wrap{map.sampler.wrap_u, map.sampler.wrap_v};
  if (map.uv_set != lead.uv_set) return std::nullopt;
  if (map.transform == lead.transform && wrap == std::array{lead.sampler.wrap_u, lead.sampler.wrap_v})
    return TextureOnTexture{{1, 0, 0, 0, 1, 0}, wrap};
  const auto back = inverse(uv_matrix(lead.transform)), unfold = inverse(uv_matrix(use.fold));
  if (!back || !unfold) return std::nullopt;
  const UvMatrix to_map = uv_matrix(map.transform) * (*back * *unfold);
  const auto whole = [](double v) { return std::abs(v - std::round(v)) < 1e-9; };
  const auto repeats = [](const GltfSampler& s) {
    return s.wrap_u == Wrap::repeat && s.wrap_v == Wrap::repeat;
  };
  const bool periodic = repeats(lead.sampler) && repeats(map.sampler) && whole(to_map[0]) &&
                        whole(to_map[1]) && whole(to_map[3]) && whole(to_map[4]);
  if (use.tiles && !periodic) return std::nullopt;
  return TextureOnTexture{to_map, wrap};
}

Image8 scaled_normals(const Image8& map, double scale, int width, int height, const TextureOnTexture& place) {
  constexpr int most_places = 8;
  const UvMatrix& m = place.to_map;
  // Steps on the map, in its texels, of one texel to the right and one down.
  const double right[] = {m[0] * map.width / width, m[3] * map.height / width},
               down[] = {m[1] * map.width / height, m[4] * map.height / height};
  const double longest =
      std::max(std::abs(right[0]) + std::abs(down[0]), std::abs(right[1]) + std::abs(down[1]));
  const int places = std::clamp(static_cast<int>(std::ceil(longest - 1e-9)), 1, most_places);
  const auto texel = [](double at, int size, Wrap wrap) {
    return wrapped_texel(static_cast<int>(std::clamp(std::floor(at), -1e9, 1e9)), size, wrap);
  };
  Image8 out(width, height, 3);
  const bool grey = map.channels < 3;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      Vec3 sum{0, 0, 0};
      for (int k = 0; k < places * places; ++k) {
        const double column = x + (k % places + 0.5) / places, row = y + (k / places + 0.5) / places;
        const auto from =
            map.at(texel(m[2] * map.width + column * right[0] + row * down[0], map.width, place.wrap[0]),
                   texel(m[5] * map.height + column * right[1] + row * down[1], map.height, place.wrap[1]));
        Vec3 v;
        for (std::size_t c = 0; c < 3; ++c) v[c] = (from[grey ? 0 : c] / 127.5 - 1) * (c < 2 ? scale : 1);
        const double length = scale == 1 ? 1 : std::max(1e-6, std::hypot(v[0], v[1], v[2]));
        for (std::size_t c = 0; c < 3; ++c) sum[c] += v[c] / length;
      }
      for (std::size_t c = 0; c < 3; ++c)
        out.at(x, y)[c] =
            static_cast<std::uint8_t>(std::clamp((sum[c] / (places * places) + 1) * 127.5 + 0.5, 0.0, 255.0));
    }
  return out;
}

MaterialPair scene_material_pair(const GltfMaterial& material, const SceneImages& images, GlossForm gloss,
                                 bool keep_alpha, std::size_t& clamped) {
  return Converter(material, images, gloss, keep_alpha).run(clamped);
}

}  // namespace etak
