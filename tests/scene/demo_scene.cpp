// SPDX-License-Identifier: Apache-2.0
#include "tests/scene/demo_scene.h"

#include "core/base/files/output_folder.h"
#include "core/color/srgb.h"
#include "core/image/files/png.h"
#include "tests/scene/demo_gltf.h"
#include "tests/scene/demo_textures.h"

namespace etak::demo {
namespace {

// Names are of materials in etak's library; what is no name is drawn or made up.
constexpr const char* manifest = R"({
  "schema": "etak-atlas-manifest/1",
  "gloss": "schueler",
  "materials": [
    {"name": "gold", "diffuse": 0, "specular": "gold",
     "gloss": {"image": "gold_gloss.png", "channels": "r", "space": "linear"}},
    {"name": "copper", "diffuse": 0, "specular": {"material": "copper"},
     "gloss": {"image": "copper_gloss.png", "channels": "r", "space": "linear"}},
    {"name": "wood", "diffuse": "wood_colour.png", "specular": "cellulose",
     "gloss": {"image": "wood_gloss.png", "channels": "r", "space": "linear"}},
    {"name": "glass", "diffuse": 0, "specular": "glass_bk7", "gloss": 1, "alpha": 0.08, "alpha_mode": "blend"},
    {"name": "red_plastic", "diffuse": "#b31218", "specular": "polystyrene", "gloss": 0.7},
    {"name": "stone_dry", "diffuse": "stone_dry.png", "specular": "quartz",
     "gloss": {"image": "stone_dry_gloss.png", "channels": "r", "space": "linear"}, "normal": "stone_normals.png"},
    {"name": "stone_wet", "diffuse": "stone_wet.png", "specular": {"material": "water"},
     "gloss": {"image": "stone_wet_gloss.png", "channels": "r", "space": "linear"}},
    {"name": "leaf", "diffuse": {"image": "leaf.png", "channels": "rgb", "space": "srgb"}, "specular": "cellulose",
     "gloss": 0.45, "alpha": {"image": "leaf.png", "channels": "a", "space": "linear"},
     "alpha_mode": "mask", "alpha_cutoff": 0.5}
  ]
}
)";

std::string png(const Image8& image, bool srgb) {
  PngOptions options;
  options.srgb = srgb;
  const auto stride = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
  return png_bytes({{image.width, image.height, image.channels, 8}, image.values.data(), stride}, options);
}

// F0 of water, (0.333 / 2.333)^2, and gloss as glTF has it.
Image8 water_and_gloss(const Image8& gloss) {
  Image8 out(gloss.width, gloss.height, 4, srgb_u8(0.0204));
  for (std::size_t i = 0; i < gloss.values.size(); ++i) out.values[4 * i + 3] = gloss.values[i];
  return out;
}

}  // namespace

void write_demo_scene(const std::string& path, bool overwrite) {
  OutputFolder out(path, overwrite ? Replace::anything : Replace::nothing);
  const auto colour = [&](const char* name, const Image8& image) { out.write(name, png(image, true)); };
  const auto plain = [&](const char* name, const Image8& image) { out.write(name, png(image, false)); };

  const Image8 wood = wood_gloss(), gold = worn_gloss(), copper = stained_gloss();
  const Image8 dry = stone_colour(false), wet_gloss = stone_gloss(true);
  colour("wood_colour.png", wood_colour());
  plain("wood_gloss.png", wood);
  plain("wood_metal_rough.png", metal_rough(wood, false));
  plain("gold_gloss.png", gold);
  plain("gold_metal_rough.png", metal_rough(gold, true));
  plain("copper_gloss.png", copper);
  plain("copper_metal_rough.png", metal_rough(copper, true));
  colour("stone_dry.png", dry);
  colour("stone_dry_copy.png", dry);
  plain("stone_dry_gloss.png", stone_gloss(false));
  colour("stone_wet.png", stone_colour(true));
  plain("stone_wet_gloss.png", wet_gloss);
  colour("stone_wet_f0_gloss.png", water_and_gloss(wet_gloss));
  plain("stone_normals.png", stone_normals());
  colour("leaf.png", leaf());

  const GltfText scene = demo_gltf("scene.bin");
  out.write("manifest.json", manifest);
  out.write("scene.gltf", scene.json);
  out.write("scene.bin", scene.buffer);
  out.commit();
}

}  // namespace etak::demo
