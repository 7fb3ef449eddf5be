// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/atlas/sources/plane.h"
#include "core/color/gloss.h"
#include "core/image/image.h"
#include "core/image/material_pair.h"

namespace etak {

struct PackInput;

// Two to four materials by the greys or ID colours of a mask. A mask is smooth at its edges, but a mixture of a metal's
// F0 with that of paint would be the F0 of nothing, in the forbidden zone. So every texel takes all of its channels from
// one material: the one that covers more of it.

using MaskCode = std::array<std::uint8_t, 3>;

/// Codes that those of two materials are apart at least.
inline constexpr int least_codes_apart = 16;
/// The largest difference of a channel.
int codes_apart(const MaskCode& a, const MaskCode& b);

/// The material of each texel of a mask, as an index of `codes`.
///   mask     three channels, which are equal where the mask has greys
///   codes    two to four
///   colors   they are ID colours. Two greys need not occur themselves: a texel has the nearer one. All others decide only
///            texels that are within 8 codes of one; what lies between is an edge, whose texels take the nearer of
///            those materials that stand within 3 texels. So the edge from the first of three greys to the last is not
///            drawn in the second one
///   path     names the picture in messages
/// Throws Error that tells the place of a texel that is of no material and on no edge.
std::vector<std::uint8_t> parts_of_mask(const Image8& mask, std::span<const MaskCode> codes, bool colors,
                                        const std::string& path);

/// One material of a mask.
///   specular   of one value
///   metal      has no diffuse colour and an F0 as only metals and semiconductors have: metalness 1
struct MaskedPart {
  MaskCode code{};
  PlaneSource diffuse, specular, gloss;
  bool metal = false;
};

/// A mask with its materials, as the packer reads them.
///   gloss   the form of what comes out
struct MaskedSource {
  PlaneSource mask;
  bool colors = false;
  std::vector<MaskedPart> parts;
  PlaneSource alpha;
  GlossForm gloss = GlossForm::schueler;
  bool specular_gloss = false, metal_rough = false;  // the files that are written

  /// The planes that are pictures.
  std::vector<const PlaneSource*> pictures() const;
  MaterialPair pair(int width, int height) const;
  FloatPair floats(int width, int height) const;
};

/// Ends of the names of the files below.
inline constexpr std::array<std::string_view, 6> mask_file_endings{"_diffuse.png",     "_specular.png",
                                                                   "_gloss.png",       "_mr_basecolor.png",
                                                                   "_mr_metallic.png", "_mr_roughness.png"};

/// Name and bytes of each file that the mask of a material wants beside the atlas: NAME_diffuse.png, NAME_specular.png
/// and NAME_gloss.png; NAME_mr_basecolor.png, NAME_mr_metallic.png and NAME_mr_roughness.png, whose base colour is F0 of a
/// metal and the diffuse colour of anything else. None where the material has no mask.
std::vector<std::pair<std::string, std::string>> mask_files(const PackInput& material);

}  // namespace etak
