// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/exchange/export_surface.h"

namespace etak {

// A surface as the fields that a program's material editor shows, ready to be typed or pasted.
//
// Based on: Karis 2013, "Real Shading in Unreal Engine 4" (Specular = F0 / 0.08); Guy and Agopian,
// "Physically Based Rendering in Filament" (reflectance); Khronos Group, glTF 2.0 with KHR_materials_ior,
// KHR_materials_specular and KHR_materials_pbrSpecularGlossiness; Academy Software Foundation, OpenPBR 1.1;
// Kutz et al. 2021 (F82 tint); Gulbrandsen 2014. Unity and Blender as their programs behave.

/// A program or format that values are written for.
///   version    of the program, format or formula that the values are for
///   formula    the published F over the angle by which the error of the values is computed; empty: there is none, and
///              `unstated` says why
///   film_on_metal, film_on_dielectric   forms of core/iridescence; targets without are given F0 and F82 of the whole
///   opens, closes   of a text that is a document: what stands once before and behind all materials
///   comment         how a line begins that is a comment
///   has_coat   whether it draws a clear coat; others are given the whole of base and coat, and a note says so
struct EngineTarget {
  std::string_view id, title, version, formula = {}, unstated = {};
  bool has_coat = false;
  std::string_view film_on_metal = {}, film_on_dielectric = {};
  std::string_view opens = {}, closes = {}, comment = "# ";

