// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/atlas/leave_out.h"

namespace etak {

/// What a shader of this material must hold, one define a line of it:
///   ETAK_DIFFUSE_TEXTURE, ETAK_SPECULAR_TEXTURE, ETAK_GLOSS_TEXTURE   fetched; else a uniform
///   ETAK_NO_DIFFUSE                                                   diffuse is black everywhere
///   ETAK_SCALAR_F0                                                    F0 is one grey number: the uniform's,
///   or
///                                                                     with ETAK_SPECULAR_TEXTURE its red
///                                                                     channel
///   ETAK_ALPHA_TEST, ETAK_ALPHA_BLEND                                 and whether alpha is fetched:
///   ETAK_ALPHA_TEXTURE
std::vector<std::string> material_defines(const MaterialFate& fate, AlphaMode mode);

}  // namespace etak
