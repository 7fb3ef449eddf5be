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

class FreeNames;  // core/base/free_names.h

// Materials under work, as an author saves them (resources/schema/project.schema.json). What is packed of
// them is an AtlasManifest, so that `etak pack` takes a project where it takes a manifest.

/// Where an F0 was measured.
///   material   id of the library or of the project's own spectra
///   dataset    empty: the preferred one
///   outside    the medium in front, as outside_medium() takes it: "1.33", "water", "water/hale"; empty:
///              vacuum
struct MeasuredF0 {
  std::string material, dataset, outside;
  Viewing viewing;
  friend bool operator==(const MeasuredF0&, const MeasuredF0&) = default;
};

/// What a texture can stand for.
enum class Channel { diffuse, specular, gloss, alpha };
inline constexpr std::array all_channels{Channel::diffuse, Channel::specular, Channel::gloss, Channel::alpha};
std::string_view name(Channel channel);  // "diffuse", ...

/// One material of a project. A texture stands in the place of the number of its channel when the project is
/// packed.
///   specular    linear sRGB, not clipped: of `measured` where that is set, whatever the file holds
///   parameters  of the models in use, by name, where they are not what the surface says: {"m", 0.3}
struct ProjectMaterial {
  std::string name;  // one of a kind in the project
  LinearRgb diffuse{0, 0, 0}, specular{0.04, 0.04, 0.04};
  Gloss gloss = 0.75;  // Schueler's, or a perceptual roughness
  double alpha = 1;
  std::optional<MeasuredF0> measured;
  std::array<std::optional<ImageSource>, all_channels.size()> textures;
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

/// Two sides in one picture.
///   pinned   what side B shows, as it was when it was pinned; none: the material in hand
///   model    specular model of side B; empty: the material's own
struct Comparison {
  bool on = false;
  std::optional<ProjectMaterial> pinned;
  std::string model;
  friend bool operator==(const Comparison&, const Comparison&) = default;
};

/// A strip of spheres over a parameter.
struct Wedge {
  static constexpr int least_steps = 2, most_steps = 16;
  bool on = false;
  std::string parameter = "gloss";
  int steps = 7;
  friend bool operator==(const Wedge&, const Wedge&) = default;
};

/// How the materials are looked at.
///   exposure                linear factor
///   config, display, view   of OpenColorIO; all empty: the tone curve and sRGB
struct ProjectView {
  Shape shape = Shape::sphere;
  LightSetup lights = studio_lights();
  double environment_turn_deg = 0;
  double exposure = 1;
  std::string config, display, view;
  Tone tone = Tone::plain;
  Comparison compare;
  Wedge wedge;
  friend bool operator==(const ProjectView&, const ProjectView&) = default;
};

struct Project {
  std::vector<ProjectMaterial> materials;
  std::vector<Material> spectra;  // imported: found before those of the library
  ProjectView view;
  friend bool operator==(const Project&, const Project&) = default;

  const ProjectMaterial* find(std::string_view material) const;
};

/// Reads a project. Picture files come out relative to the working folder, as parse_manifest() has it;
/// `specular` of measured materials is what it was when the file was written: resolve() brings it up to date.
/// Throws Error with the JSON pointer.
Project parse_project(std::string_view text, const std::string& file);

/// The file's text: a material a line or few, numbers that read back equal.
///   file   path that the text is to be saved under: pictures below its folder are named relative to it,
///          others by absolute paths. Empty: all by absolute paths, for a copy that may be read from anywhere
std::string format_project(const Project& project, const std::string& file);

/// One material with the spectra it uses, as a project of its own; for files of single materials. What it was
/// compared with stays behind.
Project single(const Project& project, const ProjectMaterial& material);

/// The library with the project's own spectra laid over it.
MaterialLibrary library_of(const Project& project, const MaterialLibrary& library);

/// Options under which `measured` asks for its F0. Throws Error for an outside medium that is none.
F0Options f0_options(const MeasuredF0& measured, const MaterialLibrary& library);

/// A measured F0 with the record it comes from. Throws Error naming what is missing, and for a refused
/// result.
struct FoundF0 : FoundDataset {
  F0Result result;
};
FoundF0 find_f0(const MeasuredF0& measured, const MaterialLibrary& library);

/// Sets the measured colours: F0, and for materials of class "surface" the diffuse colour, which is the
/// measured total less the material's own specular colour (lowered where the total is darker: divided() in
/// core/material/appearance.h). What cannot be found keeps its colour and loses `measured`; returned are the
/// reasons, "NAME: ...".
std::vector<std::string> resolve(Project& project, const MaterialLibrary& library);
void take_measured(ProjectMaterial& material, const FoundF0& found);
/// What a person should know of a measured material: that its body is clear and not drawn, how a total
/// reflectance was divided, that its roughness is a convention. One sentence a line; empty: nothing.
std::string body_note(const ProjectMaterial& material, const FoundF0& found);

/// What a renderer needs of a material: its numbers, F82 and n, k of the spectrum where it is measured and of
/// F0 where it is not. Textures play no part.
SurfaceValues surface_of(const ProjectMaterial& material, const MaterialLibrary& library);

/// The material for another program: its record's edge where F0 is measured, none where it is typed. Throws
/// Error.
ExportSurface export_surface(const ProjectMaterial& material, const MaterialLibrary& library);

/// What is packed. Colours outside of [0, 1] are brought there; `remarks` tells which.
AtlasManifest manifest_of(const Project& project, const MaterialLibrary& library,
                          std::vector<std::string>& remarks);

/// A name that no material of the project has: "gold", "gold 2", ... Its end is left out where it would be
/// longer than a project may hold (limits.h).
std::string free_name(const Project& project, const std::string& wanted);
/// The same for many names, which are taken as they are given out.
FreeNames names_of(const Project& project);
std::string free_name(FreeNames& names, const std::string& wanted);

/// Whether a JSON text says it is a project.
bool is_project(std::string_view text);

}  // namespace etak
