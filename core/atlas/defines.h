// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/atlas/leave_out.h"

namespace etak {

/// What a shader of this material must hold, one define each:
///   ETAK_DIFFUSE_TEXTURE    the diffuse colour is fetched from its texture; without it, it is a uniform
///   ETAK_SPECULAR_TEXTURE   the same for F0
///   ETAK_GLOSS_TEXTURE      the same for gloss
///   ETAK_NO_DIFFUSE         diffuse is black everywhere
///   ETAK_SCALAR_F0          F0 is one grey number: the uniform's, or with ETAK_SPECULAR_TEXTURE the
///                           texture's red channel
///   ETAK_ALPHA_TEST         texels are kept or dropped by alpha
///   ETAK_ALPHA_BLEND        texels are blended by alpha
///   ETAK_ALPHA_TEXTURE      alpha is fetched from its texture
/// and beside these, where the texture of F0 and gloss is in BC4 or BC5 (AtlasPage::in_blocks):
///   ETAK_GLOSS_IN_RED             gloss is the red channel
///   ETAK_F0_GLOSS_IN_RED_GREEN    F0 is the red channel, sRGB-encoded, and gloss the green one
/// or, where it or that of diffuse and alpha is in blocks of its colour alone (AtlasPage::fourth_apart):
///   ETAK_GLOSS_APART              gloss is red of a texture of its own
///   ETAK_ALPHA_APART              the same for alpha
/// or, where either texture ends before its small levels (AtlasPage::tail_apart):
///   ETAK_DIFFUSE_ALPHA_TAIL       they are those of a texture of their own
///   ETAK_SPECULAR_GLOSS_TAIL      the same for F0 and gloss
std::vector<std::string> material_defines(const MaterialFate& fate, AlphaMode mode);

}  // namespace etak
