// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "core/color/srgb.h"
#include "core/image/wrap.h"
#include "core/scene/gltf_convert.h"
#include "core/scene/material_texels.h"

namespace etak {
namespace {

using Texel = std::array<double, 4>;

// A texture at the pair's size, as glTF fills up channels that are missing: linear light or plain numbers.
class FloatLookup {
 public:
  FloatLookup(const std::optional<GltfTexture>& texture, const SceneFloats& images, int width, int height,
              bool color)
      : width_(width), height_(height), color_(color) {
    if (!texture) return;
    image_ = &images(texture->image);
    sampler_ = texture->sampler;
  }

  // All ones without a texture. Bilinear where the picture is smaller, texel centres at halves.
  Texel at(int x, int y) const {
    if (image_ == nullptr) return {1, 1, 1, 1};
    if (image_->width == width_ && image_->height == height_) return texel(x, y);
    const double u = (x + 0.5) * image_->width / width_ - 0.5, v = (y + 0.5) * image_->height / height_ - 0.5;
    const int left = static_cast<int>(std::floor(u)), top = static_cast<int>(std::floor(v));
    const double right_share = sampler_.nearest ? std::round(u - left) : u - left;
    const double low_share = sampler_.nearest ? std::round(v - top) : v - top;
    Texel sum{};
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        const double share = (i == 0 ? 1 - right_share : right_share) * (j == 0 ? 1 - low_share : low_share);
        const Texel one = texel(wrapped_texel(left + i, image_->width, sampler_.wrap_u),
                                wrapped_texel(top + j, image_->height, sampler_.wrap_v));
        for (std::size_t c = 0; c < 4; ++c) sum[c] += share * one[c];
      }
    return sum;
  }

 private:
  Texel texel(int x, int y) const {
    const auto v = image_->at(x, y);
    const bool grey = image_->channels <= 2;
    Texel out{double{v[0]}, double{v[grey ? 0 : 1]}, double{v[grey ? 0 : 2]}, 1};
    if (image_->channels % 2 == 0) out[3] = double{v[static_cast<std::size_t>(image_->channels) - 1]};
    if (color_)
      for (std::size_t c = 0; c < 3; ++c) out[c] = srgb_decode(out[c]);
    return out;
  }

  const Image* image_ = nullptr;
  GltfSampler sampler_;
  int width_, height_;
  bool color_;
};

void put(Image& image, int x, int y, const Vec3& color, double fourth) {
  const auto to = image.at(x, y);
  for (std::size_t c = 0; c < 3; ++c) to[c] = static_cast<float>(color[c]);
  to[3] = static_cast<float>(fourth);
}

Vec3 product(const Texel& texel, const double* factor) {
  return {texel[0] * factor[0], texel[1] * factor[1], texel[2] * factor[2]};
}

}  // namespace

FloatPair scene_material_floats(const GltfMaterial& m, const SceneFloats& images, GlossForm gloss,
                                bool keep_alpha) {
  int width = 1, height = 1;
  for (const GltfTexture* texture : replaced_textures(m)) {
    width = std::max(width, images(texture->image).width);
    height = std::max(height, images(texture->image).height);
  }
  const auto lookup = [&](const std::optional<GltfTexture>& texture, bool color) {
    return FloatLookup(texture, images, width, height, color);
  };
  const bool opaque = m.alpha_mode == AlphaMode::opaque && !keep_alpha;
  FloatPair out{Image(width, height, 4), Image(width, height, 4)};
  if (m.specular_glossiness) {
    const FloatLookup diffuse = lookup(m.diffuse_texture, true),
                      f0 = lookup(m.specular_glossiness_texture, true);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const Texel d = diffuse.at(x, y), s = f0.at(x, y);
        put(out.diffuse_alpha, x, y, product(d, m.diffuse.data()), opaque ? 1 : d[3] * m.diffuse[3]);
        put(out.specular_gloss, x, y, product(s, m.specular_f0.data()),
            converted_gloss(s[3] * m.glossiness, GlossForm::one_minus_roughness, gloss));
      }
    return out;
  }
  const FloatLookup base = lookup(m.base_color_texture, true),
                    rough = lookup(m.metallic_roughness_texture, false),
                    specular = lookup(m.specular_texture, false),
                    tint = lookup(m.specular_color_texture, true);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Texel b = base.at(x, y), r = rough.at(x, y);
      const DiffuseSpecular ds =
          diffuse_specular(product(b, m.base_color.data()), m.metallic * r[2],
                           dielectric_f0(m.ior, m.specular * specular.at(x, y)[3],
                                         product(tint.at(x, y), m.specular_color.data())));
      put(out.diffuse_alpha, x, y, ds.diffuse, opaque ? 1 : b[3] * m.base_color[3]);
      put(out.specular_gloss, x, y, ds.f0, converted_gloss(r[1] * m.roughness, GlossForm::roughness, gloss));
    }
  return out;
}

}  // namespace etak
