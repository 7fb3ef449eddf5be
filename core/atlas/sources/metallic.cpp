// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/sources/metallic.h"

#include <array>
#include <memory>

#include "core/atlas/sources/floats.h"
#include "core/atlas/sources/sources.h"
#include "core/atlas/texels/page_memory.h"
#include "core/color/srgb.h"
#include "core/scene/material_texels.h"

namespace etak {

void set_metallic(const PlaneSource& metal, PackInput& in) {
  const auto planes = std::make_shared<std::array<PlaneSource, 4>>(
      std::array<PlaneSource, 4>{in.color[0], in.grey[0], metal, in.grey[1]});
  const int width = in.width, height = in.height;
  in.convert = [planes, width, height](std::vector<std::string>&) {
    MaterialPair out{Image8(width, height, 4), Image8(width, height, 4)};
    std::array<FileBytes, 4> files;
    std::vector<PlaneRows> rows;
    for (std::size_t i = 0; i < 4; ++i) rows.emplace_back((*planes)[i], files[i]);
    for (int y = 0; y < height; ++y) {
      std::array<const std::uint8_t*, 4> at{};
      for (std::size_t i = 0; i < 4; ++i) at[i] = (*planes)[i].is_image() ? rows[i].read(1) : nullptr;
      auto* a = out.diffuse_alpha.at(0, y).data();
      auto* b = out.specular_gloss.at(0, y).data();
      const auto texels = static_cast<std::size_t>(width);
      interleave(a, texels, at[0], rows[0], at[1], rows[1]);
      interleave(b, texels, at[2], rows[2], at[3], rows[3]);
      for (std::size_t x = 0; x < texels; ++x) {
        const double share = b[4 * x] / 255.0;
        for (std::size_t c = 0; c < 3; ++c) {
          const MetallicChannel texel = metallic_channel(srgb_decode(a[4 * x + c] / 255.0), share);
          a[4 * x + c] = srgb_u8(texel.diffuse);
          b[4 * x + c] = srgb_u8(texel.f0);
        }
      }
    }
    return out;
  };
  in.convert_floats = [planes, width, height] {
    return metallic_floats((*planes)[0], (*planes)[1], (*planes)[2], (*planes)[3], width, height);
  };
  in.color[1] = PlaneSource{};
}

}  // namespace etak
