// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/brdf/models.h"
#include "core/color/delta_e.h"
#include "core/study/choose/choose.h"

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
  // A pixel under a light that reaches it.
  struct LightSample {
    std::size_t light = 0;
    double nl = 0;
    Directions directions;
    double lobe = 0;  // of the distribution
  };
  struct Pixel {
    SurfaceTexel texel;
    double alpha = 0;
    std::size_t first_sample = 0, sample_count = 0;  // of Pixels::samples
  };
  struct Pixels {
    std::vector<Pixel> pixels;
    std::vector<LightSample> samples;
  };
  struct Reflectances {
    const FresnelForm* form = nullptr;
    TextureFilter filter{};
    FresnelValues values{};
    std::vector<Vec3> f;  // one for each of Pixels::samples
  };
  const Pixels& pixels_of(TextureFilter filter) const;
  const std::vector<Vec3>& fresnel_of(const Look& look) const;

  const ChooseSubject& subject_;
  const bool f0_varies_;
  std::vector<Light> lights_;
  // Looks differ in one thing at a time: what they share is made once. A subject is judged on one thread.
  mutable std::array<Pixels, all_filters.size()> pixels_;
  mutable std::vector<Reflectances> fresnel_;
};

/// What F is where F0 alone is known, per channel.
Vec3 f_of_colour(const Vec3& f0, double cosine);

/// Over all pixels, at an exposure at which nothing of `everything` clips: a clipped channel would hide
/// errors, and one beside it overstate them.
struct PictureDifference {
  double worst = 0, mean = 0;
};
class PictureJudge {
 public:
  PictureJudge(ErrorUnit unit, const std::vector<Vec3>& everything);

  /// `chosen` has the pixels of `everything`.
  PictureDifference difference_of(const std::vector<Vec3>& chosen) const;
  std::size_t pixels() const { return everything_.size(); }

 private:
  Vec3 exposed(const Vec3& pixel) const;

  ErrorUnit unit_;
  double exposure_ = 1;
  std::vector<Vec3> everything_;  // exposed
  std::vector<Lab> labs_;         // of them, where the unit asks for it
};

}  // namespace etak
