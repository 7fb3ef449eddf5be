// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "core/atlas/sources/sources.h"
#include "core/base/files/file_stamp.h"
#include "core/maps/map_evidence.h"
#include "core/pack/blocks/compress_options.h"
#include "core/project/project.h"
#include "core/render/scene.h"

namespace etak {

// The materials of a project as pictures (target etak::project_files).

/// Whether some channel of the material has a texture, and whether one that is packed has.
bool has_textures(const ProjectMaterial& material);
bool has_packed_textures(const ProjectMaterial& material);

/// Whether texels of a channel come from a picture. The mode opaque does not read the alpha.
bool is_read(const ProjectMaterial& material, Channel channel);

/// A material as the packer reads it, without its normal map. Throws Error as pictures_of().
///   reading   must outlive the input
PackInput input_of(const ProjectMaterial& material, const MaterialLibrary& library,
                   const PictureReading& reading, std::size_t most_texels = 0);

/// Both textures of a material, as they would be packed; without pictures of these channels 16 x 16 texels of one colour.
/// Throws Error for pictures that cannot be read or are too large.
///   most_texels   larger pictures are refused; 0: no limit
MaterialPair pictures_of(const ProjectMaterial& material, const MaterialLibrary& library,
                         const PictureDoor& door, std::size_t most_texels = 0);

/// All that decides about the texels that a material has from its pictures: which channels have one and how they
/// are read, and when each file was written last and how large it is. A file that cannot be asked has neither.
class PicturesKey {
 public:
  explicit PicturesKey(const ProjectMaterial& material);
  friend bool operator==(const PicturesKey&, const PicturesKey&) = default;

 private:
  ProjectMaterial files_;
  std::vector<FileStamp> stamps_;  // of the file behind a path, whichever that is
};

/// Keeps the pictures of the material that was asked for last, so that they are not read again while only its
/// numbers change. Any thread may use it.
class KeptPictures {
 public:
  /// Larger pairs are read each time.
  static constexpr std::size_t most_texels = std::size_t{32} << 20;

  /// Calls `use` with the pair that pictures_of() gives of a material with textures. `use` may change texels
  /// of channels that have no texture.
  void use(const ProjectMaterial& material, const MaterialLibrary& library, const PictureDoor& door,
           std::size_t most, const std::function<void(MaterialPair&)>& use);

  /// What `read` tells of the normal map of a material, kept likewise.
  MapEvidence normals(const ProjectMaterial& material, const std::function<MapEvidence()>& read);

 private:
  std::mutex guard_;
  std::optional<std::pair<PicturesKey, MaterialPair>> kept_;
  std::optional<std::pair<PicturesKey, MapEvidence>> normals_;
};

/// A picture of emission or occlusion as emission_floats() and occlusion_floats() give it; none where the channel has
/// no texture. Throws Error as they do.
std::optional<Image> light_picture(const ProjectMaterial& material, Channel channel, const PictureDoor& door);

/// The normal map as components of -1 to 1 in OpenGL's convention, made smaller as below; no texels where there is none.
Image normal_picture(const ProjectMaterial& material, const PictureDoor& door, int most_side);

/// The textures of a material in linear light for a renderer, made smaller by means over areas until no side is
/// above `most_side` texels. Squares of texels become one. They hold the channels that have a picture. Throws Error as light_picture().
///   pair   of pictures_of()
SurfaceTextures surface_textures(const ProjectMaterial& material, const MaterialPair& pair,
                                 const PictureDoor& door, int most_side);

/// The same from the files, each of which is decoded once, several at a time; no pair of the full size is made.
///   known           as of decoded_files()
///   width, height   of the files of packed channels; where there are none, of a texture of the others
struct SurfacePicturesRead {
  SurfaceTextures textures;
  int width = 0, height = 0;
};
SurfacePicturesRead read_surface_textures(const ProjectMaterial& material, const MaterialLibrary& library,
                                          const PictureDoor& door, int most_side, std::size_t most_texels = 0,
                                          const DecodedFiles& known = {});

/// The textures of a material as a GPU samples them in BC7.
///   textures   with the sizes, halves, emission and normal map of the exact ones
///   levels     what became of those with diffuse colour and opacity and of those with F0 and gloss, the largest first. A
///              texture that is one number has none
struct SurfaceInBlocks {
  std::shared_ptr<const SurfaceTextures> textures;
  std::vector<BlockLevel> levels;
};
/// Compresses textures, each half from its own exact texels, as pack() tries first for "bc7" and the usual budget: where all
/// levels are within it, that is what it writes.
///   textures   of read_surface_textures()
SurfaceInBlocks surface_in_blocks(const SurfaceTextures& textures, const ProjectMaterial& material);

/// The texture that holds a channel: a colour in its first three channels, a number in the fourth.
const Image& channel_image(const SurfaceTextures& textures, Channel channel);

/// One channel as RGB codes to be shown (gloss and alpha as greys).
Image8 channel_picture(const SurfaceTextures& textures, Channel channel);

}  // namespace etak
