// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/brdf/models.h"
#include "core/material/f0/f0_settings.h"
#include "core/render/scene.h"

namespace etak {

// Colours, surfaces and models as the words of a command line or a call have them.

/// The numbers of "0.9,0.5,0.1"; none where one of them is no number.
std::vector<double> typed_numbers(std::string_view text);

/// A linear colour as typed: "0.9" (grey), "0.9,0.5,0.1", or "#e5b45f", whose codes are sRGB. Throws Error.
///   place   names it in messages
LinearRgb typed_color(const std::string& place, std::string_view text);

/// A typed colour that is a share of light. Throws Error for a channel outside of 0 to 1.
LinearRgb typed_share(const std::string& place, std::string_view text);

/// What is asked of a surface.
///   diffuse   of dielectrics and of surfaces in numbers
///   gloss     none: the default of its class, with a remark
///   opacity   none: 1, and 0 of clear bodies
///   compute   how its F0 is computed
struct SurfaceWishes {
  Vec3 diffuse{0, 0, 0};
  std::optional<Gloss> gloss;
  std::optional<double> opacity;
  F0Settings compute;
};

/// A surface in numbers: "f0=0.04" or "f0=1,0.78,0.34", f82=, n=, k=, diffuse=, gloss=, roughness=, opacity=. Throws
/// Error.
SurfaceValues typed_surface(const std::vector<std::string>& words, const SurfaceWishes& wishes);

/// The surface of a material. Throws Error for data that give no F0.
///   options   those of wishes.compute
///   remarks   gets what is assumed about the body and its roughness
SurfaceValues surface_of(const Material& material, const Dataset& dataset, const SurfaceWishes& wishes,
                         const F0Options& options, std::vector<std::string>& remarks);

/// The names and values of the setting "set", "NAME=NUMBER". Throws Error.
std::vector<std::pair<std::string, double>> typed_set(const std::vector<std::string>& texts);

/// The model of this id; null: "none". Throws Error that names the option.
///   standard   the id that an empty one stands for
const Model* model_named(const std::string& option, const std::string& id, std::string_view standard);

/// The remark about F of a surface of layers.
///   asked, drawn   the model that was asked for and that of drawn_model()
///   values         of `drawn`
std::string layers_remark(const Model& asked, const Model& drawn, const std::vector<double>& values,
                          const FresnelCurve& curve);

/// The remark about a value that a model did not take as it is.
std::string clamped_remark(const ClampedValue& value);

}  // namespace etak
