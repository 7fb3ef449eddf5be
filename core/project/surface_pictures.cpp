// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/atlas/sources/pictures.h"
#include "core/atlas/texels/page_pixels.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/linear_tables.h"
#include "core/image/load.h"
#include "core/image/mean_squares.h"
#include "core/pack/blocks/compress_page.h"
#include "core/project/project_pictures.h"
#include "core/render/surface_textures.h"

namespace etak {
namespace {

// The texels of both textures, one after the other, as eight numbers in linear light.
class LinearRow {
 public:
  explicit LinearRow(int width) : row_(8 * static_cast<std::size_t>(width)) {}
  const float* of(const std::uint8_t* a, const std::uint8_t* b) {
    const auto& linear = linear_tables().srgb;
    for (std::size_t to = 0; to < row_.size(); a += 4, b += 4)
      for (const std::uint8_t* texel : {a, b}) {
        for (std::size_t c = 0; c < 3; ++c) row_[to++] = linear[texel[c]];
        row_[to++] = static_cast<float>(texel[3]) / 255;
      }
    return row_.data();
  }

 private:
  std::vector<float> row_;
};

// One of the two textures of such texels.
Image half_of(const Image& both, std::size_t first) {
  Image out(both.width, both.height, 4);
  for (std::size_t i = 0; i < out.pixel_count(); ++i)
    std::copy_n(both.values.data() + 8 * i + first, 4, out.values.data() + 4 * i);
  return out;
}

void set_packed(const ProjectMaterial& material, int width, int height, int most_side,
                const std::function<RowReader(int first)>& open, SurfaceTextures& out) {
  out.has.diffuse = is_read(material, Channel::diffuse);
  out.has.opacity = is_read(material, Channel::alpha);
  out.has.f0 = is_read(material, Channel::specular);
  out.has.gloss = is_read(material, Channel::gloss);
  out.body = out.gloss = Image(1, 1, 4);
  if (!out.has.values()) return;
  const Image both = mean_squares(width, height, 8, most_side, open);
  if (out.has.diffuse || out.has.opacity) out.body = half_of(both, 0);
  if (out.has.f0 || out.has.gloss) out.gloss = half_of(both, 4);
}

std::optional<Image> light_picture(const ProjectMaterial& material, Channel channel,
                                   const PictureReading& reading, int most_side) {
  const std::optional<ImageSource>& source = material.texture(channel);
  if (!source) return std::nullopt;
  return channel == Channel::emission ? emission_floats(*source, material.name, reading, most_side)
                                      : occlusion_floats(*source, material.name, reading, most_side);
}

// A map of two channels, as BC5 has them: blue is 0 all over, and z follows from the other two.
template <class Code>
bool is_of_two(const Pixels<Code>& codes) {
  for (std::size_t i = 2; i < codes.values.size(); i += static_cast<std::size_t>(codes.channels))
    if (codes.values[i] != 0) return false;
  return true;
}

template <class Code>
Image normals_of(const Pixels<Code>& codes, bool green_down, int most_side) {
  constexpr std::size_t all = std::size_t{std::numeric_limits<Code>::max()} + 1;
  std::vector<float> component(all);
  for (std::size_t i = 0; i < all; ++i)
    component[i] = static_cast<float>(2 * static_cast<double>(i) / double{all - 1} - 1);
  const bool of_two = is_of_two(codes);
  const auto width = static_cast<std::size_t>(codes.width), step = static_cast<std::size_t>(codes.channels);
  return mean_squares(codes.width, codes.height, 4, most_side, [&](int) {
    return [&, row = std::vector<float>(4 * width, 1)](int y) mutable {
      const Code* from = codes.at(0, y).data();
      for (float* to = row.data(); to != row.data() + row.size(); to += 4, from += step) {
        for (std::size_t c = 0; c < 3; ++c) to[c] = component[from[c]];
        if (of_two) to[2] = std::sqrt(std::max(0.0F, 1 - to[0] * to[0] - to[1] * to[1]));
        if (green_down) to[1] = -to[1];
      }
      return row.data();
    };
  });
}

Image normal_picture(const ProjectMaterial& material, const PictureReading& reading, int most_side) {
  const auto& source = material.texture(Channel::normal);
  if (!source) return {};
  const auto known = reading.decoded.find(source->path);
  const auto picture = known != reading.decoded.end()
                           ? known->second.picture
                           : std::make_shared<const Picture>(load_picture(source->path, reading.door));
  if (picture->header.channels < 3)
    throw Error::at(source->path, std::to_string(picture->header.channels) + " channels",
                    "a normal map of three");
  if (const auto* wide = std::get_if<Image16>(&picture->pixels))
    return normals_of(*wide, material.green_down, most_side);
  if (const auto* codes = std::get_if<Image8>(&picture->pixels))
    return normals_of(*codes, material.green_down, most_side);
  return normals_of(codes_of(Picture(*picture), false), material.green_down, most_side);
}

// Sets the textures that are not packed.
void set_others(const ProjectMaterial& material, const PictureReading& reading, int most_side,
                SurfaceTextures& out) {
  const auto emission = light_picture(material, Channel::emission, reading, most_side),
             occlusion = light_picture(material, Channel::occlusion, reading, most_side);
  out.has.emission = emission.has_value();
  out.has.occlusion = occlusion.has_value();
  if (emission || occlusion)
    out.emission = emission_texture(emission ? &*emission : nullptr, occlusion ? &*occlusion : nullptr);
  out.normal = normal_picture(material, reading, most_side);
  out.has.normal = out.normal.width > 0;
}

// A texture as blocks hold it: it is compressed as a page of an atlas that holds nothing else.
//   to   gets what became of it
Image in_blocks(const Image& exact, Texture texture, const ProjectMaterial& of, int level,
                std::vector<BlockLevel>& to) {
  PackDecision decision;
  decision.regions.emplace_back().box = {0, 0, exact.width, exact.height};
  decision.plan.places.emplace_back();
  decision.plan.pages.push_back({exact.width, exact.height});
  std::vector<PackInput> inputs(1);
  inputs[0].alpha_mode = of.alpha_mode;
  inputs[0].alpha_cutoff = of.alpha_cutoff;
  PagePixels pixels;
  pixels.start(decision.plan.pages[0], 1);
  std::uint8_t* const codes = pixels.view(texture).data;
  const LinearTables& tables = linear_tables();
  for (std::size_t i = 0; i < exact.values.size(); ++i)
    codes[i] = i % 4 < 3 ? tables.srgb_code(exact.values[i]) : to_code(exact.values[i]);
  CompressOptions how = compress_word("bc7");
  how.once = true;
  CompressedTexture made =
      compress_texture({decision, inputs, 0, texture, pixels, {}, GlossForm::schueler, how, {}, 1});
  to.push_back(std::move(made.report[0]));
  to.back().level = level;
  const Image8 held = level_of(made.blocks->levels[0], how.format, exact.width, exact.height);
  Image out(exact.width, exact.height, 4);
  for (std::size_t i = 0; i < out.values.size(); ++i)
    out.values[i] = i % 4 < 3 ? tables.srgb[held.values[i]] : static_cast<float>(held.values[i]) / 255;
  return out;
}

std::shared_ptr<const SurfaceTextures> in_blocks(const SurfaceTextures& exact, const ProjectMaterial& of,
                                                 int level, std::vector<BlockLevel>& to) {
  auto out = std::make_shared<SurfaceTextures>(exact);
  if (exact.has.diffuse || exact.has.opacity)
    out->body = in_blocks(exact.body, Texture::diffuse_alpha, of, level, to);
  if (exact.has.f0 || exact.has.gloss)
    out->gloss = in_blocks(exact.gloss, Texture::specular_gloss, of, level, to);
  if (exact.half) out->half = in_blocks(*exact.half, of, level + 1, to);
  return out;
}

}  // namespace

SurfaceInBlocks surface_in_blocks(const SurfaceTextures& textures, const ProjectMaterial& material) {
  SurfaceInBlocks out;
  out.textures = in_blocks(textures, material, 0, out.levels);
  return out;
}

std::optional<Image> light_picture(const ProjectMaterial& material, Channel channel,
                                   const PictureDoor& door) {
  return light_picture(material, channel, {std::nullopt, door, {}, {}}, max_image_side);
}

Image normal_picture(const ProjectMaterial& material, const PictureDoor& door, int most_side) {
  return normal_picture(material, {std::nullopt, door, {}, {}}, most_side);
}

SurfaceTextures surface_textures(const ProjectMaterial& material, const MaterialPair& pair,
                                 const PictureDoor& door, int most_side) {
  SurfaceTextures out;
  const Image8 &a = pair.diffuse_alpha, &b = pair.specular_gloss;
  const auto open = [&](int) {
    return
        [&, row = LinearRow(a.width)](int y) mutable { return row.of(a.at(0, y).data(), b.at(0, y).data()); };
  };
  set_packed(material, a.width, a.height, most_side, open, out);
  set_others(material, {std::nullopt, door, {}, {}}, most_side, out);
  return out;
}

SurfacePicturesRead read_surface_textures(const ProjectMaterial& material, const MaterialLibrary& library,
                                          const PictureDoor& door, int most_side, std::size_t most_texels,
                                          const DecodedFiles& known) {
  PictureReading reading{std::nullopt, door, {}, {}};
  const PackInput input = input_of(material, library, reading, most_texels);
  std::vector<std::string> files = input.files;
  for (const Channel channel : {Channel::emission, Channel::occlusion, Channel::normal})
    if (const auto& source = material.texture(channel)) files.push_back(source->path);
  reading.decoded = decoded_files(std::move(files), door, known);
  SurfacePicturesRead out;
  const PairPlanes planes = planes_of(input);
  const auto open = [&](int first) {
    return [rows = std::make_shared<PairRows>(planes, first), row = LinearRow(planes.width),
            a = std::vector<std::uint8_t>(4 * static_cast<std::size_t>(planes.width)),
            b = std::vector<std::uint8_t>(4 * static_cast<std::size_t>(planes.width))](int) mutable {
      rows->read(a.data(), b.data());
      return row.of(a.data(), b.data());
    };
  };
  set_packed(material, planes.width, planes.height, most_side, open, out.textures);
  set_others(material, reading, most_side, out.textures);
  add_halves(out.textures);
  const Image& alone = out.textures.emission.width > 0 ? out.textures.emission : out.textures.normal;
  const bool packed = has_packed_textures(material);
  out.width = packed ? planes.width : alone.width;
  out.height = packed ? planes.height : alone.height;
  return out;
}

}  // namespace etak
