// SPDX-License-Identifier: Apache-2.0
#include "core/project/project_pictures.h"

#include <algorithm>
#include <array>

#include "core/atlas/sources/pictures.h"
#include "core/base/error.h"
#include "core/color/srgb.h"
#include "core/image/linear_tables.h"

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

// Sets the components of all texels to those of the first texel of `from`.
void fill_channel(Image& map, const Image& from, std::size_t first, std::size_t last) {
  const auto value = from.at(0, 0);
  for (std::size_t i = 0; i < map.pixel_count(); ++i)
    for (std::size_t c = first; c < last; ++c) map.values[4 * i + c] = value[c];
}

}  // namespace

bool has_textures(const ProjectMaterial& material) {
  return std::any_of(material.textures.begin(), material.textures.end(),
                     [](const auto& texture) { return texture.has_value(); });
}

MaterialPair pictures_of(const ProjectMaterial& material, const MaterialLibrary& library,
                         const PictureDoor& door, std::size_t most_texels) {
  Project one;
  one.materials = {material};
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
  if (has_textures(material)) return pair;
  // Rules that look for flat areas need more than a single texel.
  const auto spread = [](const Image8& texel) {
    Image8 out(plain_side, plain_side, 4);
    for (int y = 0; y < plain_side; ++y)
      for (int x = 0; x < plain_side; ++x) std::copy_n(texel.at(0, 0).data(), 4, out.at(x, y).data());
    return out;
  };
  return {spread(pair.diffuse_alpha), spread(pair.specular_gloss)};
}

SurfaceTextures surface_textures(const MaterialPair& pair, int most_side) {
  return {linear_small(pair.diffuse_alpha, most_side), linear_small(pair.specular_gloss, most_side)};
}

SurfaceTextures with_numbers_of(const ProjectMaterial& material, const MaterialLibrary& library,
                                const SurfaceTextures& read) {
  ProjectMaterial plain = material;
  plain.textures = {};
  const PictureDoor no_pictures;
  const SurfaceTextures numbers = surface_textures(pictures_of(plain, library, no_pictures), plain_side);
  SurfaceTextures out = read;
  if (!material.texture(Channel::diffuse)) fill_channel(out.body, numbers.body, 0, 3);
  if (!material.texture(Channel::alpha)) fill_channel(out.body, numbers.body, 3, 4);
  if (!material.texture(Channel::specular)) fill_channel(out.gloss, numbers.gloss, 0, 3);
  if (!material.texture(Channel::gloss)) fill_channel(out.gloss, numbers.gloss, 3, 4);
  return out;
}

Image8 channel_picture(const SurfaceTextures& textures, Channel channel) {
  const bool color = channel == Channel::diffuse || channel == Channel::specular;
  const Image& from =
      channel == Channel::diffuse || channel == Channel::alpha ? textures.body : textures.gloss;
  Image8 out(from.width, from.height, 3);
  for (int y = 0; y < from.height; ++y)
    for (int x = 0; x < from.width; ++x) {
      const auto in = from.at(x, y);
      for (std::size_t c = 0; c < 3; ++c)
        out.at(x, y)[c] = color ? srgb_u8(static_cast<double>(in[c])) : to_code(in[3]);
    }
  return out;
}

}  // namespace etak
