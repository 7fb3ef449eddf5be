// SPDX-License-Identifier: Apache-2.0
#include "core/scene/gltf_convert.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "core/base/error.h"
#include "core/color/srgb.h"
#include "core/image/linear_tables.h"
#include "core/image/picture.h"
#include "core/image/wrap.h"
#include "core/math/functions.h"
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

// Texels of codes stay codes; texels of floats hold linear light and plain numbers.
template <class Value>
using Texel = std::array<std::conditional_t<sizeof(Value) == 1, std::uint8_t, double>, 4>;

double plain_of(std::uint8_t code) {
  return code / 255.0;
}
double plain_of(double value) {
  return value;
}

void put(double linear, std::uint8_t& to) {
  to = srgb_u8(linear);
}
void put(double linear, float& to) {
  to = static_cast<float>(linear);
}

// A texture at the pair's size. Missing channels are filled as glTF says; without a texture all are full.
template <class Value>
class TextureLookup {
 public:
  TextureLookup(const std::optional<GltfTexture>& texture, const SceneImages<Value>& images, int width,
                int height, bool color)
      : width_(width), height_(height), color_(color) {
    if (!texture) return;
    image_ = &images(texture->image);
    channels_ = static_cast<std::size_t>(image_->channels);
    sampler_ = texture->sampler;
    if (image_->width == width && image_->height == height) same_ = image_->values.data();
  }

  explicit operator bool() const { return image_ != nullptr; }

  Texel<Value> at(int x, int y) const {
    if (same_ == nullptr) return image_ == nullptr ? Texel<Value>{full, full, full, full} : scaled(x, y);
    const std::size_t texel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    const std::array<Value, 4> stored = four_channels(same_ + channels_ * texel, channels_, full);
    if constexpr (codes) {
      return stored;
    } else {
      Texel<Value> out;
      for (std::size_t c = 0; c < 4; ++c) out[c] = number(stored[c], color_ && c < 3);
      return out;
    }
  }

 private:
  static constexpr bool codes = sizeof(Value) == 1;
  static constexpr Value full = codes ? 255 : 1;

  // Linear light of a colour, which a curve stands for, or the number itself.
  double number(Value value, bool curve) const {
    if constexpr (codes)
      return curve ? double{linear_[value]} : plain_of(value);
    else
      return curve ? srgb_decode(double{value}) : double{value};
  }

  // Bilinear, texel centres at halves, as a sampler magnifies.
  Texel<Value> scaled(int x, int y) const {
    const double u = (x + 0.5) * image_->width / width_ - 0.5, v = (y + 0.5) * image_->height / height_ - 0.5;
    const int left = static_cast<int>(std::floor(u)), top = static_cast<int>(std::floor(v));
    const double right_share = sampler_.nearest ? std::round(u - left) : u - left;
    const double low_share = sampler_.nearest ? std::round(v - top) : v - top;
    const auto corner = [&](int i, int j) {
      return image_
          ->at(wrapped_texel(left + i, image_->width, sampler_.wrap_u),
               wrapped_texel(top + j, image_->height, sampler_.wrap_v))
          .data();
    };
    const Value *a = corner(0, 0), *b = corner(1, 0), *c = corner(0, 1), *d = corner(1, 1);
    Texel<Value> out;
    for (std::size_t i = 0; i < channels_; ++i) {
      const bool curve = color_ && i < (channels_ < 3 ? 1 : 3);
      const double mean =
          (number(a[i], curve) * (1 - right_share) + number(b[i], curve) * right_share) * (1 - low_share) +
          (number(c[i], curve) * (1 - right_share) + number(d[i], curve) * right_share) * low_share;
      if constexpr (codes)
        out[i] = curve ? srgb_u8(mean) : plain_u8(mean);
      else
        out[i] = mean;
    }
    return four_channels(out.data(), channels_, typename Texel<Value>::value_type{full});
  }

  const Pixels<Value>* image_ = nullptr;
  const Value* same_ = nullptr;  // the values of a picture of the pair's size
  std::size_t channels_ = 0;
  GltfSampler sampler_;
  int width_, height_;
  bool color_;
  const std::array<float, 256>& linear_ = linear_tables().srgb;
};

