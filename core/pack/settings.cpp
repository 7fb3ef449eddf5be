// SPDX-License-Identifier: Apache-2.0
#include "core/pack/settings.h"

#include <algorithm>
#include <type_traits>

#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"
#include "core/image/image.h"

namespace etak {
namespace settings_table {

using S = PackSettings;
constexpr auto shown = PackSettingRow::shown, file = PackSettingRow::file, flag = PackSettingRow::flag,
               or_number = PackSettingRow::or_number, commas = PackSettingRow::commas,
               line_only = PackSettingRow::line_only;
constexpr std::string_view layout = "Layout", less = "Leaving out", content = "Content", output = "Output";

// Group, name, value, least, most, name of the value, traits, help, words.
constexpr PackSettingRow setting_rows[] = {
    {layout, "page", &S::page, 1, max_image_side, "N", shown, "largest side of a page"},
    {layout, "page-form", &S::page_form, 0, 0, "", shown,
     "mixed (powers of two up to {page}, least area), pages (all {page}), square, pot, free or mult4 (one page; of mult4 the sides are multiples of 4, as block compression wants them); auto: free for a scene that fits one page, else mixed",
     "auto mixed pages square pot free mult4"},
    {layout, "rotate", &S::rotate, 0, 0, "0|1", shown, "1: regions may be turned by 90 degrees"},
    {layout, "effort", &S::effort, 1, 1000000, "N", shown,
     "layouts to try; the same number gives the same layout everywhere"},
    {layout, "max-seconds", &S::max_seconds, 0, 1e6, "S", line_only,
     "begin no further try after this time; the layout then depends on the machine"},
    {layout, "gutter", &S::gutter, 0, 0, "auto|N", shown | or_number,
     "texels around each region that repeat its edge; auto: from the mips, none where that would cost more than a quarter of the area (UVs are then inset); 2 for scenes whose mips viewers make"},
    {layout, "mips", &S::mips, 0, 0, "auto|all|N", shown | or_number,
     "levels, level 0 among them; all: down to 1 x 1; auto: all for ktx2 and dds, else 1"},
    {layout, "previous", &S::previous, 0, 0, "FILE", file,
     "layout.json of an earlier run: unchanged regions stay where they were"},
    {layout, "extra-area", &S::extra_area, 0, 1000, "", shown, "percent of page area that staying may cost"},
    {less, "keep", &S::keep, 0, 0, "WHAT", commas,
     "do not leave out: unreached, equal, alpha, constant, grey, crop, islands, resolution, textures, mips, files or all; may be given again"},
    {less, "choice", &S::choice, 0, 0, "FILE", file,
     "what etak choose found for this input (its JSON): defines of shaders, textures that may be one number, mips that nothing reads, F0's integration, PNG level"},
    {less, "islands", &S::islands, 0, 0, "", flag,
     "of a scene, keep only the islands of texels that triangles use; as is done anyhow where that is smaller, but for {goal} one-page, unless {keep} says islands"},
    {less, "max-error", &S::max_error, 0, 1000, "DE", 0,
     "store a region at half its size, a quarter, ... while that differs by no more than so many dE2000 (and percent of alpha and of gloss) from what can be seen"},
    {less, "texel-density", &S::texel_density, 1e-9, 1e12, "N", 0,
     "of a scene: so many texels per unit of its world are enough"},
    {less, "view-height", &S::view_height, 1, 1000000, "PIXELS", 0,
     "of a scene with cameras: height of their pictures in pixels; resolution and mips that none of them can show are left out"},
    {content, "pattern", &S::pattern, 0, 0, "", 0,
     "of the files in a folder, as {name}_{role}.png; default: names as validate reads them"},
    {content, "gloss-channel", &S::gloss, 0, 0, "", 0,
     "what the gloss channel is to hold: schueler, one_minus_roughness or roughness; default as the input",
     "schueler one_minus_roughness roughness", "gloss"},
    {content, "space-of", &S::space_of, 0, 0, "ROLE=SPACE", 0,
     "ROLE=SPACE: colour space of pictures that name none: srgb, linear, power-2.2 or one of the OpenColorIO config; roles: diffuse, specular, basecolor; may be given again"},
    {content, "ocio", &S::ocio, 0, 0, "FILE", file,
     "OpenColorIO config to look spaces up in (else $OCIO, else etak's own)"},
    {content, "bleed", &S::bleed, 0, 0, "", flag,
     "give texels of alpha 0 the colours of their visible neighbours"},
    {content, "scene", &S::scene, 0, 1000000, "", 0,
     "of a glTF: the scene that counts (default: the file's own)"},
    {content, "all-scenes", &S::all_scenes, 0, 0, "", flag | line_only, "all of its scenes count"},
    {content, "drop-variants", &S::drop_variants, 0, 0, "", flag | line_only,
     "materials that only KHR_materials_variants uses do not count"},
    {content, "gltf-form", &S::gltf_form, 0, 0, "FORM", shown,
     "materials of the written glTF: smallest (of the forms that are exact in this scene the one whose textures weigh least), specular-ior (KHR_materials_specular and _ior), specular-glossiness or metal-rough; "
     "of several with ',' between the first is the material, the others are added"},
    {content, "gltf-container", &S::gltf_container, 0, 0, "", shown,
     "gltf: scene.gltf with its files beside it; glb: scene.glb, which holds its pictures and its buffer",
     "gltf glb"},
    {content, "gltf-pictures", &S::gltf_pictures, 0, 0, "", shown,
     "of the written glTF: png; webp: lossless WebP (EXT_texture_webp) in place of each PNG that is larger",
     "png webp"},
    {content, "goal", &S::goal, 0, 0, "", shown,
     "what is weighed where a scene's textures can be written in several ways (form, islands, on a page or as they were): gpu (bytes on a GPU, uncompressed with mips), disk (bytes of the files, which are "
     "compressed to be weighed) or both (shares of the input's, added); auto: both, of what takes no more of either than the input; one-page: one pair of textures for all materials, each of diffuse, alpha, F0 and gloss that they share stored once, numbers as texels, and no scene.gltf",
     "auto gpu disk both one-page"},
    {output, "textures", &S::format, 0, 0, "LIST", shown,
     "files of the textures: png, ktx2, dds, and in floats tiff, exr; with ',' between", "", "format"},
    {output, "png-level", &S::png_level, 0, 0, "", shown,
     "fast, small or smallest; auto: of each picture the level at which compressing it and sending it once at 1 MB/s takes least, and palettes or grey of fewer bits for those that only a scene reads",
     "fast small smallest auto"},
    {output, "zstd", &S::zstd, 0, 22, "", shown, "Zstandard level of ktx2; 0: none"},
    {output, "compress", &S::compress, 0, 0, "", shown,
     "textures of ktx2 and dds in blocks that a GPU reads: bc7, or of ktx2 astc:NxN; auto (bc7) and astc (astc:4x4): those alone on which every material stays within {block-error}, the others as RGBA8",
     "none auto bc7 astc astc:4x4 astc:5x5 astc:6x6 astc:8x8"},
    {output, "block-error", &S::block_error, 0, 0, "N|LIST", shown,
     "what blocks may change, at the 99th percentile of each material's texels: diffuse=1,f0=1,gloss=10,alpha=0.5 (dE2000 twice, percent of the gloss exponent, percent of coverage) or some of these; N: so many times that"},
    {output, "compress-effort", &S::compress_effort, 1, 4, "N", shown,
     "of the first try at each block, 1 to 4; blocks that miss {block-error} are tried again with more"},
};

}  // namespace settings_table

std::vector<std::string> PackSettingRow::word_list() const {
  return parts_of(words, ' ');
}

std::string PackSettingRow::help_text() const {
  std::string out(help);
  for (std::size_t at = 0; (at = out.find('{', at)) != out.npos;) {
    const std::size_t end = out.find('}', at);
    out.replace(at, end + 1 - at, setting(std::string_view(out).substr(at + 1, end - at - 1)));
  }
  return out;
}

const PackSettingRow* find_pack_setting(std::string_view name, std::string& remark) {
  std::string asked(name);
  std::ranges::replace(asked, '_', '-');
  for (const PackSettingRow& row : pack_setting_rows()) {
    if (row.name != asked && (row.older != asked || asked.empty())) continue;
    if (row.name != asked) remark = asked + ": is now called " + std::string(row.name);
    return &row;
  }
  return nullptr;
}

std::span<const PackSettingRow> pack_setting_rows() {
  return settings_table::setting_rows;
}

std::string settings_text(const PackSettings& settings) {
  std::string out;
  const auto text_of = [](const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, std::string>) {
      return value;
    } else if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
      std::string all;
      for (const std::string& each : value) append(all, std::to_string(each.size()), ':', each);
      return all;
    } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
      return value ? number(*value, 17) : std::string("none");
    } else if constexpr (std::is_same_v<Value, double>) {
      return number(value, 17);
    } else {
      return std::to_string(value);
    }
  };
  for (const PackSettingRow& row : pack_setting_rows())
    std::visit(
        [&](auto member) {
          const std::string text = text_of(settings.*member);
          append(out, row.name, '=', std::to_string(text.size()), ':', text, '\n');
        },
        row.value);
  return out;
}

}  // namespace etak
