// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/atlas/manifest.h"
#include "core/atlas/sources/sources.h"
#include "core/atlas/variant.h"

namespace etak {

// Applies what `etak choose` found to the materials that are packed.

/// Library materials get their F0 by the chosen integration.
///   variants   may be null
AtlasManifest with_methods(AtlasManifest manifest, const ShadingVariants* variants);

/// Textures that differ from their mean by less than the budget become that mean (unless `keep_textures`).
/// The choices become part of inputs.settings. A material without a choice stays as it is, with a remark.
/// Throws Error where no material has a choice.
void apply_variants(const ShadingVariants& variants, bool keep_textures, const std::string& input,
                    PackInputs& inputs);

/// Whether some material's textures are read with mips; a material without a choice counts as such.
bool mips_are_read(const ShadingVariants& variants, const PackInputs& inputs);

}  // namespace etak
