// SPDX-License-Identifier: Apache-2.0
#include "core/project/project_pictures.h"

#include <algorithm>
#include <span>
#include <system_error>

#include "core/atlas/sources/pictures.h"
#include "core/base/error.h"
#include "core/base/system.h"
#include "core/image/linear_tables.h"

namespace etak {
namespace {

constexpr int plain_side = 16;

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

bool is_read(const ProjectMaterial& m, Channel channel) {
  return gives(m, channel) && (channel != Channel::alpha || m.alpha_mode != AlphaMode::opaque);
}

bool has_textures(const ProjectMaterial& material) {
  return material.textures != ProjectMaterial{}.textures;
}

bool has_packed_textures(const ProjectMaterial& material) {
  return std::ranges::any_of(all_channels, [&](Channel channel) {
    return channel != Channel::emission && channel != Channel::occlusion && channel != Channel::normal &&
           material.texture(channel);
  });
}

PackInput input_of(const ProjectMaterial& material, const MaterialLibrary& library,
                   const PictureReading& reading, std::size_t most_texels) {
  Project one;
  one.materials = {material};
  one.materials[0].texture(Channel::normal).reset();  // may be of another size; the pair holds none
  std::vector<std::string> remarks;
  const AtlasManifest manifest = manifest_of(one, library, remarks);
  PackInput input = std::move(resolve_manifest(manifest, library, reading).materials.front());
  const auto texels = static_cast<std::size_t>(input.width) * static_cast<std::size_t>(input.height);
  if (most_texels != 0 && texels > most_texels)
    throw Error::at(
        material.name,
        "its pictures have " + std::to_string(input.width) + " x " + std::to_string(input.height) + " texels",
        "at most " + std::to_string(most_texels) + " for this");
  return input;
}

MaterialPair pictures_of(const ProjectMaterial& material, const MaterialLibrary& library,
                         const PictureDoor& door, std::size_t most_texels) {
  const PictureReading reading{std::nullopt, door, {}, {}};
  std::vector<std::string> remarks;
  MaterialPair pair = load_pair(input_of(material, library, reading, most_texels), remarks);
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

MapEvidence KeptPictures::normals(const ProjectMaterial& material, const std::function<MapEvidence()>& read) {
  const std::lock_guard lock(guard_);
  ProjectMaterial of;
  of.texture(Channel::normal) = material.texture(Channel::normal);
  const PicturesKey key(of);
  if (!normals_ || normals_->first != key) normals_.emplace(key, read());
  return normals_->second;
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
        out.at(x, y)[c] = is_color(channel)            ? linear_tables().srgb_code(in[c])
                          : channel == Channel::normal ? to_code(0.5F * in[c] + 0.5F)
                                                       : to_code(in[3]);
    }
  return out;
}

}  // namespace etak
