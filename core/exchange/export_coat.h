// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/exchange/export_surface.h"

namespace etak {

// A coat in the terms of a target. Targets that have one draw coat + passes (1 - coat) base, each term at the angle
// outside: glTF's fresnel_coat(), the layers of MaterialX and of Blender's Principled. None of them changes a metal's F by
// the coat's index or adds what goes up and down below it. So the base is given the F0 and F82 with which their sum is
// the whole, exactly at cosine 1 and 1/7, and neither is counted twice.

/// The coat that a target draws. As it stands: that of glTF and Filament, F0 0.04 with Schlick's edge, without absorption.
///   n               reflects by Fresnel's equations of this index; 0: by F0 0.04 and `curve`
///   passes          the share of the light that goes in which it lets pass, head on
///   longer_aslant   whether the target takes that to the power of the path in the coat (Blender, Adobe's OpenPBR); else it
///                   is the same at all angles (MaterialX)
///   curve           from F0 to 1 over the cosine; null: Schlick's
struct TargetCoat {
  double n = 0;
  LinearRgb passes{1, 1, 1};
  bool longer_aslant = false;
  double (*curve)(double cosine) = nullptr;

  double reflects(double cosine) const;
  Vec3 lets_pass(double cosine) const;
  /// The light that is seen of a base of that reflectance through the coat, at that cosine.
  Vec3 over(const Vec3& base, double cosine) const;
};

/// Adds the Change of a coat that has another index than 1.5.
void note_fixed_coat(const CoatedF0& coat, Changes& changes);

/// `surface` without its coat, F0 and F82 being those of a base that is the whole under the target's coat: per channel
/// (whole - coat) / (passes (1 - coat)). A surface without a coat is returned as it is.
ExportSurface under_coat(const ExportSurface& surface, const TargetCoat& target);

/// `surface` without its coat, F0 and F82 being those of the whole: for targets that have none.
ExportSurface as_whole(const ExportSurface& surface);

}  // namespace etak
