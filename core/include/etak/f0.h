// SPDX-License-Identifier: Apache-2.0
#pragma once

// From measured spectra to F0: the reflectance at normal incidence as a colour. Link etak::core.
//
// ```cpp
// #include <cstdio>
// #include <etak/f0.h>
//
// int main() {
//   // Wavelengths in nanometres, ascending; n and k of gold, at five of them.
//   const etak::OpticalConstants optics{
//       etak::Spectrum{{380, 480, 580, 680, 780}, {1.67, 1.27, 0.28, 0.13, 0.15}},
//       etak::Spectrum{{380, 480, 580, 680, 780}, {1.94, 1.85, 2.84, 3.96, 4.9}}};
//   etak::validate(std::get<etak::Spectrum>(optics.n), "n");
//
//   etak::F0Options options;                 // D65, CIE 1931 2-degree observer, vacuum outside
//   options.space = etak::RgbSpace::acescg;  // of f0.linear; f0.srgb8 is sRGB in any case
//   const etak::F0Result f0 = etak::F0Solver(options).solve(optics);
//   if (f0.refused()) {
//     std::puts(f0.refusal.c_str());
//     return 1;
//   }
//   std::printf("%s %.3f %.3f %.3f\n", etak::hex(f0.srgb8).c_str(), f0.linear.r, f0.linear.g,
//               f0.linear.b);
//   f0.flags.for_each([](etak::Flag flag) { std::puts(std::string(etak::meaning(flag)).c_str()); });
// }
// ```
//
// Units and ranges
//   wavelength   nanometres in vacuum. Data that hold less than 0.95 of the luminous weight are refused, not
//                extrapolated, unless F0Options::allow_extrapolation says so
//   n, k         n + ik with k >= 0, relative to vacuum; n by table or formula (DispersionFormula), k by
//                table or none. Reflectance in [0, 1] takes their place where that was measured (Reflectance)
//   F0Result     linear light, 1 for a perfect reflector, never clipped: gold's red is above 1 in sRGB.
//                srgb8 is clipped and rounded, and `flags` say so
//   f82          reflectance at cos = 1/7, for models that take the colour of the edge
//
// Errors
//   etak::Error        options that cannot be met, and spectra that validate() refuses; what() is one line
//   F0Result::refusal  doubtful data throw nothing: the result says why it holds no colour
//
// An F0Solver is built once and then shared between threads. Colours of an OpenColorIO config come from
// OcioConfig (link etak::ocio too). <etak/materials.h> has measured spectra.

#include "core/base/error.h"
#include "core/color/colorspace.h"
#include "core/color/delta_e.h"
#include "core/color/gamut.h"
#include "core/color/luminance.h"
#include "core/color/ocio.h"
#include "core/color/srgb.h"
#include "core/material/dispersion.h"
#include "core/material/f0.h"
#include "core/pages/f0/report.h"
#include "core/spectrum/integration.h"
#include "core/spectrum/interpolate.h"
#include "core/spectrum/spectrum.h"
