// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/image/image.h"

namespace etak {

/// Pixels per degree of visual angle for which FLIP is published: 67.02, a display 0.7 m wide with 3840
/// pixels seen from 0.7 m.
inline constexpr double flip_pixels_per_degree = 3840 * 3.14159265358979323846 / 180;

/// A picture as an eye sees it from a distance, prepared for flip(). Each plane has width x height values,
/// rows from the top.
struct FlipView {
  int width = 0, height = 0;
  double pixels_per_degree = flip_pixels_per_degree;
  // L*, a* and b* of the blurred picture; a* and b* are multiplied by L* / 100 (the Hunt effect: dark colours
  // look less colourful).
  std::vector<double> l, a, b;
  // Strength of edges and of points, found in the picture before it is blurred.
  std::vector<double> edges, points;
};

/// Prepares a picture for flip(). Throws Error for pictures with fewer than three channels and for
/// pixels_per_degree outside of 1 to 1000.
///   picture   the first three channels are read, as linear light with sRGB's primaries, and clamped to
///             [0, 1] as a display clamps them; NaN counts as 0
FlipView flip_view(const Image& picture, double pixels_per_degree = flip_pixels_per_degree);
/// A view of a picture of sRGB codes.
FlipView flip_view(const Image8& codes, double pixels_per_degree = flip_pixels_per_degree);

/// The difference that a person sees when two pictures alternate in one place.
struct FlipError {
  std::vector<double> map;  // [0, 1] per pixel, rows from the top
  double mean = 0;
};

/// FLIP for pictures on a display (not its HDR form): 0 where nothing differs, and symmetric in its
/// arguments. For two pictures of one uniform colour each, green against blue gives 1 (the largest distance
/// that FLIP knows) and black against white gives 0.967.
///   error   arithmetic in double; filters end at 3 standard deviations, as published
///   from    Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astroem and Fairchild 2020, "FLIP: A Difference
///           Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), article 15:
///           the colour pipeline (contrast sensitivity as sums of Gaussians in YCxCz, table 1; CIELAB with
///           Hunt's effect; HyAB to the power 0.7, then two straight parts that meet at 0.4 of the largest
///           difference and 0.95), the feature pipeline (edges and points by derivatives of a Gaussian 0.082
///           degrees wide, power 0.5), and their combination dEc^(1 - dEf)
/// Throws Error for views of different size or distance.
FlipError flip(const FlipView& reference, const FlipView& test);

/// The contrast sensitivity of one channel of YCxCz as a filter: a1 sqrt(pi / b1) exp(-pi^2 d^2 / b1), plus
/// the same term with a2 and b2, at d degrees from the centre. The filter is normalised to sum to 1 over the
/// pixels.
struct FlipSensitivity {
  double a1, b1, a2, b2;
};
inline constexpr FlipSensitivity flip_achromatic{1, 0.0047, 0, 1e-5};
inline constexpr FlipSensitivity flip_red_green{1, 0.0053, 0, 1e-5};
inline constexpr FlipSensitivity flip_blue_yellow{34.1, 0.04, 13.5, 0.025};

}  // namespace etak
