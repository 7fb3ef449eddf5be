// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/render/scene.h"

namespace etak {

/// Pictures in a grid of cells as large as the largest of them, with the labels of the columns above, those of
/// the rows on the left, and grey around them.
struct Sheet {
  std::vector<std::string> columns, rows;
  std::vector<Image> pictures;  // three or four channels, row by row; an empty one leaves its place grey
};

/// How far a picture is from a reference, pixel by pixel.
///   map       three channels, linear: CIEDE2000 of each pixel, from black (0) over violet and orange to a pale
///             yellow (10 and more); grey where the object does not cover the pixel as a whole
///   mean_de   over the pixels that the object covers as a whole; 0 where there is none
///   max_de    the largest of these
struct DifferencePicture {
  Image map;
  double mean_de = 0, max_de = 0;
};
/// The colour of a CIEDE2000 in the map, linear, and the value from which on it is the last one.
Vec3 difference_color(double de);
inline constexpr double largest_shown_de = 10;

/// Both pictures in the form of render_cpu() and of the same size; their colours are taken as an sRGB display
/// shows them: times `exposure`, through `tone`, clamped to [0, 1].
DifferencePicture difference_picture(const Image& reference, const Image& picture, double exposure,
                                     Tone tone = Tone::plain);

/// `picture` with `map` at its right and the mean difference written into the map.
Image beside(const Image& picture, const DifferencePicture& difference);

/// Draws the sheet as one picture of three channels in linear light.
Image laid_out(const Sheet& sheet);

}  // namespace etak