  bool is_document() const { return !opens.empty(); }
  /// The form of its film; empty: it has none on that base.
  std::string_view film_form(SurfaceKind kind) const {
    return kind == SurfaceKind::metal ? film_on_metal : film_on_dielectric;
  }
};

/// In the order of targets/targets.inc.
std::span<const EngineTarget> engine_targets();
const EngineTarget* engine_target(std::string_view id);

/// One field of a target.
///   values   one or three numbers, as the target takes them: linear colours; 8-bit codes for hex and srgb8
///   text     what is typed or pasted: "#ffe49c", "vec3(1.0, 0.77, 0.33)", "(R=1.0,G=...)"
struct EngineField {
  std::string name;
  std::vector<double> values;
  std::string text;
  friend bool operator==(const EngineField&, const EngineField&) = default;
};

/// The film of a stack in a target: both sets of numbers as fields, their errors, which of them the target's fields are,
/// and why.
struct EngineFilm {
  /// One set of the film's numbers, as the target's fields.
  struct Side {
    std::vector<EngineField> fields;
    FilmError error;
    friend bool operator==(const Side&, const Side&) = default;
  };
  std::optional<Side> honest;  // none: the stack is more than one film
  Side fitted;
  bool use_honest = false;
  std::string advice;
  friend bool operator==(const EngineFilm&, const EngineFilm&) = default;
};

/// The values of a surface in a target, the values that it cannot hold, and notes for the user.
struct EngineValues {
  std::string_view target;  // id
  std::vector<EngineField> fields;
  std::optional<EngineFilm> film = {};  // of a stack, where the target has a film
  std::optional<FilmError> error =
      {};                    // of F over the angle, by the target's formula, to that of the exact material
  std::string error_reason;  // where there is no error: why
  Changes changes;
  std::vector<std::string> notes;
  std::string choice =
      {};  // of targets with several forms of F: the one that the fields are for, as the program names it
  std::string body = {};  // of targets whose text is more than their fields: the text of this material
  friend bool operator==(const EngineValues&, const EngineValues&) = default;
};

/// The fields of `surface` in a target. Targets without an edge colour report the edge of Schlick's curve.
///   surface   valid, linear sRGB (throws Error otherwise)
EngineValues engine_values(const EngineTarget& target, const ExportSurface& surface, Fit fit = Fit::clamp);

/// What goes to the clipboard: the whole document of one material; constants of a language; the text of the only field; else
/// "name: text" a line.
std::string copy_text(const EngineValues& values);
/// The same without what opens and closes a document.
std::string body_text(const EngineValues& values);

// The values of two of the targets, for those who write them into files.

/// The largest F0 that a dielectric keeps where it is told by its index: that of 1 is infinite.
inline constexpr double largest_dielectric_f0 = 0.99;

/// The diffuse colour of a dielectric for targets that take the reflectance at normal incidence off it
/// (OpenPBR, Blender): a measured total is divided so that it comes out; typed colours are passed on as they
/// are.
LinearRgb layered_diffuse(const ExportSurface& surface);

/// Surface parameters of OpenPBR 1.1; what is not here stays at its default.
struct OpenPbrValues {
  double base_metalness = 0;
  LinearRgb base_color, specular_color{1, 1, 1};  // of a metal: F0 and F82 tint
  double specular_ior = 1.5, specular_roughness = 0.3, geometry_opacity = 1;
  double transmission_weight = 0, transmission_depth = 0;  // 1 and metres, of a clear body
  LinearRgb transmission_color{1, 1, 1};                   // over that depth
  // Of a coat, which is smooth. base_color and specular_color of a metal are those with which MaterialX's graph, which
  // takes a metal's F under a coat as it is in air, gives the whole. The index of a dielectric stays that in air: the
  // target compares it with the coat's itself.
  double coat_weight = 0, coat_ior = 1.6;
  double coat_darkening = 1;  // 0 but of a diffuse body: the graph darkens a smooth base as if it were one
  LinearRgb coat_color{1, 1, 1};  // what the coat lets pass, down and up
  double thin_film_weight = 0, thin_film_thickness = 0.5, thin_film_ior = 1.4;  // of a stack; thickness in um
  friend bool operator==(const OpenPbrValues&, const OpenPbrValues&) = default;
};
/// Calls add(name, number or colour) for the inputs of what lies in or on a surface, where it has that: transmission, coat
/// and film.
template <class Add>
void open_pbr_layers(const OpenPbrValues& v, const Add& add) {
  if (v.transmission_weight > 0) {
    add("transmission_weight", v.transmission_weight);
    add("transmission_color", v.transmission_color);
    add("transmission_depth", v.transmission_depth);
  }
  if (v.coat_weight > 0) {
    add("coat_weight", v.coat_weight);
    add("coat_color", v.coat_color);
    add("coat_roughness", 0.0);
    add("coat_ior", v.coat_ior);
    add("coat_darkening", v.coat_darkening);
  }
  if (v.thin_film_weight > 0) {
    add("thin_film_weight", v.thin_film_weight);
    add("thin_film_thickness", v.thin_film_thickness);
    add("thin_film_ior", v.thin_film_ior);
  }
}

/// In the surface's own space. OpenPBR has one index for a dielectric: it is that of the luminance of F0
/// unless F0 is so coloured that a tint (specular_color, which also tints the rim) misses less on average
/// over a sphere; of a clear body always.
OpenPbrValues open_pbr_values(const ExportSurface& surface, Fit fit, Changes& changes);

/// A glTF 2.0 material. A clear body is white, because transmitted light is tinted by the base colour. Its
/// shaders take a dielectric's reflectance off the diffuse colour, so that is divided by 1 - max F0 here.
struct GltfMaterialValues {
  LinearRgb base_color;  // of metal-rough; diffuseFactor of specular-glossiness
  double metallic = 0, roughness = 1, opacity = 1;
  double ior = 1.5;                   // KHR_materials_ior
  LinearRgb specular_color{1, 1, 1};  // KHR_materials_specular; F0 for specular-glossiness
  double glossiness = 0;              // 1 - roughness
  double transmission = 0;  // KHR_materials_transmission: 1 of a clear body, not of specular-glossiness
  std::optional<ClearBody> volume;  // KHR_materials_volume of it
  double dispersion = 0;            // KHR_materials_dispersion of it: 20 / V_d; 0 where that is not known
  bool specular_glossiness = false;
  double iridescence = 0, iridescence_ior = 1.3, iridescence_nm = 0;  // KHR_materials_iridescence, of a stack
  double clearcoat =
      0;  // KHR_materials_clearcoat: 1 over a base that gives the whole below its coat of index 1.5
  friend bool operator==(const GltfMaterialValues&, const GltfMaterialValues&) = default;
};
GltfMaterialValues gltf_values(const ExportSurface& surface, bool specular_glossiness, Fit fit,
                               Changes& changes);

}  // namespace etak
