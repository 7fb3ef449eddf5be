// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/defines.h"

namespace etak {

std::vector<std::string> material_defines(const MaterialFate& fate, AlphaMode mode) {
  std::vector<std::string> out;
  const auto& constant = fate.constant;
  const auto varies = [&](std::size_t first) {
    return !constant[first] || !constant[first + 1] || !constant[first + 2];
  };
  if (varies(0))
    out.push_back("ETAK_DIFFUSE_TEXTURE");
  else if (*constant[0] == 0 && *constant[1] == 0 && *constant[2] == 0)
    out.push_back("ETAK_NO_DIFFUSE");
  const bool specular_varies = varies(specular_channel);
  if (specular_varies) out.push_back("ETAK_SPECULAR_TEXTURE");
  if (specular_varies ? fate.grey : *constant[4] == *constant[5] && *constant[5] == *constant[6])
    out.push_back("ETAK_SCALAR_F0");
  if (!constant[gloss_channel]) out.push_back("ETAK_GLOSS_TEXTURE");
  const bool opaque = mode == AlphaMode::opaque || constant[alpha_channel] == 255;
  if (!opaque) out.push_back(mode == AlphaMode::mask ? "ETAK_ALPHA_TEST" : "ETAK_ALPHA_BLEND");
  if (!opaque && !constant[alpha_channel]) out.push_back("ETAK_ALPHA_TEXTURE");
  return out;
}

}  // namespace etak
