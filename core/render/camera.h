// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/render/scene.h"

namespace etak {

/// The axes of a camera in the space of the scene, as rows: to the right, up, and from the object to the
/// camera.
Mat3 camera_axes(const View& view);

/// Computes where the object of a scene lies in its picture, by the rules that struct Scene states.
class Camera {
 public:
  explicit Camera(const Scene& scene);

  bool perspective() const { return perspective_; }
  Shape shape() const { return shape_; }
  double pixel() const { return pixel_; }        // side of a pixel, in radii of the sphere's silhouette
  double distance() const { return distance_; }  // of the camera from the origin; perspective only
  double spread() const { return spread_; }      // tangent of the silhouette's half-angle; perspective only
  double side() const { return side_; }    // half a side of the quad, as the camera sees it from the front
  bool turned() const { return turned_; }  // whether the camera is not at the front
  const Mat3& axes() const { return axes_; }
  double centre_column() const { return centre_column_; }  // column of x = 0, from the left
  double centre_row() const { return centre_row_; }        // row of y = 0, from the top
  /// The map from the picture to a turned quad, in homogeneous coordinates. It takes (x, y, 1) to (a, b, c):
  /// the place on the quad is (a / c, b / c), and c is above 0 where the place is in front of the camera.
  const Mat3& plane() const { return plane_; }
  /// The side of the quad that the camera sees: 1 for the front, -1 for the back.
  double facing() const { return axes_[2][2] < 0 ? -1 : 1; }

  /// The x and y of a point of the picture. `column` and `row` count pixels from the top left corner; the
  /// centre of a pixel is at halves.
  double x(double column) const { return (column - centre_column_) * pixel_; }
  double y(double row) const { return (centre_row_ - row) * pixel_; }

  /// The columns [first, last) of `row` that the object covers, wholly or in part.
  struct Span {
    int first, last;
  };
  Span covered(int row) const;

  /// The columns of `row` that the object covers wholly and whose centres are inside silhouette_limit.
  Span whole(int row) const;

  /// The share of the pixel with its centre at x, y that the object covers, [0, 1].
  double coverage(double x, double y) const;

  /// Whether the ray through x, y meets the object; for supersampling.
  bool meets(double x, double y) const;

  /// What the camera sees at x, y: the point on the surface, its normal, and the unit vector from the point
  /// to the viewer, all in the space of the scene. An x, y outside of the silhouette is moved in to its edge.
  struct Sight {
    Vec3 position, viewer, normal;
  };
  Sight sight(double x, double y) const;

 private:
  Vec3 out_of(const Vec3& seen) const;  // converts from the camera's axes to those of the scene
  Vec3 on_plane(double x, double y) const;

  Shape shape_;
  bool perspective_, turned_ = false;
  int width_;
  double pixel_, centre_column_, centre_row_;
  double distance_ = 0, spread_ = 0, side_ = 1;
  Mat3 axes_ = identity3, plane_ = identity3;
};

/// Pixels at the edge of the sphere are shaded at most this far from the centre, in radii, so that their
/// normals still face the camera.
inline constexpr double silhouette_limit = 0.9999;

/// A quad is not drawn where the cosine between its normal and the camera is smaller than this.
inline constexpr double least_facing = 1e-3;

}  // namespace etak
