// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/atlas/sources/masked.h"
#include "core/project/project.h"

namespace etak {

// One material of several of a project by a mask (target etak::project_files): what `etak pack` makes of a manifest
// with a mask.

/// What a mask seems to hold.
///   colors   it has ID colours, else greys
///   codes    of its flat parts, two to four where there are so many, at least 16 codes apart; greys from dark to bright,
///            ID colours from frequent to rare. A mask of less than two flat greys is meant from black to white
struct MaskSurvey {
  int width = 0, height = 0;
  bool colors = false;
  std::vector<MaskCode> codes;
};
/// Throws Error for a picture that cannot be read.
MaskSurvey survey_mask(const std::string& path, const PictureDoor& door);

/// A material that is to be made.
///   parts   the codes of the mask with names of materials of the project
struct MaskedMaterial {
  struct Part {
    MaskCode code{};
    std::string material;
  };
  std::string name, mask;
  bool colors = false;
  std::vector<Part> parts;
};

/// The manifest of the material: measured F0 by the name of its record where that is one of etak's library, all else as
/// numbers. Throws Error for materials that are not there, have textures or layers, and for two codes that are too near.
AtlasManifest manifest_of(const MaskedMaterial& masked, const Project& project,
                          const MaterialLibrary& library);

/// The texels of such a manifest, as they would be packed. Throws Error as pack() does.
MaterialPair masked_pair(const AtlasManifest& manifest, const MaterialLibrary& library,
                         const PictureDoor& door);

/// Names of the files of write_masked() that are in the folder already.
std::vector<std::string> masked_files_in(const std::string& folder, const MaskedMaterial& masked);

/// Writes NAME.mask.json, which is the manifest, and beside it the textures that `etak pack` writes by it, byte for byte.
///   overwrite   existing files are replaced, else they are an Error
///   remarks     gets what was changed
/// Returns the material that reads F0, diffuse colour and gloss from these files.
ProjectMaterial write_masked(const MaskedMaterial& masked, const Project& project,
                             const MaterialLibrary& library, const PictureDoor& door,
                             const std::string& folder, bool overwrite, std::vector<std::string>& remarks);

}  // namespace etak
