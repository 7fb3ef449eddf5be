// SPDX-License-Identifier: Apache-2.0
// The table of conventions: one row for each thing that a picture may hold, by whose names.
//
// Based on
//   Poly Haven    the files of its downloads: NAME_diff_4k.jpg, NAME_arm_4k.jpg, NAME_nor_gl_4k.exr
//   ambientCG     the files of its downloads: NAME_4K-PNG_Color.png
//   Quixel        the files of Megascans and Bridge: ID_4K_Albedo.jpg, ID_4K_Normal_LOD0.jpg
//   Substance     the export presets of Substance 3D Painter: MESH_SET_BaseColor.png
//   Unity         property names of the Standard, URP and HDRP shaders, and Painter's presets for them
//   Unreal        "Recommended Asset Naming Conventions" of its documentation, and Allar's style guide
#include <array>
#include <utility>

#include "core/names/names.h"

namespace etak {

// A namespace of its own, because its short names are common words.
namespace convention_rows {

using enum Convention;
using enum FileRole;

constexpr bool unsure = false, sure = true;
constexpr GreenAxis no_axis = GreenAxis::unsaid, gl = GreenAxis::opengl, dx = GreenAxis::directx;

// A name is compared with whole words. Of the rows with one word the first is taken whose convention's marks
// the name bears.
constexpr auto words_table = std::to_array<NameWord>({
    // Unreal: T_ in front; without it these are proof only together.
    {unreal, "bc d c basecolor base_color albedo diffuse color", base_color, "", sure},
    {unreal, "a", base_color, "", sure, no_axis, opacity},
    {unreal, "n nrm normal normals", normal, "", sure, dx},
    {unreal, "orm arm aorm occlusionroughnessmetallic", metal_rough, "orm-"},
    {unreal, "rma rmo rmao", metal_rough, "rmo-"},
    {unreal, "mra mro mrao", metal_rough, "mro-"},
    {unreal, "ram rom", metal_rough, "rom-"},
    {unreal, "ord ordp orh", metal_rough, "orh-"},
    {unreal, "m", metallic, "", sure, no_axis, other},
    {unreal, "met mt metallic metalness", metallic},
    {unreal, "r rgh roughness", roughness},
    {unreal, "g gloss glossiness", gloss},
    {unreal, "s spec specular", specular_gloss},
    {unreal, "ao o occlusion ambientocclusion", occlusion},
    {unreal, "e em emissive", emissive},
    {unreal, "h height disp displacement b bump", height},
    {unreal, "op opacity alpha", opacity},
    {unreal, "mask masks msk sss cc f id", other},

    // ambientCG: resolution and format in front of the word.
    {ambient_cg, "color", base_color},
    {ambient_cg, "roughness", roughness},
    {ambient_cg, "metalness", metallic},
    {ambient_cg, "normalgl", normal, "", sure, gl},
    {ambient_cg, "normaldx", normal, "", sure, dx},
    {ambient_cg, "ambientocclusion", occlusion},
    {ambient_cg, "displacement", height},
    {ambient_cg, "opacity", opacity},
    {ambient_cg, "emission", emissive},

    // Poly Haven: resolution behind the word.
    {poly_haven, "diff diffuse col col_1 col_2 col_3 col_4 col_01 col_02 col_03 col_04", base_color},
    {poly_haven, "rough roughness", roughness},
    {poly_haven, "metal metallic", metallic},
    {poly_haven, "arm", metal_rough, "orm-"},
    {poly_haven, "spec", specular_gloss},
    {poly_haven, "nor_gl", normal, "", sure, gl},
    {poly_haven, "nor_dx", normal, "", sure, dx},
    {poly_haven, "nor", normal},
    {poly_haven, "ao", occlusion},
    {poly_haven, "disp bump", height},
    {poly_haven, "opacity alpha", opacity},
    {poly_haven, "emission emissive", emissive},
    {poly_haven, "mask translucent spec_ior anisotropy_rotation anisotropy_strength", other},

    // Quixel: resolution in front of the word.
    {quixel, "albedo basecolor", base_color},
    {quixel, "diffuse", diffuse_alpha},
    {quixel, "roughness", roughness},
    {quixel, "metalness", metallic},
    {quixel, "specular", specular_gloss},
    {quixel, "gloss", gloss},
    {quixel, "normal normalbump", normal},
    {quixel, "ao", occlusion},
    {quixel, "displacement bump", height},
    {quixel, "opacity", opacity},
    {quixel, "cavity translucency transmission fuzz brush mask", other},

    // Unity: words that nobody else uses.
    {unity, "basemap basecolormap albedotransparency maintex", base_color},
    {unity, "maskmap", metal_rough, "mo-s"},
    {unity, "metallicsmoothness metallicglossmap metallicgloss", metal_rough, "m--s"},
    {unity, "specularsmoothness specglossmap specularcolormap", specular_gloss},
    {unity, "normalmap bumpmap", normal, "", sure, gl},
    {unity, "heightmap parallaxmap", height},
    {unity, "occlusionmap", occlusion},
    {unity, "emissionmap emissivecolormap emissivemap", emissive},
    {unity, "detailmap detailmask thicknessmap bentnormalmap subsurfacemaskmap coatmaskmap", other},

    // Substance: words with a capital.
    {substance, "basecolor base_color", base_color},
    {substance, "diffuse", diffuse_alpha},
    {substance, "roughness", roughness},
    {substance, "metallic metalness", metallic},
    {substance, "occlusionroughnessmetallic occlusion_roughness_metallic", metal_rough, "orm-"},
    {substance, "specular", specular_gloss},
    {substance, "glossiness", gloss},
    {substance, "normal_opengl normalopengl", normal, "", sure, gl},
    {substance, "normal_directx normaldirectx", normal, "", sure, dx},
    {substance, "normal normal_base", normal},
    {substance, "height displacement", height},
    {substance, "ambientocclusion ambient_occlusion mixed_ao mixedao ao", occlusion},
    {substance, "emissive emission", emissive},
    {substance, "opacity", opacity},
    {substance, "specularlevel specular_level reflection ior anisotropylevel anisotropyangle transmissive",
     other},

    // Blender, Godot, glTF and many others.
    {common, "basecolor base_color basecoloralpha basecolour base_colour albedo albedomap", base_color},
    {common, "color colour col colormap basecol alb", base_color, "", unsure},
    {common,
     "diffuse_alpha diffusealpha diff dif diffuse diffusemap diffusecolor diffuse_color color_diffuse",
     diffuse_alpha},
    {common, "specular_gloss speculargloss specgloss specularglossiness spec specular", specular_gloss},
    {common, "f0", f0_only},
    {common, "metallic metalness metallicmap metalnessmap", metallic},
    {common, "metal metalic met mtl", metallic, "", unsure},
    {common, "roughness roughnessmap specularroughness specular_roughness", roughness},
    {common, "rough rgh", roughness, "", unsure},
    {common, "glossiness smoothness", gloss},
    {common, "gloss smooth", gloss, "", unsure},
    {common, "metallicroughness metalrough metalroughness", metal_rough},
    {common, "orm occlusionroughnessmetallic occlusionroughmetal occlusion_roughness_metallic aorm",
     metal_rough, "orm-"},
    {common, "arm", metal_rough, "orm-", unsure},
    {common, "rma rmo rmao", metal_rough, "rmo-", unsure},
    {common, "mra mro mrao", metal_rough, "mro-", unsure},
    {common, "normal_gl normalgl normal_ogl normalogl normal_opengl nor_gl norgl nrm_gl", normal, "", sure,
     gl},
    {common, "normal_dx normaldx normal_directx normaldirectx nor_dx nordx nrm_dx", normal, "", sure, dx},
    {common, "normal normals nrm nor norm nml ddn ddna", normal},
    {common, "height displacement displace disp bump depth parallax", height},
    {common, "ao ambientocclusion ambient_occlusion occlusion occ", occlusion},
    {common, "emissive emission emit", emissive},
    {common, "opacity alpha transparency", opacity},
    {common, "cavity curvature thickness translucency transmission subsurface sss sheen coat clearcoat",
     other},
    {common, "anisotropy specularlevel fuzz mask masks idmap flowmap bentnormal bent_normal", other},
    {common, "preview thumb thumbnail wireframe", other},

    // German, French, Spanish and Japanese; without accents, as normal_ending() leaves them.
    {common, "grundfarbe basisfarbe couleur_de_base couleurdebase color_base colorbase ベースカラー アルベド",
     base_color},
    {common, "farbe couleur カラー", base_color, "", unsure},
    {common, "streufarbe", diffuse_alpha},
    {common, "spekular speculaire especular", specular_gloss},
    {common, "rauheit rauigkeit rauhigkeit rugosite rugosidad ラフネス 粗さ", roughness},
    {common, "metallisch metallique metalico metalicidad メタリック メタルネス 金属", metallic},
    {common, "glanz glattheit brillance brillo 光沢", gloss, "", unsure},
    {common, "normalen normale normales 法線 ノーマル", normal},
    {common, "hohe hohenkarte hauteur altura 高さ", height},
    {common, "umgebungsverdeckung occlusion_ambiante oclusion oclusion_ambiental 環境遮蔽", occlusion},
    {common, "emissif emision emisivo 発光", emissive},
    {common, "deckkraft opacite opacidad 不透明度", opacity},
});

constexpr auto names = std::to_array<std::pair<Convention, std::string_view>>({{common, "common"},
                                                                               {ambient_cg, "ambientCG"},
                                                                               {poly_haven, "Poly Haven"},
                                                                               {quixel, "Quixel"},
                                                                               {substance, "Substance"},
                                                                               {unity, "Unity"},
                                                                               {unreal, "Unreal"},
                                                                               {own, "etak.toml"}});

}  // namespace convention_rows

namespace {

constexpr auto channel_words = std::to_array<std::pair<char, std::string_view>>({{'r', "roughness"},
                                                                                 {'s', "smoothness"},
                                                                                 {'m', "metallic"},
                                                                                 {'o', "occlusion"},
                                                                                 {'h', "height"},
                                                                                 {'a', "opacity"},
                                                                                 {'-', "none"}});

}  // namespace

std::span<const NameWord> name_words() {
  return convention_rows::words_table;
}

std::string_view name(Convention convention) {
  for (const auto& [value, text] : convention_rows::names)
    if (value == convention) return text;
  return "";
}

bool absent_metalness_is_dielectric(Convention convention) {
  return convention != Convention::unreal && convention != Convention::unity;
}

std::string_view channel_word(char letter) {
  for (const auto& [value, word] : channel_words)
    if (value == letter) return word;
  return "";
}

std::optional<char> channel_letter(std::string_view word) {
  for (const auto& [value, text] : channel_words)
    if (text == word) return value;
  return std::nullopt;
}

}  // namespace etak
