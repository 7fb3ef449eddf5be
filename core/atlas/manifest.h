// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/color/gloss.h"
#include "core/color/rgb.h"
#include "core/scene/gltf.h"

namespace etak {

// What is to be packed, as a person or a script writes it down (resources/schema/atlas-manifest.schema.json).

/// A picture file.
///   channels   letters of "rgba", three for a colour, one for a grey quantity; empty: the first ones
///   space      "srgb", "linear", "power-2.2" or a colour space of an OpenColorIO config; empty: srgb for
///              colours, linear for grey quantities
struct ImageSource {
  std::string path, channels, space;
  friend bool operator==(const ImageSource&, const ImageSource&) = default;
};

/// A material of the library: F0 where specular is asked for, the measured reflectance for diffuse.
struct LibrarySource {
  std::string material, dataset, outside;
  std::string method{};  // of F0's integration; empty: etak's default. Manifests cannot say it
  friend bool operator==(const LibrarySource&, const LibrarySource&) = default;
};

/// One value for all texels. A colour that was given as "#rrggbb" has `codes`, which are kept as they are.
///   layers   of an F0 that layers on a base make: their text (core/material/stack_text.h). Manifests cannot say it
struct ConstantSource {
  LinearRgb linear;
  std::optional<Srgb8> codes;
  std::string layers = {};
  friend bool operator==(const ConstantSource&, const ConstantSource&) = default;
};

using TextureSource = std::variant<ImageSource, LibrarySource, ConstantSource>;

/// A material of a mask.
///   code     the grey of its texels, three times, or their ID colour
///   record   of the library: F0, of a measured surface the diffuse colour too, and where neither gloss nor roughness
///            is said the record's convention; no material: there is none, and `specular` says F0
struct MaskPart {
  std::array<std::uint8_t, 3> code{};
  LibrarySource record;
  std::optional<TextureSource> diffuse, specular, gloss, roughness;
  std::string place;  // for messages
};

/// Which of two to four materials a texel is of. None is ever mixed of two: see core/atlas/sources/masked.h.
///   colors           the picture holds ID colours, else greys
///   specular_gloss   write the material's own textures beside the atlas, and those of metal-rough
struct MaterialMask {
  static constexpr std::size_t least_parts = 2, most_parts = 4;
  ImageSource image;
  bool colors = false;
  std::vector<MaskPart> parts;
  bool specular_gloss = false, metal_rough = false;
};

/// One material of a manifest. Missing: diffuse is black, alpha 1. Either specular (and diffuse), or
/// base_color with metallic (glTF's meaning); either gloss or roughness. A mask takes the place of all of these.
struct ManifestMaterial {
  std::string name;
  std::optional<TextureSource> diffuse, specular, gloss, roughness, alpha, base_color, metallic;
  std::optional<GlossForm>
      gloss_form;  // of its own gloss; none: as the manifest says. Manifests cannot say it
  std::optional<MaterialMask> mask;
  std::string normal;  // file of a tangent-space normal map; empty: none
  AlphaMode alpha_mode = AlphaMode::blend;
  double alpha_cutoff = 0.5;
  std::optional<int> width, height;  // checked against the pictures; the size where there are none
  std::string place;                 // "FILE#/materials/3", for messages
};

/// What is to be packed: materials with the sources of their channels.
struct AtlasManifest {
  GlossForm gloss = GlossForm::schueler;  // of every "gloss"
  std::vector<ManifestMaterial> materials;
};

/// Reads a manifest. Paths in it are relative to its own folder and come out relative to the working folder.
/// Throws Error with the JSON pointer: unknown keys, wrong types, two materials of one name, values outside
/// of their range.
AtlasManifest parse_manifest(std::string_view text, const std::string& file);

/// The text of a manifest whose materials all have a mask with numbers and records of the library.
///   file   path that it is to be saved under: pictures are named from its folder
std::string format_masks(const AtlasManifest& manifest, const std::string& file);

/// The materials of a folder whose files follow a pattern such as "{name}_{role}.png". Roles: diffuse,
/// specular, gloss, roughness, alpha, basecolor, metallic, normal. Files that do not match are left alone;
/// a folder in which none does is an Error. Sorted by name.
///   skipped   where given, gets the paths that match and are no regular files, such as pipes
AtlasManifest manifest_of_folder(const std::string& folder, const std::string& pattern,
                                 std::vector<std::string>* skipped = nullptr);
/// Whether a picture of a folder follows the pattern, and all do whose names tell the packer something.
bool all_follow(const std::string& folder, const std::string& pattern);

}  // namespace etak
