// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "core/atlas/sources/sources.h"
#include "core/project/project.h"
#include "core/render/scene.h"

namespace etak {

// A project's material as pictures (target etak::project_files).

bool has_textures(const ProjectMaterial& material);

/// Both textures of a material, as they would be packed: 16 x 16 of one colour where it has no pictures.
/// Throws Error.
///   most_texels   refuses pictures of more; 0: any
MaterialPair pictures_of(const ProjectMaterial& material, const MaterialLibrary& library,
                         const PictureDoor& door, std::size_t most_texels = 0);

/// The pair in linear light for a renderer, made smaller (by means over areas) to `most_side` at most.
SurfaceTextures surface_textures(const MaterialPair& pair, int most_side);

/// One channel of a pair as grey or RGB codes for looking at, made smaller to `most_side` at most.
Image8 channel_picture(const MaterialPair& pair, Channel channel, int most_side);

}  // namespace etak