// Colours under a factor, and gloss, as the pair holds them: of codes from tables.
template <class Value>
struct FactorOf {
  const double* factor;
  float operator()(double linear, std::size_t c) const { return static_cast<float>(linear * factor[c]); }
};

template <>
struct FactorOf<std::uint8_t> {
  explicit FactorOf(const double* factor) {
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < 256; ++i)
        codes[c][i] = srgb_u8(double{linear_tables().srgb[i]} * factor[c]);
  }
  std::uint8_t operator()(std::uint8_t code, std::size_t c) const { return codes[c][code]; }
  std::array<std::array<std::uint8_t, 256>, 3> codes;
};

template <class Value>
struct GlossOf {
  double factor;
  GlossForm from, to;
  float operator()(double v, std::size_t&) const {
    return static_cast<float>(converted_gloss(v * factor, from, to));
  }
};

template <>
struct GlossOf<std::uint8_t> {
  GlossOf(double factor, GlossForm from, GlossForm to) {
    for (std::size_t i = 0; i < 256; ++i) {
      const double value = converted_gloss(static_cast<double>(i) / 255 * factor, from, to);
      codes[i] = plain_u8(value);
      outside[i] = value < -1e-12 || value > 1 + 1e-12;
    }
  }
  std::uint8_t operator()(std::uint8_t code, std::size_t& clamped) const {
    clamped += outside[code] ? 1 : 0;
    return codes[code];
  }
  std::array<std::uint8_t, 256> codes{};
  std::array<bool, 256> outside{};
};

template <class Value>
class Converter {
 public:
  Converter(const GltfMaterial& material, const SceneImages<Value>& images, GlossForm gloss, bool keep_alpha,
            std::size_t& clamped)
      : m_(material),
        images_(images),
        gloss_(gloss),
        opaque_(material.alpha_mode == AlphaMode::opaque && !keep_alpha),
        clamped_(clamped) {
    for (const GltfTexture* texture : replaced_textures(m_)) {
      const Pixels<Value>& image = images_(texture->image);
      width_ = std::max(width_, image.width);
      height_ = std::max(height_, image.height);
    }
  }

  PairOf<Value> run() {
    out_ = {Pixels<Value>(width_, height_, 4), Pixels<Value>(width_, height_, 4)};
    if (m_.specular_glossiness)
      specular_glossiness();
    else
      metal_rough();
    return std::move(out_);
  }

 private:
  TextureLookup<Value> lookup(const std::optional<GltfTexture>& texture, bool color) const {
    return {texture, images_, width_, height_, color};
  }

  Value alpha(double texture, double factor) const {
    const double value = opaque_ ? 1 : texture * factor;
    if constexpr (sizeof(Value) == 1)
      return plain_u8(value);
    else
      return static_cast<float>(value);
  }

  Vec3 color_of(const Texel<Value>& texel, const std::array<double, 3>& factor) const {
    Vec3 out;
    for (std::size_t c = 0; c < 3; ++c)
      if constexpr (sizeof(Value) == 1)
        out[c] = double{linear_[texel[c]]} * factor[c];
      else
        out[c] = texel[c] * factor[c];
    return out;
  }

