// SPDX-License-Identifier: Apache-2.0
#include "core/project/project_pack.h"

namespace etak {

PackManifest packed_manifest(const Project& project, const MaterialLibrary& library) {
  PackManifest out;
  out.manifest = manifest_of(project, library, out.remarks);
  Project materials = project;
  materials.view = {};
  out.settings = format_project(materials, "");
  return out;
}

std::function<std::optional<PackManifest>(const std::string& text, const std::string& file)> project_reader(
    const MaterialLibrary& library) {
  return [&library](const std::string& text, const std::string& file) -> std::optional<PackManifest> {
    if (!is_project(text)) return std::nullopt;
    return packed_manifest(parse_project(text, file), library);
  };
}

}  // namespace etak
