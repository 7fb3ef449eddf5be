// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/atlas/pack/pack.h"
#include "core/project/project.h"

namespace etak {

// Projects as what the packer takes (target etak::project_files).

/// What pack() takes of a project. How the project is looked at changes no texel and is no part of it.
PackManifest packed_manifest(const Project& project, const MaterialLibrary& library);

/// For PackOptions::other_manifest: takes project files.
///   library   must outlive what is returned
std::function<std::optional<PackManifest>(const std::string& text, const std::string& file)> project_reader(
    const MaterialLibrary& library);

}  // namespace etak
