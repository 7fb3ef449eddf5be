// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/image/picture.h"
#include "core/project/project.h"

namespace etak {

// Materials of a project as files of other programs, with their textures (target etak::project_files).

enum class ExportForm { material_x, gltf, glb };

/// Writes materials into one file. Textures keep the size of the material's largest picture and have 8 bits a
/// channel. Where a texture gives the diffuse colour or F0, the material is written as a dielectric, because
/// a metal has no diffuse colour.
///   glTF        the document holds the pictures. F0 is the specular colour under an index whose own F0 is 1,
///               so that nothing of it is lost; the diffuse colour is divided by 1 - max F0, which the shader
///               multiplies by
///   MaterialX   the pictures are PNG files beside `path`, named after it and named relative to it in the
///               document. F0 of a texture becomes base_color and base_metalness (metal_rough_of() of
///               core/scene/material_texels.h), which is not exact; the largest error is told. The mode mask
///               becomes opacities of 0 and 1
///   materials   one or more
///   path        is replaced. A picture is never: it takes a number behind its name where another file with
///               other bytes has that
///   returns     a list of what the file cannot hold for each material. Throws Error, and leaves `path` as it
///               was, for pictures that cannot be read or written and as material_x() and gltf_document() do
std::vector<Changes> export_materials(std::span<const ProjectMaterial> materials,
                                      const MaterialLibrary& library, ExportForm form, Fit fit,
                                      const PictureDoor& door, const std::string& path);

}  // namespace etak
