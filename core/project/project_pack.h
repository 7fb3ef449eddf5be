// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/pack/pack.h"
#include "core/project/project.h"

namespace etak {

// Projects as input of the packer (target etak::project_files).

/// The input of pack() for a project. The view of the project changes no texel and is left out.
PackManifest packed_manifest(const Project& project, const MaterialLibrary& library);

/// The reader of project files for PackOptions::other_manifest. It returns nullopt for a text that is no
/// project, and throws Error for a broken one.
///   library   must outlive the reader
std::function<std::optional<PackManifest>(const std::string& text, const std::string& file)> project_reader(
    const MaterialLibrary& library);

}  // namespace etak
