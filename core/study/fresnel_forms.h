// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "core/fresnel/curve.h"
#include "core/material/f0.h"
#include "core/material/material.h"
#include "core/material/seen_stack.h"
#include "core/math/mat3.h"

namespace etak {

/// The exact F over the angle of incidence as it is seen: F of every nanometre and angle, summed to linear
/// sRGB, unclipped.
struct FresnelTruth {
  std::vector<double> cosine;  // of incidence
  std::vector<double> weight;  // in the mean over a sphere that is seen from far away, 2 c dc; their sum is 1
  std::vector<Vec3> rgb;
  Vec3 f0{}, f82{};  // at cos 1 and 1/7
  // Indices, which a stack of layers does not have.
  std::array<Vec3, 2> mean_index{};         // n and k averaged over the spectrum as reflectances are
  std::array<Vec3, 2> three_wavelengths{};  // n and k at 611.4, 549.1 and 464.3 nm, as sRGB's primaries
};

/// F at angles from 0 to 90 degrees in steps of `step_deg`, without an index.
///   seen   F at a cosine, linear sRGB
FresnelTruth fresnel_truth(const std::function<Vec3(double cosine)>& seen, double step_deg);

/// The truth at angles from 0 to 90 degrees in steps of `step_deg`. Throws Error (naming `what`) as
/// SeenStack does.
///   seen   observer, illuminant and outside medium are used; space and method are not
FresnelTruth fresnel_truth(const Optics& optics, std::string_view what, double step_deg = 0.25,
                           const F0Options& seen = {});

/// The numbers of a form, as a renderer gives them to it: those of a curve, four at most of the others.
inline constexpr std::size_t most_form_numbers = FresnelCurve::count;
using ChannelValues = std::array<double, most_form_numbers>;
using FresnelValues = std::array<ChannelValues, 3>;
/// The values of one channel in float, as FresnelForm::many takes them.
std::array<float, most_form_numbers> single_values(const ChannelValues& values);

/// A form of Fresnel reflectance that a shader can have.
struct FresnelForm {
  std::string_view id, title;
  bool physical;  // true: can be chosen; false: for comparison only
  /// The numbers of a truth.
  FresnelValues (*fit)(const FresnelTruth& truth);
  /// F for the numbers of one channel and a cosine of incidence, in double.
  double (*value)(const double* p, double c);
  /// F for `count` cosines in float and single_values(), for timing. It is compiled from the formula text that shaders get.
  void (*many)(const float* p, const float* c, float* out, std::size_t count);
};
std::span<const FresnelForm> fresnel_forms();
/// The form of that id; null: none.
const FresnelForm* fresnel_form(std::string_view id);

/// The errors of a form with its numbers, over the angles of a truth.
struct FresnelError {
  double max_abs = 0;              // over angles and channels
  double mean_abs = 0;             // weighted mean of the channel where it is largest
  double max_de = 0, mean_de = 0;  // CIEDE2000 of the colours, D65
  double at_deg = 0;               // the angle of max_abs
};
FresnelError fresnel_error(const FresnelTruth& truth, const FresnelForm& form, const FresnelValues& values);

}  // namespace etak
