// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/math/functions.h"

namespace etak {

// How rough a surface is: Schueler's gloss, perceptual roughness and the width of the lobe, and the one way
// from each to the others.
//
// Based on: Schueler 2009, "Simplifying the Cook-Torrance model" (gloss g, exponent e = 2^(12 g)); Walter et
// al. 2007 (alpha = sqrt(2 / (e + 2)) matches the lobe of Blinn and Phong to that of Beckmann and GGX);
// Burley 2012 (alpha = roughness^2).

/// Exponent of Schueler's lobe: e = 2^(12 gloss), 1 to 4096. core/brdf/gloss.glsl has this and
/// alpha_of_exponent() for shaders.
template <std::floating_point Real>
Real exponent_of_gloss(Real gloss) {
  return math::exp2(12 * gloss);
}
template <std::floating_point Real>
Real gloss_of_exponent(Real exponent) {
  return math::log2(exponent) / 12;
}

/// Width of the lobe for GGX or Beckmann, alpha = sqrt(2 / (e + 2)), and back.
template <std::floating_point Real>
Real alpha_of_exponent(Real exponent) {
  return std::sqrt(2 / (exponent + 2));
}
template <std::floating_point Real>
Real exponent_of_alpha(Real alpha) {
  return 2 / (alpha * alpha) - 2;
}
template <std::floating_point Real>
Real alpha_of_gloss(Real gloss) {
  return alpha_of_exponent(exponent_of_gloss(gloss));
}

/// The variance of the lobe, 1 / e, as which gloss is averaged; and back.
template <std::floating_point Real>
Real variance_of_gloss(Real gloss) {
  return math::exp2(-12 * gloss);
}
template <std::floating_point Real>
Real gloss_of_variance(Real variance) {
  return -math::log2(variance) / 12;
}

/// Perceptual roughness sqrt(alpha), 0.904 for gloss 0 to 0.149 for gloss 1: not 1 - gloss.
double roughness_of_gloss(double gloss);
/// Gloss of a roughness: log2(2 / roughness^4 - 2) / 12, not clamped; infinite for 0, minus infinity for 1.
///   roughness   perceptual, [0, 1]
double gloss_of_roughness(double roughness);

/// How rough a surface is, as one number that was given: Schueler's gloss or perceptual roughness. It reads
/// as the gloss, because that is what most models take; a roughness between 0 and 0.149 or between 0.904 and
/// 1 has no gloss in [0, 1], reads as the nearest end and still gives its own width to what takes one.
class Gloss {
 public:
  constexpr Gloss(double gloss) : gloss_(gloss) {}  // NOLINT: a gloss is a number
  /// Perceptual roughness, [0, 1]; 0 is a mirror.
  static Gloss of_roughness(double roughness);

  constexpr operator double() const { return gloss_; }  // NOLINT: likewise

  double roughness() const;  // exactly the one given where it was
  double alpha() const;      // roughness^2
  double exponent() const;   // 2 / alpha^2 - 2: infinite for roughness 0, 0 for roughness 1
  /// Where a roughness was given: it. None: a gloss was.
  const std::optional<double>& given_roughness() const { return roughness_; }
  /// A roughness was given that no gloss in [0, 1] has, so that the number read is the nearest end.
  bool held() const;

  friend bool operator==(const Gloss&, const Gloss&) = default;
  template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>>
  friend bool operator==(const Gloss& a, Number b) {
    return a.gloss_ == static_cast<double>(b);
  }

 private:
  double gloss_;
  std::optional<double> roughness_;
};

/// The gloss that a person gave as gloss or as roughness. None where neither was given: the default of the
/// material's class is then meant. Throws Error that names the setting where both are given, and for values
/// outside [0, 1].
std::optional<Gloss> given_gloss(std::optional<double> gloss, std::optional<double> roughness);

/// What the gloss channel of a texture holds.
///   schueler              g of exponent e = 2^(12 g)
///   one_minus_roughness   1 - perceptual roughness, as in Unity and KHR_materials_pbrSpecularGlossiness
///   roughness             perceptual roughness, alpha = roughness^2
enum class GlossForm { schueler, one_minus_roughness, roughness };
std::string_view name(GlossForm form);  // "schueler", "one_minus_roughness", "roughness"
std::optional<GlossForm> gloss_form_named(std::string_view text);

/// One form of gloss as another, both in [0, 1]. The result may leave [0, 1]: g of very smooth and very rough
/// surfaces.
///   from   e = 2 / alpha^2 - 2 (Beckmann width alpha = roughness^2 against Blinn-Phong's exponent), Walter
///          et al. 2007, Microfacet Models for Refraction; e = 2^(12 g) Schueler 2009
double converted_gloss(double value, GlossForm from, GlossForm to);

/// "roughness 0.25 (gloss 0.75)", or "roughness 0" where no gloss has it.
std::string roughness_text(const Gloss& gloss);

/// What is told where a model takes the gloss of a roughness that has none: "Schueler's gloss holds roughness
/// 0.149 to 0.904: ...". Empty where the gloss holds it.
std::string held_text(const Gloss& gloss);

}  // namespace etak
