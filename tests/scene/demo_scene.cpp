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
    {"name": "glass", "diffuse": "glass_colour.png", "specular": "glass_bk7", "gloss": 1, "alpha": 0.08,
     "alpha_mode": "blend"},
    {"name": "red_plastic", "diffuse": "plastic_colour.png", "specular": "polystyrene",
     "gloss": {"image": "plastic_gloss.png", "channels": "r", "space": "linear"}},
    {"name": "white_paint", "diffuse": "paint_colour.png", "specular": "pmma", "gloss": 0.5},
    {"name": "stone_dry", "diffuse": "stone_dry.png", "specular": "quartz",
     "gloss": {"image": "stone_dry_gloss.png", "channels": "r", "space": "linear"}, "normal": "stone_normals.png"},
    {"name": "stone_wall", "diffuse": "stone_dry_copy.png", "specular": "quartz",
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

Image8 with_fourth(const Image8& colour, const Image8& fourth) {
  Image8 out(colour.width, colour.height, 4);
  for (std::size_t i = 0; i < out.values.size(); ++i)
    out.values[i] = i % 4 == 3 ? fourth.values[i / 4] : colour.values[i / 4 * 3 + i % 4];
  return out;
}

// F0 of water, (0.333 / 2.333)^2, and gloss as glTF has it.
Image8 water_and_gloss(const Image8& gloss) {
  const std::uint8_t f0 = srgb_u8(0.0204);
  return with_fourth(one_colour(gloss.width, {f0, f0, f0}), gloss);
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
  colour("stone_wet.png", with_fourth(stone_colour(true), Image8(512, 512, 1, 255)));
  plain("stone_wet_gloss.png", wet_gloss);
  colour("stone_wet_f0_gloss.png", water_and_gloss(wet_gloss));
  plain("stone_normals.png", stone_normals());
  colour("leaf.png", leaf());
  // What is one number, as exports have it all the same.
  colour("glass_colour.png", one_colour(512, {62, 74, 66}));
  colour("plastic_colour.png", one_colour(512, {179, 18, 24}));
  plain("plastic_gloss.png", one_colour(512, {179, 179, 179}));
  colour("paint_colour.png", one_colour(512, {222, 220, 212}));

  const GltfText scene = demo_gltf("scene.bin");
  out.write("manifest.json", manifest);
  out.write("scene.gltf", scene.json);
  out.write("scene.bin", scene.buffer);
  out.commit();
}

void write_demo_mistakes(const std::string& path, bool overwrite) {
  OutputFolder out(path, overwrite ? Replace::anything : Replace::nothing);
  const auto pair = [&](const std::string& name, const Image8& diffuse, const Image8& specular,
                        const Image8& gloss) {
    out.write(name + "_diffuse.png",
              png(with_fourth(diffuse, Image8(diffuse.width, diffuse.height, 1, 255)), true));
    out.write(name + "_specular.png", png(with_fourth(specular, gloss), true));
  };
  const Image8 stone = stone_colour(false), dull = stone_gloss(false);
  const auto even = [](std::uint8_t code) { return one_colour(512, {code, code, code}); };
  const std::uint8_t surface = srgb_u8(0.04);
  pair("crate", wood_colour(), even(srgb_u8(0.35)), wood_gloss());  // neither metal nor dielectric
  pair("statue", brightened(stone, 0.2, 0.6), one_colour(512, {250, 209, 167}), dull);  // bronze with a body
  pair("plaster", brightened(stone, 0.97, 1), even(surface), dull);  // reflects more than snow
  pair("pipe", even(0), one_colour(512, {191, 208, 250}), dull);     // copper, red and blue exchanged
  out.write("leaf_diffuse.png", png(with_black_ground(leaf()), true));
  out.write("leaf_specular.png",
            png(with_fourth(one_colour(256, {surface, surface, surface}), stained_gloss()), true));
  out.write("wall_normals.png", png(encoded_again(stone_normals()), false));
  out.commit();
}

}  // namespace etak::demo
