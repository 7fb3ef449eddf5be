// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/atlas/layout_shader.h"
#include "core/atlas/variant.h"

namespace etak::cli {

// Materials that `etak shader` takes from a file instead of from the line.

/// The material of --material in the layout of --layout. `name` may be empty where the layout has only one
/// material. Throws Error.
LayoutShader shader_of_layout(const std::string& layout_file, const std::string& name);

/// The material of --material in the result of `etak choose` that --choice names. `name` may be empty where
/// the result has only one material. Throws Error.
MaterialVariant variant_of_choice(const std::string& choice_file, const std::string& name);

/// The values that are the same in all texels of a material, in the form that the line has: "f0=0.04",
/// "gloss=0.5", ...
std::vector<std::string> subject_of(const LayoutShader& shader);
std::vector<std::string> subject_of(const MaterialVariant& variant);

}  // namespace etak::cli
