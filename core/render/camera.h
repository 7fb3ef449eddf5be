// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/render/scene.h"

namespace etak {

/// Axes of a camera in the scene's space, as rows: right, up, towards the camera from the object.
Mat3 camera_axes(const View& view);

/// Where a scene's object lies in its picture; the rules are those of struct Scene.
class Camera {
 public:
  explicit Camera(const Scene& scene);

  bool perspective() const { return perspective_; }
  Shape shape() const { return shape_; }
  double pixel() const { return pixel_; }        // side of a pixel, in radii of the sphere's silhouette
  double distance() const { return distance_; }  // of the camera from the origin; perspective only
  double spread() const { return spread_; }      // tangent of the silhouette's half-angle; perspective only
  double side() const { return side_; }    // half a side of the quad, as the camera sees it from the front
  bool turned() const { return turned_; }  // the camera is not at the front
  const Mat3& axes() const { return axes_; }
  double centre_column() const { return centre_column_; }  // of x = 0, from the left
  double centre_row() const { return centre_row_; }        // of y = 0, from the top
  /// Of a turned quad: row 0 times (x, y, 1) over row 2 times (x, y, 1) is the place on it in x, row 1 that
  /// in y; row 2 gives above 0 where it is in front of the camera.
  const Mat3& plane() const { return plane_; }
  /// Side of the quad that is seen: 1 or -1.
  double facing() const { return axes_[2][2] < 0 ? -1 : 1; }

  /// Place of a point of the picture: `column` and `row` count pixels from the left upper corner, a pixel's
  /// centre at halves.
  double x(double column) const { return (column - centre_column_) * pixel_; }
  double y(double row) const { return (centre_row_ - row) * pixel_; }

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

  /// The surface point behind x, y, drawn in to the silhouette, its normal, and the unit vector from there to
  /// the viewer, all in the scene's space.
  struct Sight {
    Vec3 position, viewer, normal;
  };
  Sight sight(double x, double y) const;

 private:
  Vec3 out_of(const Vec3& seen) const;  // from the camera's axes to the scene's
  Vec3 on_plane(double x, double y) const;

  Shape shape_;
  bool perspective_, turned_ = false;
  int width_;
  double pixel_, centre_column_, centre_row_;
  double distance_ = 0, spread_ = 0, side_ = 1;
  Mat3 axes_ = identity3, plane_ = identity3;
};

/// Pixels at the edge are shaded where the silhouette is this far from the centre, so that the normal stays
/// in front.
inline constexpr double silhouette_limit = 0.9999;

/// A quad seen at less than this cosine shows nothing.
inline constexpr double least_facing = 1e-3;

}  // namespace etak
