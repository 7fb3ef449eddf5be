// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/sources/metallic.h"

#include <array>
#include <memory>

#include "core/atlas/sources/floats.h"
#include "core/atlas/sources/pictures.h"
#include "core/color/srgb.h"

namespace etak {

namespace {

// Codes of the diffuse colour and of F0 by the codes of metalness and of a base colour's channel.
using MetallicCodes = std::array<std::array<std::array<std::uint8_t, 2>, 256>, 256>;

MetallicCodes metallic_codes() {
  MetallicCodes out;
  for (std::size_t code = 0; code < 256; ++code) {
    const double base = srgb_decode(static_cast<double>(code) / 255.0);
    for (std::size_t metal = 0; metal < 256; ++metal) {
      const MetallicChannel texel = metallic_channel(base, static_cast<double>(metal) / 255.0);
      out[metal][code] = {srgb_u8(texel.diffuse), srgb_u8(texel.f0)};
    }
  }
  return out;
}

}  // namespace

void convert_metallic(std::uint8_t* base_alpha, std::uint8_t* metal_gloss, std::size_t texels) {
  static const MetallicCodes all = metallic_codes();
  for (std::size_t i = 0; i < 4 * texels; i += 4) {
    const auto& codes = all[metal_gloss[i]];
    for (std::size_t c = i; c < i + 3; ++c) {
      const auto [diffuse, f0] = codes[base_alpha[c]];
      base_alpha[c] = diffuse;
      metal_gloss[c] = f0;
    }
  }
}

void set_metallic(const PlaneSource& metal, PackInput& in) {
  const auto planes = std::make_shared<PairPlanes>(
      PairPlanes{{in.color[0], in.grey[0], metal, in.grey[1]}, true, in.width, in.height});
  in.metallic = planes;
  in.convert = [planes](std::vector<std::string>&) {
    MaterialPair out{Image8(planes->width, planes->height, 4), Image8(planes->width, planes->height, 4)};
    PairRows rows(*planes);
    for (int y = 0; y < planes->height; ++y)
      rows.read(out.diffuse_alpha.at(0, y).data(), out.specular_gloss.at(0, y).data());
    return out;
  };
  in.convert_floats = [planes] {
    const auto& [base, alpha, metallic, gloss] = planes->planes;
    return metallic_floats(base, alpha, metallic, gloss, planes->width, planes->height);
  };
  in.color[1] = PlaneSource{};
}

}  // namespace etak
