// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include "core/film/stack.h"
#include "core/material/f0.h"
#include "core/material/material.h"

namespace etak {

/// The exact F of n and k or of a stack over the angle of incidence, as it is seen: F of every wavelength, summed to linear
/// sRGB.
class SeenStack {
 public:
  /// Throws Error (naming the stack, else `what`) for media without n, and as F0Solver does.
  ///   optics    no reflectance at normal incidence alone
  ///   options   all are used but space and method
  ///   sum       nm1, nm5, nm10 or nm20: the wavelengths that are summed
  explicit SeenStack(const Optics& optics, F0Options options = {}, Method sum = Method::nm1,
                     std::string_view what = "spectral Fresnel");
  ~SeenStack();
  SeenStack(SeenStack&&) noexcept;

  /// Linear sRGB, unclipped.
  ///   cosine   of incidence, [0, 1]
  Vec3 operator()(double cosine) const;

  /// What is seen of D65, or the light of the options, through two such surfaces of a clear body, linear sRGB: the colour of
  /// the squared transmittance into the base, s and p by themselves. What the body absorbs is left out.
  ///   cosine   of incidence outside, (0, 1]
  Vec3 passed_twice(double cosine) const;

  /// Linear sRGB of values at the wavelengths.
  Vec3 seen(std::span<const double> values) const;

  /// n and k against the outside medium at the wavelengths; empty of a stack with layers.
  FilmSpectra::Medium bare_index() const;

  /// The values that are summed: the wavelengths, the media's n and k at each.
  const FilmSpectra& spectra() const;

  /// Gives a layer another thickness; it stays coherent or incoherent.
  ///   layer   index, the outermost being 0
  void set_thickness(std::size_t layer, double thickness_nm);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace etak
