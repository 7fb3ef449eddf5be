// SPDX-License-Identifier: Apache-2.0
#include "core/project/project_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <system_error>

#include "core/atlas/sources/pictures.h"
#include "core/base/error.h"
#include "core/base/system.h"
#include "core/color/srgb.h"
#include "core/image/linear_tables.h"
#include "core/image/load.h"
#include "core/render/surface_textures.h"

namespace etak {
namespace {

constexpr int plain_side = 16;

// The picture in linear light, made smaller by means over squares of texels. The codes are summed directly,
// so that no float picture of the full size is made.
Image linear_small(const Image8& codes, int most_side) {
  const int longest = std::max(codes.width, codes.height);
  const int step = std::max(1, (longest + most_side - 1) / most_side);
  const int width = (codes.width + step - 1) / step, height = (codes.height + step - 1) / step;
  Image out(width, height, 4);
  const auto& linear = linear_tables().srgb;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::array<double, 4> sum{};
      int count = 0;
      for (int v = y * step; v < std::min(codes.height, (y + 1) * step); ++v)
        for (int u = x * step; u < std::min(codes.width, (x + 1) * step); ++u, ++count) {
          const auto texel = codes.at(u, v);
          for (std::size_t c = 0; c < 3; ++c) sum[c] += linear[texel[c]];
          sum[3] += texel[3] / 255.0;
        }
      for (std::size_t c = 0; c < 4; ++c) out.at(x, y)[c] = static_cast<float>(sum[c] / count);
    }
  return out;
}

// Whether texels of a channel come from a picture. The mode opaque does not read the alpha.
bool is_read(const ProjectMaterial& m, Channel channel) {
  return gives(m, channel) && (channel != Channel::alpha || m.alpha_mode != AlphaMode::opaque);
}

// Sets the components of all texels, which have the same value everywhere, to those of `code`.
void fill_channel(Image8& map, std::span<const std::uint8_t> code, std::size_t first, std::size_t last) {
  bool same = true;
  for (std::size_t c = first; c < last; ++c) same = same && map.values[c] == code[c];
  if (same) return;
  for (std::size_t i = 0; i < map.values.size(); i += 4)
    for (std::size_t c = first; c < last; ++c) map.values[i + c] = code[c];
}

// Gives the channels without a picture the numbers that the material has now.
void set_numbers(const ProjectMaterial& material, const MaterialLibrary& library, MaterialPair& pair) {
  ProjectMaterial plain = material;
  plain.textures = {};
  const MaterialPair numbers = pictures_of(plain, library, PictureDoor());
  const auto a = numbers.diffuse_alpha.at(0, 0), b = numbers.specular_gloss.at(0, 0);
  if (!is_read(material, Channel::diffuse)) fill_channel(pair.diffuse_alpha, a, 0, 3);
  if (!is_read(material, Channel::alpha)) fill_channel(pair.diffuse_alpha, a, 3, 4);
  if (!is_read(material, Channel::specular)) fill_channel(pair.specular_gloss, b, 0, 3);
  if (!is_read(material, Channel::gloss)) fill_channel(pair.specular_gloss, b, 3, 4);
}

}  // namespace

bool has_textures(const ProjectMaterial& material) {
  return material.textures != ProjectMaterial{}.textures;
}

bool has_packed_textures(const ProjectMaterial& material) {
  return std::ranges::any_of(all_channels, [&](Channel channel) {
    return channel != Channel::emission && channel != Channel::occlusion && channel != Channel::normal &&
           material.texture(channel);
  });
}

MaterialPair pictures_of(const ProjectMaterial& material, const MaterialLibrary& library,
                         const PictureDoor& door, std::size_t most_texels) {
  Project one;
  one.materials = {material};
  one.materials[0].texture(Channel::normal).reset();  // may be of another size; the pair holds none
  std::vector<std::string> remarks;
  const AtlasManifest manifest = manifest_of(one, library, remarks);
  const PictureReading reading{std::nullopt, door, {}, {}};
  PackInputs inputs = resolve_manifest(manifest, library, reading);
  PackInput& input = inputs.materials.front();
  const auto texels = static_cast<std::size_t>(input.width) * static_cast<std::size_t>(input.height);
  if (most_texels != 0 && texels > most_texels)
    throw Error::at(
        material.name,
        "its pictures have " + std::to_string(input.width) + " x " + std::to_string(input.height) + " texels",
        "at most " + std::to_string(most_texels) + " for this");
  MaterialPair pair = load_pair(input, remarks);
  if (has_packed_textures(material)) return pair;
  // Rules that look for flat areas need more than a single texel.
  const auto spread = [](const Image8& texel) {
    Image8 out(plain_side, plain_side, 4);
    for (int y = 0; y < plain_side; ++y)
      for (int x = 0; x < plain_side; ++x) std::copy_n(texel.at(0, 0).data(), 4, out.at(x, y).data());
    return out;
  };
  return {spread(pair.diffuse_alpha), spread(pair.specular_gloss)};
}

