// SPDX-License-Identifier: Apache-2.0
#include "tests/core/atlas/shaded_scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/light/lights.h"
#include "tests/core/atlas/scene_support.h"

namespace etak::test {
namespace shading {
namespace {

using Place = std::array<Uv, 2>;  // one and the same place, by UV set

double dot(const Vec3& a, const Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// What a shader has of a material at one place.
struct Surface {
  Vec3 base{1, 1, 1}, dielectric{0, 0, 0};  // colour of metal and of diffuse light; F0 of the dielectric
  double metallic = 0, roughness = 1, opacity = 1, f90 = 1;
  Vec3 normal{0, 0, 1};  // of length 1, in the frame of the triangle
};

// Textures as samplers find them at level 0.
class Samplers {
 public:
  Samplers(ReadPictures& pictures, bool nearest) : pictures_(pictures), nearest_(nearest) {}

  // Fractions; colours in linear light. Full where there is no texture.
  std::array<double, 4> at(const std::optional<GltfTexture>& texture, const Place& uv, bool color) {
    if (!texture) return {1, 1, 1, 1};
    const Image8& image = pictures_(texture->image);
    const Uv at = transformed(texture->transform, uv[static_cast<std::size_t>(texture->uv_set)]);
    const double u = at[0] * image.width - 0.5, v = at[1] * image.height - 0.5;
    const double left = std::floor(u), top = std::floor(v);
    double right_share = u - left, low_share = v - top;
    if (nearest_) right_share = std::round(right_share), low_share = std::round(low_share);
    std::array<double, 4> out{};
    for (int k = 0; k < 4; ++k) {
      const double share =
          (k % 2 == 0 ? 1 - right_share : right_share) * (k / 2 == 0 ? 1 - low_share : low_share);
      if (share == 0) continue;
      const int x = static_cast<int>(wrapped(left + k % 2, image.width, texture->sampler.wrap_u));
      const int y = static_cast<int>(wrapped(top + k / 2, image.height, texture->sampler.wrap_v));
      const auto texel =
          four_channels(image.at(x, y).data(), static_cast<std::size_t>(image.channels), std::uint8_t{255});
      for (std::size_t c = 0; c < 4; ++c)
        out[c] += share * (color && c < 3 ? decoded_[texel[c]] : texel[c] / 255.0);
    }
    return out;
  }

  // Whether a float's rounding could lead to the next texel.
  bool is_near_edge(const std::optional<GltfTexture>& texture, const Place& uv) {
    if (!texture) return false;
    const Image8& image = pictures_(texture->image);
    const Uv at = transformed(texture->transform, uv[static_cast<std::size_t>(texture->uv_set)]);
    const auto near = [](double texels) { return std::abs(texels - std::round(texels)) < 0.05; };
    return near(at[0] * image.width) || near(at[1] * image.height);
  }

 private:
  static std::array<double, 256> decoded() {
    std::array<double, 256> out;
    for (std::size_t i = 0; i < 256; ++i) out[i] = srgb_decode(static_cast<double>(i) / 255);
    return out;
  }
  ReadPictures& pictures_;
  bool nearest_;
  std::array<double, 256> decoded_ = decoded();
};

Vec3 normal_at(const GltfMaterial& m, Samplers& samplers, const Place& uv) {
  if (!m.normal_texture) return {0, 0, 1};
  const auto codes = samplers.at(m.normal_texture, uv, false);
  Vec3 out{(2 * codes[0] - 1) * m.normal_scale, (2 * codes[1] - 1) * m.normal_scale, 2 * codes[2] - 1};
  const double length = std::hypot(out[0], out[1], out[2]);
  for (double& each : out) each /= length;
  return out;
}

Surface surface_at(const GltfMaterial& m, Samplers& samplers, const Place& uv) {
  Surface out;
  out.normal = normal_at(m, samplers, uv);
  if (m.specular_glossiness) {
    const auto d = samplers.at(m.diffuse_texture, uv, true),
               s = samplers.at(m.specular_glossiness_texture, uv, true);
    for (std::size_t c = 0; c < 3; ++c)
      out.base[c] = d[c] * m.diffuse[c], out.dielectric[c] = s[c] * m.specular_f0[c];
    out.roughness = 1 - s[3] * m.glossiness;
    out.opacity = d[3] * m.diffuse[3];
  } else {
    const auto b = samplers.at(m.base_color_texture, uv, true),
               r = samplers.at(m.metallic_roughness_texture, uv, false),
               tint = samplers.at(m.specular_color_texture, uv, true),
               weight = samplers.at(m.specular_texture, uv, false);
    const double ratio = (m.ior - 1) / (m.ior + 1), scale = m.ior == 0 ? 1 : ratio * ratio;
    out.f90 = m.specular * weight[3];
    for (std::size_t c = 0; c < 3; ++c) {
      out.base[c] = b[c] * m.base_color[c];
      out.dielectric[c] = std::min(1.0, scale * m.specular_color[c] * tint[c]) * out.f90;
    }
    out.metallic = r[2] * m.metallic;
    out.roughness = r[1] * m.roughness;
    out.opacity = b[3] * m.base_color[3];
  }
  if (m.alpha_mode == AlphaMode::opaque) out.opacity = 1;
  return out;
}

// GGX and Smith's masking of correlated heights, divided by 4 nl nv.
double lobe(double roughness, double nl, double nv, double nh) {
  const double alpha = std::max(1e-3, roughness * roughness), square = alpha * alpha;
  const double d = square / (std::numbers::pi * std::pow(nh * nh * (square - 1) + 1, 2));
  const auto mask = [&](double a, double b) { return a * std::sqrt(b * b * (1 - square) + square); };
  return d * 0.5 / (mask(nl, nv) + mask(nv, nl));
}

// Radiance under one light, as codes; alpha beside it.
std::array<double, 4> shaded(const Surface& s, const Light& light, const Vec3& view) {
  const Vec3 to{-light.direction[0], -light.direction[1], -light.direction[2]};
  Vec3 half{to[0] + view[0], to[1] + view[1], to[2] + view[2]};
  const double length = std::hypot(half[0], half[1], half[2]);
  for (double& each : half) each /= length;
  const double nl = dot(s.normal, to), nv = std::max(1e-4, dot(s.normal, view)), nh = dot(s.normal, half),
               vh = dot(view, half);
  std::array<double, 4> out{0, 0, 0, 255 * s.opacity};
  if (nl <= 0) return out;
  const double rise = std::pow(1 - vh, 5), specular = lobe(s.roughness, nl, nv, nh);
  const auto fresnel = [&](double f0, double f90) { return f0 + (f90 - f0) * rise; };
  double most = 0;
  for (const double f0 : s.dielectric) most = std::max(most, fresnel(f0, s.f90));
  for (std::size_t c = 0; c < 3; ++c) {
    const double dielectric =
        (1 - most) * s.base[c] / std::numbers::pi + specular * fresnel(s.dielectric[c], s.f90);
    const double metal = specular * fresnel(s.base[c], 1);
    const double value =
        ((1 - s.metallic) * dielectric + s.metallic * metal) * nl * light.color[c] * light.intensity;
    out[c] = 255 * srgb_encode(std::min(1.0, value));
  }
  return out;
}

double largest_difference(const Surface& a, const Surface& b) {
  static const LightSetup setup = default_lights();
  double worst = 0;
  for (const double degrees : {0.0, 20.0, 40.0, 60.0, 75.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const Vec3 view{std::sin(angle), 0, std::cos(angle)};
    for (const Light& light : setup.lights) {
      // The rim comes from behind: it is turned to the front, so that it lights what is looked at.
      Light front = light;
      front.direction[2] = -std::abs(front.direction[2]);
      const auto x = shaded(a, front, view), y = shaded(b, front, view);
      for (std::size_t c = 0; c < 4; ++c) worst = std::max(worst, std::abs(x[c] - y[c]));
    }
  }
  return worst;
}

// The place on triangle t that lies a and b along its edges.
Place mixed(const GltfUse& use, std::size_t t, double a, double b) {
  Place out{};
  for (std::size_t set = 0; set < 2; ++set) {
    if (use.uv[set].empty()) continue;
    const auto& corners = use.uv[set][t];
    for (std::size_t k = 0; k < 2; ++k)
      out[set][k] = double{corners[0][k]} + a * (double{corners[1][k]} - double{corners[0][k]}) +
                    b * (double{corners[2][k]} - double{corners[0][k]});
  }
  return out;
}

double area(const std::array<std::array<float, 2>, 3>& uv) {
  const auto edge = [&](std::size_t i, std::size_t k) { return double{uv[i][k]} - double{uv[0][k]}; };
  return std::abs(edge(1, 0) * edge(2, 1) - edge(1, 1) * edge(2, 0)) / 2;
}

}  // namespace
}  // namespace shading

ShadedDifference shaded_difference(const std::string& before_path, const std::string& after_path,
                                   std::size_t places) {
  using namespace shading;
  const GltfScene before = read_gltf(before_path, {}), after = read_gltf(after_path, {});
  REQUIRE(before.uses.size() == after.uses.size());
  ReadPictures old_pictures(before), new_pictures(after);
  Samplers old_nearest(old_pictures, true), new_nearest(new_pictures, true),
      old_bilinear(old_pictures, false), new_bilinear(new_pictures, false);
  double all = 0;
  for (const GltfUse& use : before.uses)
    if (use.same_uv_as < 0)
      for (const auto& uv : use.uv[0]) all += area(uv);
  ShadedDifference out;
  std::mt19937 random(1);
  const auto fraction = [&] { return static_cast<double>(random() >> 8) / 16777216.0; };
  for (std::size_t u = 0; u < before.uses.size(); ++u) {
    const GltfUse &from = before.uses[u], &to = after.uses[u];
    const GltfMaterial& m = before.materials[static_cast<std::size_t>(from.material)];
    const GltfMaterial& p = after.materials[static_cast<std::size_t>(to.material)];
    if (from.same_uv_as >= 0 || leading_texture(m) == nullptr) continue;
    const auto& uvs = from.uv[leading_texture(m)->uv_set];
    REQUIRE(to.world_area.size() == from.world_area.size());
    // As many places on each triangle as its share of the area asks for; less than one by chance.
    for (std::size_t t = 0; t < uvs.size(); ++t) {
      const double wanted = static_cast<double>(places) * area(uvs[t]) / all + fraction();
      for (int k = 0; k < static_cast<int>(wanted); ++k) {
        double a = fraction(), b = fraction();
        if (a + b > 1) a = 1 - a, b = 1 - b;
        const Place old_uv = mixed(from, t, a, b), new_uv = mixed(to, t, a, b);
        ++out.places;
        out.bilinear = std::max(out.bilinear, largest_difference(surface_at(m, old_bilinear, old_uv),
                                                                 surface_at(p, new_bilinear, new_uv)));
        if (old_nearest.is_near_edge(m.base_color_texture, old_uv) ||
            old_nearest.is_near_edge(m.metallic_roughness_texture, old_uv) ||
            old_nearest.is_near_edge(m.normal_texture, old_uv))
          continue;
        out.nearest = std::max(out.nearest, largest_difference(surface_at(m, old_nearest, old_uv),
                                                               surface_at(p, new_nearest, new_uv)));
      }
    }
  }
  return out;
}

}  // namespace etak::test