  // Calls texel(x, y, a, b) for every texel; its values in the two textures are written to a and b.
  template <class Each>
  void each_texel(Each texel) {
    Value *a = out_.diffuse_alpha.values.data(), *b = out_.specular_gloss.values.data();
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x, a += 4, b += 4) texel(x, y, a, b);
  }

  void metal_rough() {
    const TextureLookup<Value> base = lookup(m_.base_color_texture, true),
                               rough = lookup(m_.metallic_roughness_texture, false),
                               specular = lookup(m_.specular_texture, false),
                               tint = lookup(m_.specular_color_texture, true);
    const Vec3 no_tint{m_.specular_color[0], m_.specular_color[1], m_.specular_color[2]};
    const Vec3 base_factor{m_.base_color[0], m_.base_color[1], m_.base_color[2]};
    const MetalRoughCodes codes(base_factor, m_.metallic, dielectric_f0(m_.ior, m_.specular, no_tint));
    const GlossOf<Value> gloss{m_.roughness, GlossForm::roughness, gloss_};
    each_texel([&](int x, int y, Value* to_a, Value* to_b) {
      const Texel<Value> b = base.at(x, y), r = rough.at(x, y);
      const auto by_numbers = [&] {
        const Vec3 color = tint ? color_of(tint.at(x, y), no_tint) : no_tint;
        const double scale = specular ? m_.specular * plain_of(specular.at(x, y)[3]) : m_.specular;
        const DiffuseSpecular ds = diffuse_specular(color_of(b, base_factor), m_.metallic * plain_of(r[2]),
                                                    dielectric_f0(m_.ior, scale, color));
        for (std::size_t c = 0; c < 3; ++c) put(ds.diffuse[c], to_a[c]), put(ds.f0[c], to_b[c]);
      };
      if constexpr (sizeof(Value) == 1) {
        if (specular || tint)
          by_numbers();
        else
          codes.convert(b.data(), r[2], to_a, to_b);
      } else {
        by_numbers();
      }
      to_a[3] = alpha(plain_of(b[3]), m_.base_color[3]);
      to_b[3] = gloss(r[1], clamped_);
    });
  }

  void specular_glossiness() {
    const TextureLookup<Value> diffuse = lookup(m_.diffuse_texture, true),
                               f0 = lookup(m_.specular_glossiness_texture, true);
    const FactorOf<Value> diffuse_color{m_.diffuse.data()}, f0_color{m_.specular_f0.data()};
    const GlossOf<Value> gloss{m_.glossiness, GlossForm::one_minus_roughness, gloss_};
    each_texel([&](int x, int y, Value* to_a, Value* to_b) {
      const Texel<Value> d = diffuse.at(x, y), s = f0.at(x, y);
      for (std::size_t c = 0; c < 3; ++c) to_a[c] = diffuse_color(d[c], c), to_b[c] = f0_color(s[c], c);
      to_a[3] = alpha(plain_of(d[3]), m_.diffuse[3]);
      to_b[3] = gloss(s[3], clamped_);
    });
  }

  const GltfMaterial& m_;
  const SceneImages<Value>& images_;
  const GlossForm gloss_;
  const bool opaque_;
  std::size_t& clamped_;
  const std::array<float, 256>& linear_ = linear_tables().srgb;
  int width_ = 1, height_ = 1;
  PairOf<Value> out_;
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
        const double length = scale == 1 ? 1 : std::max(1e-6, math::hypot(v[0], v[1], v[2]));
        for (std::size_t c = 0; c < 3; ++c) sum[c] += v[c] / length;
      }
      for (std::size_t c = 0; c < 3; ++c)
        out.at(x, y)[c] =
            static_cast<std::uint8_t>(std::clamp((sum[c] / (places * places) + 1) * 127.5 + 0.5, 0.0, 255.0));
    }
  return out;
}

template <class Value>
PairOf<Value> scene_material_pair(const GltfMaterial& material, const SceneImages<Value>& images,
                                  GlossForm gloss, bool keep_alpha, std::size_t& clamped) {
  return Converter<Value>(material, images, gloss, keep_alpha, clamped).run();
}

Image8 scene_metallic(const GltfMaterial& material, const SceneImages<std::uint8_t>& images, int width,
                      int height) {
  if (material.specular_glossiness) return {};
  Image8 out(width, height, 1, plain_u8(material.metallic));
  if (!material.metallic_roughness_texture) return out;
  const Image8& source = images(material.metallic_roughness_texture->image);
  const std::size_t channel = source.channels >= 3 ? 2 : 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto texel =
          source.at(texel_under(x, width, source.width), texel_under(y, height, source.height));
      const double value = texel[channel] * material.metallic;
      out.at(x, y)[0] = static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
    }
  return out;
}

template MaterialPair scene_material_pair(const GltfMaterial&, const SceneImages<std::uint8_t>&, GlossForm,
                                          bool, std::size_t&);
template FloatPair scene_material_pair(const GltfMaterial&, const SceneImages<float>&, GlossForm, bool,
                                       std::size_t&);

}  // namespace etak
