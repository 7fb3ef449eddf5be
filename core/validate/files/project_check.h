// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/atlas/sources/sources.h"
#include "core/judge/finding.h"
#include "core/judge/settings.h"
#include "core/project/project.h"
#include "core/project/project_pictures.h"

namespace etak {

// Checks materials of a project by the rules for files: a part of validate() (core/validate/validate.h).

/// What materials of a project are checked with.
///   library       with the project's own spectra (library_of)
///   most_texels   larger pictures are not checked, which is a finding; 0: no limit
///   kept          where pictures of an earlier check are; null: they are read
struct MaterialCheck {
  const MaterialLibrary& library;
  const PictureDoor& door;
  const Settings& settings;
  std::size_t most_texels = 0;
  unsigned threads = 1;
  KeptPictures* kept = nullptr;
};

/// Checks one material: its pictures or colours, and the record that its F0 comes from. Errors of the
/// material are findings, not exceptions. Findings have its name as material.
CheckedFile check_material(const ProjectMaterial& material, const MaterialCheck& by);

/// Which field of a material a rule is about; none: the measured record, a file, or the rules themselves.
std::optional<Channel> field_of(std::string_view rule);

}  // namespace etak
