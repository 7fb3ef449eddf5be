// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "core/atlas/sources/sources.h"
#include "core/project/project.h"
#include "core/render/scene.h"

namespace etak {

// The materials of a project as pictures (target etak::project_files).

/// Whether some channel of the material has a texture.
bool has_textures(const ProjectMaterial& material);

/// Both textures of a material, as they would be packed; without pictures 16 x 16 texels of one colour.
/// Throws Error for pictures that cannot be read or are too large.
///   most_texels   larger pictures are refused; 0: no limit
MaterialPair pictures_of(const ProjectMaterial& material, const MaterialLibrary& library,
                         const PictureDoor& door, std::size_t most_texels = 0);

/// The pair in linear light for a renderer, made smaller by means over areas until no side is above
/// `most_side` texels.
SurfaceTextures surface_textures(const MaterialPair& pair, int most_side);

/// The same textures with other numbers: channels that have no picture are those of the material as it is now.
/// No picture is read.
///   read   surface_textures() of the material with the same pictures, alpha mode and cutoff
SurfaceTextures with_numbers_of(const ProjectMaterial& material, const MaterialLibrary& library,
                                const SurfaceTextures& read);

/// One channel as RGB codes to be shown (gloss and alpha as greys).
Image8 channel_picture(const SurfaceTextures& textures, Channel channel);

}  // namespace etak
