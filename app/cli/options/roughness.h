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

/// given_gloss() of core/color/gloss.h.
inline std::optional<Gloss> given_gloss(const RoughnessArguments& arguments) {
  return etak::given_gloss(arguments.gloss, arguments.roughness);
}

}  // namespace etak::cli
