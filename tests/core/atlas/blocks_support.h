// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/image/astc_codec.h"
#include "core/image/files/containers.h"
#include "core/image/image_io.h"
#include "core/validate/files/check.h"
#include "core/validate/files/layout_targets.h"
#include "tests/core/atlas/pack_support.h"

/// What the tests of atlases in blocks share.
namespace etak::test {

/// A picture of slow waves with some noise, as materials have it.
inline Image8 waves(int width, int height, int channels, unsigned seed, unsigned noise) {
  std::mt19937 random(seed);
  Image8 out(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c) {
        const double wave = 128 + 60 * std::sin(0.02 * (x + 2 * c) + seed) * std::cos(0.015 * (y - c));
        out.at(x, y)[static_cast<std::size_t>(c)] =
            static_cast<std::uint8_t>(wave + static_cast<double>(random() % (noise + 1)));
      }
  return out;
}

inline std::string blocks_material(const TempFolder& folder, const std::string& name, int width, int height,
                                   unsigned seed, unsigned noise) {
  save_png(folder.file(name + "_diffuse.png"), waves(width, height, 3, seed, noise));
  save_png(folder.file(name + "_specular.png"), waves(width, height, 3, seed + 1, noise));
  save_png(folder.file(name + "_gloss.png"), waves(width, height, 1, seed + 2, noise));
  return "{\"name\": \"" + name + "\", \"diffuse\": \"" + name + "_diffuse.png\", \"specular\": \"" + name +
         "_specular.png\", \"gloss\": \"" + name + "_gloss.png\"}";
}

inline TextureFile ktx2_page(const TempFolder& folder, const std::string& texture) {
  return read_ktx2(slurp(folder.file("out/page0_" + texture + ".ktx2")), "page", astc_door());
}

inline double delta_e_of(const std::uint8_t* a, const std::uint8_t* b) {
  const auto lab = [](const std::uint8_t* code) {
    return to_lab(
        LinearRgb{srgb_decode(code[0] / 255.0), srgb_decode(code[1] / 255.0), srgb_decode(code[2] / 255.0)});
  };
  return delta_e2000(lab(a), lab(b));
}

/// Options of a word of --compress.
inline PackOptions in_blocks(std::string_view word,
                             std::vector<std::string> formats = {"png", "ktx2", "dds"}) {
  PackOptions out;
  out.output.write.formats = std::move(formats);
  out.output.compress = compress_word(word);
  out.input.pictures.door = picture_door();
  return out;
}

/// What the validator finds in the pages of a layout, but for compression that loses something.
inline std::vector<std::string> rules_of(const std::string& layout, const PictureDoor& door) {
  std::vector<std::string> out;
  for (const CheckTarget& target : targets_of_layout(layout, "layout"))
    for (const Finding& finding : check(target, door, Settings{}).findings)
      if (finding.rule != "ETK005") out.push_back(finding.rule + ' ' + finding.tile);
  return out;
}

}  // namespace etak::test
