// SPDX-License-Identifier: Apache-2.0
#include "core/render/surface_textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/color/gloss.h"
#include "core/image/mean_squares.h"
#include "core/math/functions.h"
#include "core/render/camera.h"
#include "core/render/mesh/mesh_shape.h"

namespace etak {
namespace {

constexpr std::array all_textures{&SurfaceTextures::body, &SurfaceTextures::gloss, &SurfaceTextures::emission,
                                  &SurfaceTextures::normal};

void require_channels(const Image& picture, int least, const char* expected) {
  if (picture.channels < least || picture.width < 1 || picture.height < 1)
    throw Error::at("texture", std::to_string(picture.channels) + " channels", expected);
}

// The picture with a fourth channel, 1 where it has none; no texels for null.
Image four_channels(const Image* picture, int side) {
  if (picture == nullptr) return {};
  require_channels(*picture, 3, "three or four");
  const int longer = std::max(picture->width, picture->height);
  const double scale = longer > side ? double(side) / longer : 1;
  const auto scaled = [&](int length) { return std::max(1, static_cast<int>(length * scale)); };
  const Image small =
      scale < 1 ? shrunk(*picture, scaled(picture->width), scaled(picture->height)) : *picture;
  if (small.channels == 4) return small;
  Image out(small.width, small.height, 4, 1);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) std::copy_n(small.at(x, y).data(), 3, out.at(x, y).data());
  return out;
}

}  // namespace

std::shared_ptr<const SurfaceTextures> surface_textures(const SurfacePictures& of, int side) {
  if (side < 1 || side > max_scene_texture)
    throw Error::at("texture", "side of " + std::to_string(side),
                    "1 to " + std::to_string(max_scene_texture));
  const auto fourth = [](const Image* picture) { return picture != nullptr && picture->channels == 4; };
  SurfaceTextures out{four_channels(of.body, side),
                      four_channels(of.gloss, side),
                      {of.body != nullptr, fourth(of.body), of.gloss != nullptr, fourth(of.gloss),
                       of.emission != nullptr, of.occlusion != nullptr}};
  const Image emission = emission_texture(of.emission, of.occlusion);
  if (emission.width > 0) out.emission = four_channels(&emission, side);
  return std::make_shared<const SurfaceTextures>(std::move(out));
}

void add_halves(SurfaceTextures& textures) {
  constexpr int least_side = 4;
  int longest = 0;
  SurfaceTextures half{{}, {}, textures.has};
  for (Image SurfaceTextures::*each : all_textures) {
    const Image& from = textures.*each;
    const int side = std::max(from.width, from.height);
    longest = std::max(longest, side);
    if (side == 0) continue;
    half.*each = mean_squares(from.width, from.height, 4, (side + 1) / 2,
                              [&](int) { return [&](int y) { return from.at(0, y).data(); }; });
  }
  if (longest <= least_side) return;
  add_halves(half);
  textures.half = std::make_shared<const SurfaceTextures>(std::move(half));
}

std::shared_ptr<const SurfaceTextures> textures_for_pixels(const Scene& scene) {
  std::shared_ptr<const SurfaceTextures> out = scene.textures;
  if (!out || !out->half) return out;
  double texels = 0;  // of the largest texture
  for (Image SurfaceTextures::*each : all_textures)
    texels = std::max(texels, static_cast<double>(((*out).*each).pixel_count()));
  // The share of the texture in a square of the side 1 in the middle of the object.
  const double share = scene.mesh                   ? scene.mesh->uv_share()
                       : scene.shape == Shape::quad ? 0.25
                                                    : 1 / (2 * std::numbers::pi * std::numbers::pi);
  double of_pixel =
      std::sqrt(texels * scene.texture_scale[0] * scene.texture_scale[1] * share) * Camera(scene).pixel();
  for (; of_pixel > std::numbers::sqrt2 && out->half; of_pixel /= 2) out = out->half;
  return out;
}

Image emission_texture(const Image* emission, const Image* occlusion) {
  if (emission != nullptr) require_channels(*emission, 3, "three");
  if (occlusion != nullptr) require_channels(*occlusion, 1, "one");
  int width = 0, height = 0;
  for (const Image* each : {emission, occlusion})
    if (each != nullptr) width = std::max(width, each->width), height = std::max(height, each->height);
  Image out(width, height, 4, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double u = (x + 0.5) / width, v = (y + 0.5) / height;
      const auto to = out.at(x, y);
      if (occlusion != nullptr) to[3] = static_cast<float>(texel(*occlusion, u, v)[0]);
      if (emission == nullptr) continue;
      const std::array<double, 4> color = texel(*emission, u, v);
      for (std::size_t c = 0; c < 3; ++c) to[c] = static_cast<float>(color[c]);
    }
  return out;
}

