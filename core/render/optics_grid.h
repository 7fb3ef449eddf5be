// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "core/material/seen_stack.h"

namespace etak {

/// n and k on the reference grid of 1 nm, 360..830 nm. Between samples they are linear, outside of the
/// samples they keep the end values, and a missing k is 0.
struct GridIndex {
  std::array<double, grid_size> n{}, k{};
};

/// The index on the grid. Throws Error that names `what` where n is negative or NaN, and where n is 0 and k
/// is not above 0.
GridIndex grid_index(const OpticalConstants& optics, std::string_view what);

/// The exact F of n and k or of a stack of layers at any angle, as it is seen: of every nanometre, summed.
class SeenFresnel {
 public:
  /// Throws Error (naming `what`) as grid_index() does, and as SeenStack does.
  ///   optics   no reflectance at normal incidence alone
  ///   seen     observer, illuminant and outside medium are used; space and method are not
  explicit SeenFresnel(const Optics& optics, std::string_view what = "spectral Fresnel",
                       const F0Options& seen = {});

  /// Linear sRGB, unclipped.
  ///   cosine   of incidence, [0, 1]
  Vec3 operator()(double cosine) const;

  /// Linear sRGB of reflectances on the grid.
  Vec3 rgb(std::span<const double> reflectance) const {
    return to_srgb_ * quadrature_.integrate(reflectance);
  }

  /// n and k against the outside medium; none of a stack.
  const std::optional<GridIndex>& index() const { return index_; }

 private:
  Quadrature quadrature_;
  Mat3 to_srgb_;
  std::optional<GridIndex> index_;
  std::optional<SeenStack> stack_;  // in place of the index
};

}  // namespace etak
