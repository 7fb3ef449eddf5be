// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "app/cli/arguments.h"
#include "core/color/gloss.h"

namespace etak::cli {

/// The roughness of a surface as given on the line: --gloss or --roughness.
struct RoughnessArguments {
  std::optional<double> gloss, roughness;
};

/// Adds --gloss and --roughness.
///   whose   the object of the help's texts: "of the surface"
void add_roughness_options(Command verb, RoughnessArguments& arguments, const char* whose);

/// The gloss of the option that was given. None where neither was: the default of the material's class is
/// then meant. Throws Error where both are given and for values outside [0, 1].
std::optional<Gloss> given_gloss(const RoughnessArguments& arguments);

}  // namespace etak::cli
