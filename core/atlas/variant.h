// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/color/gloss.h"
#include "core/image/channels.h"

namespace etak {

// What `etak choose` found for each material: how it is best shaded and stored. Read from the JSON of that
// command (resources/schema/choose.schema.json), and written as defines into an atlas's layout.

/// How one material is drawn and stored.
struct MaterialVariant {
  std::string material;        // its name in the scene or in the library
  std::string library;         // "gold/johnson_1972"; empty: F0 is known as a colour alone
  std::string model;           // "microfacet:ggx,f82,smith-ggx-height"
  std::vector<double> values;  // of the model's parameters, in order
  std::array<double, 3> diffuse{0, 0, 0}, f0{0.04, 0.04, 0.04};  // linear; of the mean texel, as is
  Gloss gloss = 0.75;                                            // Schueler's g, or a roughness
  std::string method;                                            // of F0's integration; empty: no spectrum
  std::string filter;                                            // "trilinear"
  bool textured = false;
  std::array<std::uint8_t, channel_count> codes{};  // of the mean texel
  std::vector<std::string> defines;

  /// The texture varies, but within the budget: the mean texel will do.
  bool flattens() const { return textured && filter == "constant"; }
  bool reads_mips() const { return filter == "trilinear" || filter == "nearest-mip"; }
};

/// The choice of `etak choose` for each material of a scene.
struct ShadingVariants {
  std::string png_level;                   // "fast"
  std::vector<MaterialVariant> materials;  // by name, each once

  const MaterialVariant* find(std::string_view material) const;
};

/// Reads what `etak choose --format json` wrote. Throws Error with the JSON pointer.
ShadingVariants parse_choices(std::string_view text, std::string_view file);

/// How a material is shaded, as defines, such as ETAK_LOBE_GGX, ETAK_FRESNEL_F82 and
/// ETAK_MASKING_SMITH_GGX_HEIGHT (terms of the registry, upper case, '_' for '-') and ETAK_FILTER_TRILINEAR
/// (how the textures are read). A model of no terms is one define, ETAK_MODEL_SCHUELER_KSK.
///   model    the id of a model, "microfacet:ggx,f82,smith-ggx-height" or "schueler-ksk"
///   filter   the id of a filter, "trilinear"
std::vector<std::string> shading_defines(std::string_view model, std::string_view filter);

}  // namespace etak
