// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/light/studio.h"
#include "core/math/mat3.h"

namespace etak {

/// Light from all around as a lat-long picture of radiance (linear sRGB), and what shading needs of it.
///
/// Columns go around the y axis: the middle of the picture lies at -z (what the camera looks at), a quarter
/// to the right of it is +x; the top row is +y. For direction d: u = 1/2 + atan2(d.x, -d.z) / 2 pi, v =
/// acos(d.y) / pi.
///
/// Two prefiltered forms, made once, as plain pictures that a GPU can take as textures:
///   irradiance   exact sum over the map for every pixel of a small one
///   specular     a chain of maps, one per gloss level: the mean radiance seen through Schueler's lobe of
///                that gloss with viewer and normal along the mirror direction (so the lobe stays round at
///                grazing view: the usual split into lobe and Fresnel; environment_error() of reference.h
///                states what that costs)
class Environment {
 public:
  /// Throws Error (naming `what`) for pictures of fewer than 3 channels, NaN, infinite or negative radiance,
  /// or larger than 8192 x 4096.
  ///   scale     factor on the radiance, >= 0
  ///   threads   to prefilter with; the result is the same for any number
  Environment(const Image& lat_long, double scale, const std::string& what, unsigned threads);

  /// Radiance from direction `d` (unit vector): bilinear.
  Vec3 radiance(const Vec3& d) const;

  /// Irradiance on a plane with normal `n`: pi for a white environment of radiance 1.
  Vec3 irradiance(const Vec3& n) const;

  /// Radiance through the lobe of `gloss` around `r`: 1 for a white environment; between levels linear in
  /// gloss.
  Vec3 specular(const Vec3& r, double gloss) const;

  struct Level {
    double gloss;
    Image map;
  };
  /// The level above a gloss and the share of the one below it.
  struct Between {
    std::size_t sharp;
    double share;
  };
  Between between(double gloss) const;

  const Image& map() const { return map_; }
  const Image& irradiance_map() const { return irradiance_; }
  const std::vector<Level>& levels() const { return levels_; }  // gloss 1 first, 0 last

  /// Directions by luminance: two numbers in [0, 1) to a direction; pdf in 1/sr.
  Vec3 sample(double u, double v) const;
  double pdf(const Vec3& d) const;

 private:
  Image map_;
  Image irradiance_;
  std::vector<Level> levels_;
  std::vector<double> row_sums_;     // cumulated over rows, last 1
  std::vector<double> column_sums_;  // per row cumulated over columns, last 1
};

/// A scene's environment turned around y, and directions between the two.
class EnvironmentTurn {
 public:
  explicit EnvironmentTurn(double degrees);
  Vec3 to_map(const Vec3& d) const { return {d[0] * cos_ - d[2] * sin_, d[1], d[0] * sin_ + d[2] * cos_}; }
  Vec3 from_map(const Vec3& d) const { return {d[0] * cos_ + d[2] * sin_, d[1], d[2] * cos_ - d[0] * sin_}; }
  double cosine() const { return cos_; }
  double sine() const { return sin_; }

 private:
  double cos_ = 1, sin_ = 0;
};

/// The lat-long picture of a studio, for an Environment.
///   width   of the picture, even, 2 to 8192; its height is half of that
Image environment_picture(const Studio& studio, int width = 1024, unsigned threads = 1);

/// The environment of etak's studio `name` (core/light/studio.h), made once in a process for each scale while
/// somebody holds it; the one of studio_lights() stays. Throws Error for a name that is none.
std::shared_ptr<const Environment> studio_environment(const std::string& name, double scale,
                                                      unsigned threads);

/// The same where it has been made; null, at once, where it has not.
std::shared_ptr<const Environment> known_studio_environment(const std::string& name, double scale);

}  // namespace etak
