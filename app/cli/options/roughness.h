// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "app/cli/arguments.h"
#include "core/color/gloss.h"

namespace etak::cli {

/// How rough a surface is, as typed: --gloss or --roughness.
struct RoughnessArguments {
  std::optional<double> gloss, roughness;
};

///   whose   "of the surface": what the options say it of
void add_roughness_options(Command verb, RoughnessArguments& arguments, const char* whose);

/// What was typed; none: neither, and the default of the material's class is meant. Throws Error for both and
/// for values outside [0, 1].
std::optional<Gloss> given_gloss(const RoughnessArguments& arguments);

}  // namespace etak::cli