PicturesKey::PicturesKey(const ProjectMaterial& material) {
  files_.textures = material.textures;
  files_.alpha_mode = material.alpha_mode;
  files_.alpha_cutoff = material.alpha_cutoff;
  files_.green_down = material.green_down;
  for (const auto& texture : material.textures) {
    sys::FileInfo info;
    if (texture && sys::file_info(texture->path, info))
      stamps_.push_back({0, 0, info.size, info.written.seconds, info.written.nanoseconds});
    else if (texture)
      stamps_.emplace_back();
  }
}

void KeptPictures::use(const ProjectMaterial& material, const MaterialLibrary& library,
                       const PictureDoor& door, std::size_t most,
                       const std::function<void(MaterialPair&)>& use) {
  const std::lock_guard lock(guard_);
  PicturesKey key(material);
  if (kept_ && kept_->first == key) {
    set_numbers(material, library, kept_->second);
  } else {
    kept_.reset();
    kept_.emplace(std::move(key), pictures_of(material, library, door, most));
  }
  use(kept_->second);
  if (kept_->second.diffuse_alpha.pixel_count() > most_texels) kept_.reset();
}

std::optional<Image> light_picture(const ProjectMaterial& material, Channel channel,
                                   const PictureDoor& door) {
  const std::optional<ImageSource>& source = material.texture(channel);
  if (!source) return std::nullopt;
  return channel == Channel::emission ? emission_floats(*source, material.name, door)
                                      : occlusion_floats(*source, material.name, door);
}

namespace {

// A map of two channels, as BC5 has them: blue is 0 all over, and z follows from the other two.
bool is_of_two(const Image8& codes) {
  for (std::size_t i = 2; i < codes.values.size(); i += static_cast<std::size_t>(codes.channels))
    if (codes.values[i] != 0) return false;
  return true;
}

}  // namespace

Image normal_picture(const ProjectMaterial& material, const PictureDoor& door, int most_side) {
  const auto& source = material.texture(Channel::normal);
  if (!source) return {};
  const Image8 codes = codes_of(load_picture(source->path, door), false);
  if (codes.channels < 3)
    throw Error::at(source->path, std::to_string(codes.channels) + " channels", "a normal map of three");
  const int longest = std::max(codes.width, codes.height);
  const int step = std::max(1, (longest + most_side - 1) / most_side);
  const bool of_two = is_of_two(codes);
  Image out((codes.width + step - 1) / step, (codes.height + step - 1) / step, 4, 1);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      std::array<double, 3> sum{};
      int count = 0;
      for (int v = y * step; v < std::min(codes.height, (y + 1) * step); ++v)
        for (int u = x * step; u < std::min(codes.width, (x + 1) * step); ++u, ++count) {
          std::array<double, 3> normal;
          for (std::size_t c = 0; c < 3; ++c) normal[c] = 2 * codes.at(u, v)[c] / 255.0 - 1;
          if (of_two) normal[2] = std::sqrt(std::max(0.0, 1 - normal[0] * normal[0] - normal[1] * normal[1]));
          for (std::size_t c = 0; c < 3; ++c) sum[c] += normal[c];
        }
      if (material.green_down) sum[1] = -sum[1];
      for (std::size_t c = 0; c < 3; ++c) out.at(x, y)[c] = static_cast<float>(sum[c] / count);
    }
  return out;
}

SurfaceTextures surface_textures(const ProjectMaterial& material, const MaterialPair& pair,
                                 const PictureDoor& door, int most_side) {
  const auto emission = light_picture(material, Channel::emission, door),
             occlusion = light_picture(material, Channel::occlusion, door);
  SurfaceTextures out = *surface_textures(
      {.emission = emission ? &*emission : nullptr, .occlusion = occlusion ? &*occlusion : nullptr},
      most_side);
  out.body = out.gloss = Image(1, 1, 4);
  out.has.diffuse = is_read(material, Channel::diffuse);
  out.has.opacity = is_read(material, Channel::alpha);
  out.has.f0 = is_read(material, Channel::specular);
  out.has.gloss = is_read(material, Channel::gloss);
  out.normal = normal_picture(material, door, most_side);
  out.has.normal = out.normal.width > 0;
  if (out.has.diffuse || out.has.opacity) out.body = linear_small(pair.diffuse_alpha, most_side);
  if (out.has.f0 || out.has.gloss) out.gloss = linear_small(pair.specular_gloss, most_side);
  return out;
}

const Image& channel_image(const SurfaceTextures& textures, Channel channel) {
  switch (channel) {
    case Channel::diffuse:
    case Channel::alpha:
      return textures.body;
    case Channel::specular:
    case Channel::gloss:
      return textures.gloss;
    case Channel::normal:
      return textures.normal;
    default:
      return textures.emission;
  }
}

Image8 channel_picture(const SurfaceTextures& textures, Channel channel) {
  const Image& from = channel_image(textures, channel);
  Image8 out(from.width, from.height, 3);
  for (int y = 0; y < from.height; ++y)
    for (int x = 0; x < from.width; ++x) {
      const auto in = from.at(x, y);
      for (std::size_t c = 0; c < 3; ++c)
        out.at(x, y)[c] = is_color(channel)            ? srgb_u8(static_cast<double>(in[c]))
                          : channel == Channel::normal ? to_code(0.5F * in[c] + 0.5F)
                                                       : to_code(in[3]);
    }
  return out;
}

}  // namespace etak
