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

/// Repairs what can be repaired of a material: its diffuse colour and F0 as they are drawn, 8 bits a channel. A number
/// that changes is set; of a picture a repaired one is written, and the material then reads that, as diffuse colour and
/// F0 where it had a base colour. A measured record whose F0 changes is let go.
///   work     an empty folder for what is needed meanwhile
///   folder   where repaired pictures are written: NAME_diffuse_fixed.png, NAME_specular_fixed.png; a number is put
///            behind a name that is taken
/// Throws Error for pictures that cannot be read or written.
RepairedMaterial repair_material(const ProjectMaterial& material, const MaterialLibrary& library,
                                 const Settings& settings, const PictureDoor& door, const std::string& work,
                                 const std::string& folder);

}  // namespace etak
