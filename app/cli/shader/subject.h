// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/atlas/layout_shader.h"
#include "core/atlas/variant.h"

namespace etak::cli {

// A material of a file in place of the one that `etak shader` is given on the line.

/// The material of the layout that --layout and --material name; `name` may be empty where there is one
/// alone. Throws Error.
LayoutShader shader_of_layout(const std::string& layout_file, const std::string& name);

/// The material of what `etak choose` found that --choice and --material name, likewise.
MaterialVariant variant_of_choice(const std::string& choice_file, const std::string& name);

/// The same all over the material, as `etak shader` takes it: "f0=0.04", "gloss=0.5", ...
std::vector<std::string> subject_of(const LayoutShader& shader);
std::vector<std::string> subject_of(const MaterialVariant& variant);

}  // namespace etak::cli
