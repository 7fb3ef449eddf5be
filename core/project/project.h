// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/atlas/manifest.h"
#include "core/exchange/export_surface.h"
#include "core/light/studio.h"
#include "core/material/find.h"
#include "core/render/scene.h"

namespace etak {

class FreeNames;  // core/base/text/free_names.h

// The materials that an author works on, as the editor saves them (resources/schema/project.schema.json).
// `etak pack` takes a project where it takes a manifest, because manifest_of() makes an AtlasManifest of it.

/// The record that an F0 is computed from, and how.
///   material   id of a material of the library or of the project's own spectra
///   dataset    id of a dataset; empty: the preferred one
///   outside    the medium in front, as outside_medium() takes it: "1.33", "water", "water/hale"; empty:
///              vacuum
///   viewing    illuminant and observer
struct MeasuredF0 {
  std::string material, dataset, outside;
  Viewing viewing;
  friend bool operator==(const MeasuredF0&, const MeasuredF0&) = default;
};

/// What a picture of a material holds.
///   base_color, metallic   in place of diffuse and specular, as glTF means them; without metallic it is 0
///   roughness, smoothness  in place of gloss: perceptual roughness, and 1 less that
///   normal                 of the tangent space
enum class Channel {
  diffuse,
  specular,
  gloss,
  alpha,
  emission,
  occlusion,
  base_color,
  metallic,
  roughness,
  smoothness,
  normal
};
inline constexpr std::array all_channels{Channel::diffuse,    Channel::specular, Channel::gloss,
                                         Channel::alpha,      Channel::emission, Channel::occlusion,
                                         Channel::base_color, Channel::metallic, Channel::roughness,
                                         Channel::smoothness, Channel::normal};
std::string_view name(Channel channel);  // "diffuse", ..., "base_color", ...
inline bool is_color(Channel channel) {
  return channel == Channel::diffuse || channel == Channel::specular || channel == Channel::emission ||
         channel == Channel::base_color;
}
/// The quantity that a renderer gets from a channel: diffuse of base_color, specular of metallic, gloss of roughness
/// and smoothness, itself of all others.
Channel drawn_as(Channel channel);

/// The least and the largest number of times that pictures repeat over a surface.
inline constexpr double least_uv_scale = 0.01, most_uv_scale = 100;

/// One material of a project. A texture replaces the number of its channel, but for emission and occlusion, which
/// it multiplies, as in glTF.
///   specular     F0, linear sRGB, not clipped; where `measured` is set, resolve() sets it, whatever the file
///                holds
///   parameters   parameters of the models by name, where they differ from what the other values give:
///                {"m", 0.3}
struct ProjectMaterial {
  std::string name;  // unique in the project
  LinearRgb diffuse{0, 0, 0}, specular{0.04, 0.04, 0.04};
  Gloss gloss = 0.75;  // Schueler's g, or a perceptual roughness
  double alpha = 1;
  LinearRgb emission{0, 0, 0};  // radiance that it sends out by itself, >= 0
  double occlusion = 1;         // share of the light from all around that reaches it
  std::optional<MeasuredF0> measured;
  std::array<std::optional<ImageSource>, all_channels.size()> textures;
  bool green_down = false;               // of the normal map: DirectX's convention, in place of OpenGL's
  std::array<double, 2> uv_scale{1, 1};  // how often the pictures repeat where they are drawn
  AlphaMode alpha_mode = AlphaMode::blend;
  double alpha_cutoff = 0.5;
  std::string specular_model{default_specular}, diffuse_model{default_diffuse};  // empty: none
  std::vector<std::pair<std::string, double>> parameters;
  friend bool operator==(const ProjectMaterial&, const ProjectMaterial&) = default;

  const std::optional<ImageSource>& texture(Channel channel) const {
    return textures[static_cast<std::size_t>(channel)];
  }
  std::optional<ImageSource>& texture(Channel channel) { return textures[static_cast<std::size_t>(channel)]; }
};

/// The emission of a material of which nothing is said: black, but white under a texture.
LinearRgb standard_emission(const ProjectMaterial& material);

/// Whether a picture gives a quantity, which is the channel of its own or what is drawn as it: with a base colour there
/// are diffuse and specular.
bool gives(const ProjectMaterial& material, Channel quantity);

/// Gives a channel a picture, or none. A standard emission stays one, and the pictures of channels that it takes the place
/// of go: diffuse and specular for a base colour or metallic, gloss for a roughness.
void set_texture(ProjectMaterial& material, Channel channel, std::optional<ImageSource> source);

/// Two sides, A and B, in one picture, so that two materials or models can be compared.
///   pinned   the material of side B, as it was when it was pinned; none: the selected material
///   model    specular model of side B; empty: the material's own
struct Comparison {
  bool on = false;
  std::optional<ProjectMaterial> pinned;
  std::string model;
  friend bool operator==(const Comparison&, const Comparison&) = default;
};

/// A row of spheres over the range of one parameter.
struct Wedge {
  static constexpr int least_steps = 2, most_steps = 16;
  bool on = false;
  std::string parameter = "gloss";
  int steps = 7;
  friend bool operator==(const Wedge&, const Wedge&) = default;
};

/// How the materials are shown.
///   exposure                linear factor
///   background              behind the object, linear, where the backdrop is not the environment
///   config, display, view   of OpenColorIO; all empty: the tone curve and sRGB
struct ProjectView {
  Shape shape = Shape::sphere;
  std::string mesh;  // in place of spheres, as shown_mesh() takes it; empty: none
  LightSetup lights = studio_lights();
  double environment_turn_deg = 0;
  double exposure = 1;
  std::string config, display, view;
  Tone tone = Tone::plain;
  LinearRgb background{0.18, 0.18, 0.18};
  Backdrop backdrop;
  Comparison compare;
  Wedge wedge;
  friend bool operator==(const ProjectView&, const ProjectView&) = default;
};

/// What the editor has open: materials, their own spectra, and how they are looked at.
struct Project {
  std::vector<ProjectMaterial> materials;
  std::vector<Material> spectra;  // imported materials; they replace those of the library with the same id
  ProjectView view;
  friend bool operator==(const Project&, const Project&) = default;

