// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/material/library.h"
#include "core/pack/pack.h"
#include "core/study/choose/choose.h"

namespace etak {

/// Whether `etak choose` takes the path as a scene: a glTF file, a pack manifest, a folder of pictures, or
/// input from a pipe.
bool names_scene(const std::string& path);

/// The materials that a scene reaches, as `etak pack` reads them. Of textures the part in use is taken, and
/// of larger parts the middle 2048 x 2048 texels. Where F0 is that of a material of the library, the subject
/// has its spectrum. Throws Error.
///   remarks   gets what had to be changed, and which textures were judged in part only
std::vector<ChooseSubject> scene_subjects(const std::string& path, const PackOptions& options,
                                          const MaterialLibrary& library, std::vector<std::string>& remarks);

}  // namespace etak
