// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/color/colorspace.h"
#include "core/color/gloss.h"
#include "core/material/material.h"

namespace etak {

// What a dataset says of a material beyond its reflectance at normal incidence, and the conventions for what
// no dataset says: whether a body of it is clear, how rough its surface is, and how a total reflectance
// divides into body and surface.

/// Whether light goes through a body of a material.
///   clear     a dielectric through `clear_depth_m` of which at least half of daylight (Y under D65) passes
///             by its k; one whose dataset has no k over half of the visible weight. Its colour then is by
///             the least absorbing k of the material's other datasets, where that lets half pass too (films
///             absorb more than bodies). Conductors, semiconductors, `surface` data, dielectrics of which
///             only the reflectance is known, and bodies of which the material says why not (Material::bodies), are not.
///   reason    why it is or is not, for people
///   body      of a clear one
///   k_of      the dataset by whose k a clear body has its colour, one of those of the material; null: there is no k
struct Clarity {
  bool clear = false;
  std::string reason;
  ClearBody body;
  const Dataset* k_of = nullptr;
};
inline constexpr double clear_depth_m = 1e-3;
Clarity clarity(const Material& material, const Dataset& dataset, RgbSpace space = RgbSpace::srgb);

/// The body of a material whose dataset says that it is clear.
std::optional<ClearBody> clear_body(const Material& material, const Dataset& dataset,
                                    RgbSpace space = RgbSpace::srgb);

/// A clear body in one line: "n_d 1.4585, V_d 67.8; linear 0.999 1 0.998 through 1 m".
std::string clear_body_text(const ClearBody& body);

/// The remark about a dielectric's body that is not clear and has no diffuse colour.
std::string black_body_remark(const Clarity& body);

/// Whether a surface shows a clear body: the material has one, and no diffuse colour was put into it.
bool is_clear_body(const Material& material, const Dataset& dataset, const LinearRgb& diffuse);

/// The roughness of a surface where none is given: a convention by the class of the material, and by its group
/// where the class is "surface". No measurement that could be cited was found.
///   reason   "the default of class surface, a convention, no measurement"
struct DefaultGloss {
  Gloss gloss;
  std::string reason;
};
///   clear_body   the body is clear and nothing was put into it: the surface is smooth, whatever its class
DefaultGloss default_gloss(const Material& material, bool clear_body);

/// The remark about a roughness that was not given: "roughness 0.9 (gloss 0.00567): the default of ...".
std::string default_gloss_remark(const DefaultGloss& standard);

/// F0 of the surface over a body of which only the total is known: that of most dielectrics.
inline constexpr double assumed_f0 = 0.04;

/// The total reflectance of a rough body, as integrating spheres measure it, divided into what its surface
/// reflects and what its body sends back: total = f0 + diffuse at normal incidence, channel by channel. A
/// saturated colour has channels that are darker than its surface, or below 0, because a channel of RGB is no
/// band of the spectrum: F0 stays there, diffuse is black, and both are more than the total.
///   diffuse   at least 0, or the channel of the total where that is below 0
///   f0        `wanted`, scaled down as a whole where the total is darker by the mean of its channels
struct TotalReflectance {
  LinearRgb diffuse, f0;
  bool lowered = false;  // f0 is below what was wanted
};
///   total    linear, as measured
///   wanted   F0 of the surface
TotalReflectance divided(const LinearRgb& total,
                         const LinearRgb& wanted = {assumed_f0, assumed_f0, assumed_f0});

/// The remark about a total that was divided with the assumed surface.
///   parts   of divided(); `lowered` is not looked at
std::string total_reflectance_remark(const TotalReflectance& parts);

}  // namespace etak
