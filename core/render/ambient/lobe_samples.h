// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/brdf/models.h"
#include "core/image/image.h"

namespace etak {

/// The lobe of a model as refined pictures sample it, for each view: half vectors, each of which stands for a cell of
/// the lobe, is the mean of the cell, and sees the light through a round lobe as wide as the cell. So the sum has the lobe's
/// own mean and width for any number of samples, and a constant surrounding is seen as it is.
/// Based on: Krivanek and Colbert 2008, "Real-time Shading with Filtered Importance Sampling".
///   picture   four channels. The column i < count is a half vector, of any length, in the frame whose x lies in
///             the plane of normal and viewer, and the level of its round lobe (round_lobe.h); the column
///             count + i is its share of the light, for red, green and blue; the last column is the albedo. A row for each view, at even steps
///             of sqrt(nv) from 0 to 1, so often as there are `rows` of glosses from 0 to 1 or of azimuths
struct LobeSamples {
  int count = 0, views = 64, rows = 1;
  Image picture;
  bool by_azimuth = false;   // rows are azimuths of the viewer from the tangent, evenly from 0 to below pi
  std::vector<int> sectors;  // cells in each ring of half vectors, the same in all rows
  bool wide = false;         // the lobe is so wide that it sees what is bright as lights: see light_samples.h
  bool empty() const { return picture.values.empty(); }
};
/// The levels that samples have: below 0 they are narrower than the round lobe of gloss 1.
inline constexpr double sharpest_sample = -2, dullest_sample = 8;

/// Computes one row of glosses or azimuths.
///   values    of the model, with a black body
///   grey      the share of all channels is that of green
///   azimuth   of the viewer from the tangent, radians
void set_lobe_samples(const Model& model, const std::vector<double>& values, bool grey, double azimuth,
                      int row, LobeSamples& out);

}  // namespace etak
