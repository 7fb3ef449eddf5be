// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/atlas/manifest.h"
#include "core/atlas/sources/sources.h"
#include "core/atlas/variant.h"

namespace etak {

// What `etak choose` found, applied to what is packed.

/// Library materials get their F0 by the chosen integration.
///   variants   may be null
AtlasManifest with_methods(AtlasManifest manifest, const ShadingVariants* variants);

/// Textures that differ from their mean by less than the budget become that mean (unless `keep_textures`);
/// all of it becomes part of the settings. Materials that were not chosen for stay as they are, with a
/// remark. Throws Error where none was.
void apply_variants(const ShadingVariants& variants, bool keep_textures, const std::string& input,
                    PackInputs& inputs);

/// Whether some material's textures are read with mips; one that was not chosen for counts.
bool mips_are_read(const ShadingVariants& variants, const PackInputs& inputs);

}  // namespace etak
