// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/light/studio.h"
#include "core/math/mat3.h"

namespace etak {

struct LightSamples;

/// Light from all directions as a latitude-longitude picture of radiance (linear sRGB), with the prefiltered
/// forms that shading uses.
///
/// Columns go around the y axis: the middle of the picture is at -z (where the camera looks), a quarter of
/// the width to the right of it is +x, and the top row is +y. Direction d has v = acos(d.y) / pi and
/// u = 1/2 + atan2(d.x, -d.z) / (2 pi).
///
/// The two prefiltered forms are made once. They are pictures that a GPU can use as textures:
///   irradiance   a small map; each of its pixels is a sum over all pixels of the environment
///   specular     one map for each of nine levels: the mean radiance that is seen through a round lobe
///                (ambient/round_lobe.h). A few of them together stand for the lobe of a model
///                (ambient/ambient.h); ambient_error() of reference.h measures the error of that
class Environment {
 public:
  /// How finely the prefiltered forms are made: quick ones blur details below 6 degrees, and take a hundredth
  /// of the time.
  enum class Prefilter { full, quick };

  /// Throws Error that names `what` for pictures of fewer than 3 channels, for sizes outside of 2 x 2 to
  /// 8192 x 4096, and for NaN, infinite or negative radiance.
  ///   scale     factor of the radiance, >= 0
  ///   threads   for prefiltering; the result is the same for any number
  ///   levels    false: without the levels, where irradiance and radiance alone are asked for
  Environment(const Image& lat_long, double scale, const std::string& what, unsigned threads,
              Prefilter prefilter = Prefilter::full, bool levels = true);

  /// The radiance from direction `d` (a unit vector), bilinear between pixels.
  Vec3 radiance(const Vec3& d) const;

  /// The irradiance on a plane with normal `n`; pi for an environment of radiance 1 everywhere.
  Vec3 irradiance(const Vec3& n) const;

  /// The radiance that is seen through the round lobe of `level` around `r`, linear between the whole levels;
  /// 1 for an environment of radiance 1 everywhere.
  ///   r       of any length but 0
  ///   level   [0, lobe_levels - 1]
  Vec3 at_level(const Vec3& r, double level) const;
  /// at_level() with the level of a gloss.
  Vec3 specular(const Vec3& r, double gloss) const;

  /// One prefiltered map, for the lobe of its gloss.
  struct Level {
    double gloss;
    Image map;
  };
  /// All levels in one picture, below each other, as a texture for shaders that mix several of them: octahedral maps
  /// (octahedral_place() of core/light/ambient.glsl), because these take no trigonometry, each with a border of one
  /// texel that continues it.
  const Image& level_stack() const { return stack_; }
  static constexpr int level_tile = 160;  // columns and rows of a level with its border

  /// Whether it was made by Prefilter::quick, to be shown until a full one is there.
  bool is_quick() const { return quick_; }

  /// The samples by which refined pictures see the environment, made when they are first asked for.
  const LightSamples& samples(bool bright_apart, unsigned threads) const;

  /// Two maps between which lies the environment as a backdrop shows it, and the weight of the duller one.
  /// The maps live as long as the environment.
  struct Blurred {
    const Image *sharp, *dull;
    double share;
    Vec3 at(const Vec3& d) const;  // the radiance from direction `d`, a unit vector
  };
  ///   blur   [0, 1]: from the picture itself (at most sharpest_width columns of it) to the level of gloss 0
  Blurred blurred(double blur) const;
  static constexpr int sharpest_width = 2048;

  const Image& map() const { return map_; }
  const Image& irradiance_map() const { return irradiance_; }
  const std::vector<Level>& levels() const { return levels_; }  // from gloss 1 to gloss 0

  /// The greatest luminance over the mean; 1 for an environment that is black.
  double contrast() const { return contrast_; }

  /// A direction for two random numbers in [0, 1), with a density about proportional to luminance.
  Vec3 sample(double u, double v) const;
  /// The density of sample() at direction `d`, in 1/sr.
  double pdf(const Vec3& d) const;

 private:
  void make_levels(const Image& seen, unsigned threads);

  Image map_;
  Image smaller_map_;  // empty where the map has no more than sharpest_width columns
  Image irradiance_;
  std::vector<Level> levels_;
  Image stack_;
  // Cumulated luminance over the rows, and in each row over its columns; the last sums are 1.
  std::vector<double> row_sums_, column_sums_;
  double contrast_ = 1;
  bool quick_ = false;
  struct Refined;
  std::shared_ptr<std::array<Refined, 2>> refined_;  // whole, and with the bright part apart
};

/// A turn of the environment around y: converts directions between the scene and the map.
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

/// The studio at once, from a smaller picture and quickly prefiltered: to be shown until studio_environment() is made.
std::shared_ptr<const Environment> quick_studio_environment(const std::string& name, double scale,
                                                            unsigned threads);

/// The studio as these two make it, without the levels: for with_ground(), which makes levels of its own.
std::shared_ptr<const Environment> studio_above_ground(const std::string& name, double scale,
                                                       unsigned threads, Environment::Prefilter prefilter);

/// What studio_environment() has made; null, at once, where it has not.
std::shared_ptr<const Environment> known_studio_environment(const std::string& name, double scale);

}  // namespace etak
