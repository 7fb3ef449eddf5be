// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace etak {

/// What a file holds.
enum class FileRole {
  diffuse_alpha,   // A: diffuse RGB and alpha
  specular_gloss,  // B: specular RGB (F0) and gloss
  f0_only,         // F0 as RGB; a fourth channel, if any, is gloss
  base_color,      // metal-rough: base colour and alpha
  metal_rough,     // metal-rough: G roughness, B metallic
  metallic,        // the same in files of their own: grey
  roughness,
  gloss,     // 1 - roughness in a file of its own: grey
  layout,    // JSON of a packed atlas
  scene,     // glTF
  material,  // material JSON
  spectrum,  // page or table of n,k or reflectance
  surfaces,  // materials of MaterialX or USD, or a table of exported values
  // Maps beside the colours of a material, which the rules 7xx judge.
  normal,
  height,
  occlusion,
  emissive,
  // What names tell and no rule judges.
  opacity,
  other,    // cavity, masks, translucency, ...
  ignored,  // left out by [names] of etak.toml
};

/// What files of a role are: a picture of a diffuse and specular pair or of a metal-rough set, a map beside these, a
/// document, or a picture that no rule judges.
enum class RoleKind { pair, metal_rough, map, document, named };

/// All that is known of a role.
///   name   "diffuse", "specular", "f0", "base-color", "metal-rough", "layout", ...
///   data   the picture holds metal or roughness, which have no transfer curve
struct RoleTraits {
  FileRole role;
  std::string_view name;
  RoleKind kind;
  bool data = false;
};
const RoleTraits& traits(FileRole role);
std::string_view name(FileRole role);
// The role of that name, among those that are judged; gloss alone is none of them.
std::optional<FileRole> role_named(std::string_view text);
// The role of that name, among all that the name of a picture may tell: also "gloss", "normal", "ignore", ...
std::optional<FileRole> picture_role_named(std::string_view text);
// The roles that a user may give to a picture, for messages.
inline constexpr std::string_view picture_roles = "diffuse, specular, f0, base-color or metal-rough";

/// Whether pictures of this role are judged as a material's colours, metal and gloss.
bool is_judged(FileRole role);
/// Whether they are maps that are judged beside those: normal, occlusion and emissive maps, and height for
/// the normal map beside it.
bool is_map(FileRole role);

/// False for layouts, scenes, materials, spectra and surfaces.
bool is_picture(FileRole role);

/// The direction in the picture in which the green channel of a normal map points: up (OpenGL) or down (DirectX).
enum class GreenAxis { unsaid, opengl, directx };
std::string_view name(GreenAxis green);                       // "opengl", "directx"; empty: unsaid
std::optional<GreenAxis> green_named(std::string_view text);  // of "opengl" and "directx"

}  // namespace etak
