// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/brdf/models.h"
#include "core/report/choose.h"

namespace etak {

// Pictures for choosing: spheres under a key, a fill and a rim light, so that highlights, edges and the half
// light between are all in them. Lights and viewer are far away: each light has one half angle.

/// How a subject is drawn. Without a form F is the truth.
struct Look {
  const FresnelForm* form = nullptr;
  FresnelValues values{};  // of a subject with one F0; a texture gives each texel's F0 as the first number
  std::string_view visibility = "smith-ggx-height";
  TextureFilter filter = TextureFilter::trilinear;
};

class ChoosePictures {
 public:
  /// `subject` must outlive this.
  explicit ChoosePictures(const ChooseSubject& subject);

  /// Linear colours of the pixels inside the silhouette, one picture after the other: one of a subject of one
  /// texel, of a texture one per level of detail.
  std::vector<Vec3> draw(const Look& look) const;

 private:
  struct Light {
    Vec3 direction{};  // towards it
    double irradiance = 0, lh = 0;
    Vec3 spectral_f{};  // where the spectrum is known
  };
  void shade(const Look& look, const Vec3& normal, const SurfaceTexel& texel, Vec3& out) const;

  const ChooseSubject& subject_;
  const bool f0_varies_;
  std::vector<Light> lights_;
};

/// What F is where F0 alone is known, per channel.
Vec3 f_of_colour(const Vec3& f0, double cosine);

/// Over all pixels, at an exposure at which nothing of `everything` clips: a clipped channel would hide
/// errors, and one beside it overstate them.
struct PictureDifference {
  double worst = 0, mean = 0;
};
PictureDifference picture_difference(ErrorUnit unit, const std::vector<Vec3>& everything,
                                     const std::vector<Vec3>& chosen);

}  // namespace etak
