// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace etak {

/// What an input takes: one number, three of a colour, one or two of a roughness in two directions, or something that is
/// not judged (a vector, a text).
enum class InputType { number, color, pair, other };

/// What an input is to a surface.
///   tint              of a metal F82 over Schlick's curve, of a dielectric a factor of F0
///   edge_color        of a metal Gulbrandsen's edge colour, of a dielectric a factor of F0
///   specular_color    a factor of a dielectric's F0
///   takes_f0          a switch: F0 is stated, and the metalness does not count
///   film_um, film_nm  the thickness of a film, by its unit
enum class Meaning {
  none,
  base_weight,
  base_color,
  metalness,
  specular_weight,
  tint,
  edge_color,
  specular_color,
  ior,
  n,
  k,
  f0,
  f82,
  takes_f0,
  film_weight,
  film_um,
  film_nm,
  roughness,
  diffuse,
  transmission
};

/// An input of a model, with the least and the most number that the model's definition allows, and its default.
struct ModelInput {
  std::string_view model, name;
  InputType type = InputType::other;
  double least = 0, most = 1;
  Meaning meaning = Meaning::none;
  double otherwise = 0;
};

/// The input of that name; null: the model has none.
///   model   "open_pbr_surface", "standard_surface", "gltf_pbr", "UsdPreviewSurface", "conductor_bsdf", "dielectric_bsdf",
///           "generalized_schlick_bsdf", "gltf" (factors of a glTF material) or "values" (of the other targets of etak export)
const ModelInput* model_input(std::string_view model, std::string_view name);
/// The input of a model with that meaning; null: there is none.
const ModelInput* model_input(std::string_view model, Meaning meaning);

/// Whether there is a model of that id.
bool is_surface_model(std::string_view id);

/// The names of a model's inputs.
std::vector<std::string> input_names(std::string_view model);

}  // namespace etak