std::vector<std::pair<const char*, const Image*>> samplers_of(const SurfaceTextures& textures) {
  std::vector<std::pair<const char*, const Image*>> out;
  for (const auto& each :
       {std::pair("surface_body", &textures.body), std::pair("surface_gloss", &textures.gloss),
        std::pair("surface_emission", &textures.emission), std::pair("surface_normal", &textures.normal)})
    if (each.second->width > 0) out.emplace_back(each);
  return out;
}

std::array<double, 4> texel(const Image& texture, double u, double v) {
  const auto inside = [](double at, int size) { return std::clamp(at * size - 0.5, 0.0, size - 1.0); };
  const double x = inside(u, texture.width), y = inside(v, texture.height);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, texture.width - 1), y1 = std::min(y0 + 1, texture.height - 1);
  const double fx = x - x0, fy = y - y0;
  const auto a = texture.at(x0, y0), b = texture.at(x1, y0), c = texture.at(x0, y1), d = texture.at(x1, y1);
  std::array<double, 4> out{};
  for (std::size_t i = 0; i < a.size(); ++i)
    out[i] = (double{a[i]} * (1 - fx) + double{b[i]} * fx) * (1 - fy) +
             (double{c[i]} * (1 - fx) + double{d[i]} * fx) * fy;
  return out;
}

std::array<double, 2> texture_place(Shape shape, const Vec3& p) {
  if (shape == Shape::quad) return {0.5 + 0.5 * p[0], 0.5 - 0.5 * p[1]};
  using std::numbers::pi;
  return {0.5 + math::atan2(p[0], p[2]) / (2 * pi), math::atan2(math::hypot(p[0], p[2]), p[1]) / pi};
}

std::array<double, 4> emission_at(const Scene& scene, const std::array<double, 2>& place) {
  const Vec3& own = scene.surface.emission;
  std::array<double, 4> out{own[0], own[1], own[2], scene.surface.occlusion};
  const SurfaceTextures::Quantities has = scene.textured();
  if (!has.emission && !has.occlusion) return out;
  const std::array<double, 4> factors = texel(scene.textures->emission, place[0], place[1]);
  for (std::size_t i = 0; i < 4; ++i)
    if (i < 3 ? has.emission : has.occlusion) out[i] *= factors[i];
  return out;
}

bool follows_texture(const Model& model, const Parameter& parameter) {
  switch (parameter.role) {
    case Role::diffuse:
    case Role::f0:
      return true;
    case Role::gloss:
    case Role::alpha:
    case Role::exponent:
      return !model.derives_from_width();
    default:
      return false;
  }
}

TexturedValues::TexturedValues(const Model& model, std::vector<double> values)
    : model_(model), values_(std::move(values)) {}

const double* TexturedValues::at(const std::array<double, 4>& body, const std::array<double, 4>& gloss) {
  std::size_t at = 0;
  const double exponent = exponent_of_gloss(gloss[3]);
  for (const Parameter& parameter : model_.parameters) {
    const std::size_t count = parameter.color ? 3 : 1;
    const auto held = [&](double value) { return std::clamp(value, parameter.min, parameter.max); };
    if (follows_texture(model_, parameter)) switch (parameter.role) {
        case Role::diffuse:
          for (std::size_t c = 0; c < count; ++c) values_[at + c] = body[c] * body[3];
          break;
        case Role::f0:
          for (std::size_t c = 0; c < count; ++c) values_[at + c] = gloss[c];
          break;
        case Role::gloss:
          values_[at] = held(gloss[3]);
          break;
        case Role::alpha:
          values_[at] = held(alpha_of_exponent(exponent));
          break;
        case Role::exponent:
          values_[at] = held(exponent);
          break;
        default:
          break;
      }
    at += count;
  }
  return values_.data();
}

bool width_follows_texture(const Model& model) {
  return std::ranges::any_of(model.parameters, [&](const Parameter& each) {
    return (each.role == Role::gloss || each.role == Role::alpha || each.role == Role::exponent) &&
           follows_texture(model, each);
  });
}

}  // namespace etak
