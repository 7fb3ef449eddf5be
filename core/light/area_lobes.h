// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/brdf/models.h"
#include "core/light/lights.h"

namespace etak {

/// A lobe as a sum of two cosines, for one direction of the viewer: a linearly transformed one and a plain one
/// (core/light/area.glsl says how they light a surface).
///   a, b, d, e   of the matrix (a 0 b, 0 1 0, d 0 e), which turns directions in the frame of normal +z and viewer
///                in the xz plane (x >= 0) into those of a cosine around +z
///   cosine       share of the plain cosine, (0, 1)
struct AreaLobe {
  double a, b, d, e, cosine;
};

/// The table that the lobes are interpolated in: rows of widths, columns of the viewer's cosine. It is fitted by
/// tests/bench/fit_area_lobes.cpp, and d and e are divided by alpha in it.
inline constexpr int area_lobe_rows = 12, area_lobe_columns = 16;
double area_lobe_alpha(int row);
double area_lobe_cosine(int column);

/// The lobe of a model for area lights.
///   family   row of fits: 0 GGX, 1 Beckmann, 2 Phong, 3 GGX of a small F0
///   alpha    its width, as alpha of that family
///   own      whether its distribution is that of the fit. Any other one is lit by the family that is nearest to it,
///            which costs accuracy where a light is large and the lobe narrow
struct AreaFit {
  int family;
  double alpha;
  bool own;
};
AreaFit area_fit(const Model& model, const std::vector<double>& values);
std::string_view area_family_name(int family);

/// The lobes of a model for every cosine of the viewer, with d and e divided by alpha as in the table.
///   rows   one; five, of gloss 0 to 1 in even steps, where the gloss is that of a texture
struct AreaTable {
  AreaFit fit;
  std::vector<std::array<AreaLobe, area_lobe_columns>> rows;

  ///   nv      cosine of the viewer; taken as 0 below 0
  ///   gloss   of the texel, where there are five rows
  AreaLobe at(double nv, double gloss = 0) const;
};
AreaTable area_table(const Model& model, const std::vector<double>& values, bool gloss_of_texture);

/// From the centre of an area light to the middle of an edge (rectangle) or to the rim (disc), as seen from its lit
/// side.
struct AreaAxes {
  Vec3 right, up;
};
AreaAxes area_axes(const Light& light);

/// The place on an area light for two numbers in [0, 1), evenly spread.
Vec3 area_place(const Light& light, double x, double y);

/// The density of area_place() over solid angle as seen from `position` in a direction, in 1/sr; 0 where the ray misses
/// the light or meets its dark side.
double area_density(const Light& light, const Vec3& position, const Vec3& direction);

/// How an area light is cut into pieces, each of which is lit as a whole. Every four points are a piece's corners, in
/// units of its axes. A rectangle has as many pieces as its size, seen from the object, asks for: 1 to 16. A disc is
/// eight sectors of a polygon of 16 sides and the disc's area.
using AreaCut = std::vector<std::array<double, 2>>;
AreaCut area_cut(const Light& light);

}  // namespace etak
