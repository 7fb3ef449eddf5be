// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/atlas/pack/pack.h"
#include "core/material/library.h"
#include "core/study/choose/choose.h"

namespace etak {

/// Whether `etak choose` takes the text as a scene: a glTF file, a pack manifest or a folder of pictures.
bool names_scene(const std::string& path);

/// The materials that a scene reaches, as `etak pack` reads them; of textures the texels in use, of large
/// ones the middle 2048 x 2048. Where F0 is a library material's, its spectrum is known. Throws Error.
///   remarks   what had to be changed or was looked at in part
std::vector<ChooseSubject> scene_subjects(const std::string& path, const PackOptions& options,
                                          const MaterialLibrary& library, std::vector<std::string>& remarks);

}  // namespace etak
