// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/exchange/export_surface.h"
#include "core/material/f0_coat.h"

namespace etak {

// A coat in the terms of a target. Targets that have one draw coat + passes (1 - coat) base, each term at the angle
// outside: glTF's fresnel_coat(), the layers of MaterialX and of Blender's Principled. None of them changes a metal's F by
// the coat's index or adds what goes up and down below it. So the base is given the F0 and F82 with which their sum is
// the whole, exactly at cosine 1 and 1/7, and neither is counted twice.

/// The coat that a target draws: reflectance at cosine 1 and 1/7, and the share that it lets pass there of the light that
/// goes in.
struct TargetCoat {
  double f0 = 0.04, f82 = 0;
  LinearRgb passes{1, 1, 1}, passes82{1, 1, 1};
};

/// A coat of the index of `coat`, for targets that take one and the colour of its absorption.
///   longer_aslant   whether the target takes the colour to the power of the path in the coat (Blender); else it is
///                   the same at all angles (MaterialX)
TargetCoat target_coat(const ExportCoat& coat, bool longer_aslant);

/// A coat of the index 1.5 with Schlick's edge, without absorption: that of glTF and Filament.
TargetCoat fixed_coat();
/// Adds the Change of a coat that has another index than fixed_coat().
void note_fixed_coat(const ExportCoat& coat, Changes& changes);

/// The coat of `values` in the terms of exports.
ExportCoat export_coat(const Coat& coat, const CoatedF0& values);

/// `surface` without its coat, F0 and F82 being those of a base that is the whole under the target's coat: per channel
/// (whole - coat) / (passes (1 - coat)). A surface without a coat is returned as it is.
ExportSurface under_coat(const ExportSurface& surface, const TargetCoat& target);

/// `surface` without its coat, F0 and F82 being those of the whole: for targets that have none.
ExportSurface as_whole(const ExportSurface& surface);
/// What is to be told of as_whole().
std::string whole_note(const ExportCoat& coat);

}  // namespace etak
