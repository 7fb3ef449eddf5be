// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/render/scene.h"

namespace etak {

/// Where a scene's object lies in its picture; the rules are those of struct Scene.
class Camera {
 public:
  explicit Camera(const Scene& scene);

  bool perspective() const { return perspective_; }
  Shape shape() const { return shape_; }
  double pixel() const { return pixel_; }        // side of a pixel, in radii of the sphere's silhouette
  double distance() const { return distance_; }  // of the camera from the origin; perspective only
  double spread() const { return spread_; }      // tangent of the silhouette's half-angle; perspective only
  double side() const { return side_; }          // half a side of the quad, as the camera sees it

  /// Place of a point of the picture: `column` and `row` count pixels from the left upper corner, a pixel's
  /// centre at halves.
  double x(double column) const { return (column - half_width_) * pixel_; }
  double y(double row) const { return (half_height_ - row) * pixel_; }

  /// Columns [first, last) of `row` that the object covers in part or whole.
  struct Span {
    int first, last;
  };
  Span covered(int row) const;

  /// Those of them that the object covers whole, and whose centre lies inside the silhouette's limit.
  Span whole(int row) const;

  /// Share of a pixel centred at x, y that the object covers.
  double coverage(double x, double y) const;

  /// Whether the ray through x, y meets the object (for supersampling).
  bool meets(double x, double y) const;

  /// The surface point behind x, y, drawn in to the silhouette, and the unit vector from there to the viewer.
  struct Sight {
    Vec3 position, viewer;
  };
  Sight sight(double x, double y) const;

 private:
  Shape shape_;
  bool perspective_;
  int width_;
  double pixel_, half_width_, half_height_;
  double distance_ = 0, spread_ = 0, side_ = 1;
};

/// Pixels at the edge are shaded where the silhouette is this far from the centre, so that the normal stays
/// in front.
inline constexpr double silhouette_limit = 0.9999;

}  // namespace etak
