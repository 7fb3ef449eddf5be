// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/project/project.h"
#include "core/render/scene.h"

namespace etak {

/// A command that draws a material as a project shows it.
///   left_out   what no option says: pictures, lights of one's own, a display
struct CommandLine {
  std::string text;
  std::vector<std::string> left_out;
};

///   engine   of --as; empty: the material's own models
CommandLine render_command(const Project& project, const ProjectMaterial& material, const View& camera,
                           const std::string& engine = {});

}  // namespace etak
