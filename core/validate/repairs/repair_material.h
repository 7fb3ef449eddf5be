// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/image/picture.h"
#include "core/judge/settings.h"
#include "core/project/project.h"

namespace etak {

/// A material of a project after the repairs of `etak validate --fix`.
///   done   what each repair did: "ETK108: made diffuse black under metal"
///   left   why something was left, by rule, likewise
struct RepairedMaterial {
  ProjectMaterial material;
  std::vector<std::string> done, left;
};

/// Repairs what can be repaired of a material. A number that changes is set; of a picture a repaired copy is written, which
/// has the channels and the bits of its file, and the material then reads that: of the normal map, held against the
/// convention that the material says; of base colour and metalness, else of diffuse colour and F0 as they are drawn, which
/// then stand in the place of a base colour. A measured record whose F0 changes is let go.
///   work     an empty folder for what is needed meanwhile
///   folder   where repaired pictures are written: NAME_diffuse_fixed.png, NAME_normal_fixed.png and so on; a number is
///            put behind a name that is taken
/// Throws Error for pictures that cannot be read or written.
RepairedMaterial repair_material(const ProjectMaterial& material, const MaterialLibrary& library,
                                 const Settings& settings, const PictureDoor& door, const std::string& work,
                                 const std::string& folder);

}  // namespace etak