  /// The material of that name; null: none.
  const ProjectMaterial* find(std::string_view material) const;
};

/// Reads a project. Paths of picture files become relative to the working folder, as in parse_manifest().
/// `specular` of measured materials is what the file holds; resolve() computes it anew. Throws Error with the
/// JSON pointer.
Project parse_project(std::string_view text, const std::string& file);

/// The text of a project file, each material on one line. Numbers are equal when they are read back.
///   file   path that the text is to be saved under: pictures are named from its folder, by absolute paths where
///          the two share none. Empty: all by absolute paths, for a copy that may be read from anywhere
std::string format_project(const Project& project, const std::string& file);

/// A project of one material and the spectra that it uses, for files of single materials. The comparison is
/// left out.
Project single(const Project& project, const ProjectMaterial& material);

/// The library with the project's own spectra added. A spectrum replaces the material of the same id.
MaterialLibrary library_of(const Project& project, const MaterialLibrary& library);

/// The options by which the F0 of `measured` is computed. Throws Error where `outside` is no medium.
F0Options f0_options(const MeasuredF0& measured, const MaterialLibrary& library);

/// A computed F0, with the material and dataset that it comes from.
struct FoundF0 : FoundDataset {
  F0Result result;
};
/// Computes the F0 of `measured`. Throws Error where the material, dataset or outside medium is not found,
/// and where the data give no F0.
FoundF0 find_f0(const MeasuredF0& measured, const MaterialLibrary& library);

/// Computes the colours of all measured materials: F0, and for materials of class "surface" the diffuse
/// colour, which is the measured total less the material's own specular colour (lowered where the total is
/// darker: divided() in core/material/appearance.h). A material whose F0 cannot be computed keeps its colours
/// and loses `measured`. Returns the reasons for that, "NAME: ...".
std::vector<std::string> resolve(Project& project, const MaterialLibrary& library);
/// Sets the colours of one material from its record, as resolve() does.
void take_measured(ProjectMaterial& material, const FoundF0& found);
/// The text of the layers that make the F0 of a material, as a record has them; empty: its surface is bare, its F0 is
/// typed or of a texture, or the record is not found.
std::string text_of_layers(const ProjectMaterial& material, const MaterialLibrary& library);

/// Notes on a measured material: that its body is clear and not drawn, how a total reflectance was divided, how far the
/// drawn F of layers is off, that its roughness is a convention. One sentence a line; empty where there is nothing to note.
std::string body_note(const ProjectMaterial& material, const FoundF0& found, const MaterialLibrary& library);

/// The values of a material that a renderer needs. F82, n and k come from the spectrum where the material is
/// measured, else from F0. Textures are ignored. Throws Error as find_f0() does.
SurfaceValues surface_of(const ProjectMaterial& material, const MaterialLibrary& library);

/// Sets what of a surface does not depend on F0: diffuse colour, gloss, opacity, emission and occlusion.
void take_numbers(const ProjectMaterial& material, SurfaceValues& surface);

/// The material for export to another program. F82 is that of the record where F0 is measured, and unknown
/// where F0 was typed. Throws Error as find_f0() does.
ExportSurface export_surface(const ProjectMaterial& material, const MaterialLibrary& library);

/// The project as a manifest for the packer, materials in the order of their names. Colours outside of [0, 1]
/// are clamped.
///   remarks   gets a line for each colour that was clamped and for each F0 that could not be computed
AtlasManifest manifest_of(const Project& project, const MaterialLibrary& library,
                          std::vector<std::string>& remarks);

/// The first of "gold", "gold 2", "gold 3", ... that no material of the project has, where "gold" is wanted.
/// The end of `wanted` is left out where the name would be longer than most_name_bytes
/// (core/material/limits.h).
std::string free_name(const Project& project, const std::string& wanted);
/// A project's names, for several free ones: each name that free_name() returns is taken from then on.
FreeNames names_of(const Project& project);
std::string free_name(FreeNames& names, const std::string& wanted);

/// Whether a JSON text names the schema of projects in its first 4 KiB.
bool is_project(std::string_view text);

}  // namespace etak
