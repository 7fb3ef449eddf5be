// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/brdf/models.h"
#include "core/color/delta_e.h"
#include "core/study/choose/choose.h"

namespace etak {

// The pictures that choose() compares: spheres under a key, a fill and a rim light, which show highlights,
// edges and the parts between them. Lights and viewer are far away, so that each light has one half angle.

/// How a subject is drawn.
///   form     null: F is exact
///   values   numbers of the form; where F0 comes from a texture, that of each texel replaces the first
///            number
struct Look {
  const FresnelForm* form = nullptr;
  FresnelValues values{};
  std::string_view visibility = "smith-ggx-height";
  TextureFilter filter = TextureFilter::trilinear;
  const Model* model =
      nullptr;            // a whole model in the place of form and masking (choose_models.h); null: none
  Vec3 f0{};              // of that model, where F0 comes from no texture
  FresnelValues index{};  // the same: n and k, of a spectrum
};

/// Draws the spheres of a subject.
class ChoosePictures {
 public:
  /// `subject` must outlive this.
  explicit ChoosePictures(const ChooseSubject& subject);

  /// Linear colours of the pixels inside the silhouette, one picture after the other: one picture of a
  /// subject of one texel, one for each level of detail of a texture.
  std::vector<Vec3> draw(const Look& look) const;

 private:
  struct Light {
    Vec3 direction{};               // towards the light
    double irradiance = 0, lh = 0;  // lh: cosine between light and half vector
    Vec3 spectral_f{};              // the exact F, where the spectrum is known
  };
  // A pixel under a light that reaches it.
  struct LightSample {
    std::size_t light = 0;
    double nl = 0;
    Directions directions;
    double lobe = 0;  // value of the distribution
  };
  struct Pixel {
    SurfaceTexel texel;
    double alpha = 0;
    std::size_t first_sample = 0, sample_count = 0;  // in Pixels::samples
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
  std::vector<Vec3> draw_model(const Pixels& all, const Look& look) const;
  const std::vector<Vec3>& fresnel_of(const Look& look) const;

  const ChooseSubject& subject_;
  const bool f0_varies_;
  std::vector<Light> lights_;
  // Successive looks differ in one thing, so that what they share is kept. Only one thread may draw.
  mutable std::array<Pixels, all_filters.size()> pixels_;
  mutable std::vector<Reflectances> fresnel_;
};

/// F where F0 alone is known, for each channel: exact below the forbidden zone, Schlick's form above it.
Vec3 f_of_colour(const Vec3& f0, double cosine);
/// f_of_colour() over angle.
FresnelTruth colour_truth(const Vec3& f0);

/// The errors over all pixels, or over all angles.
struct PictureDifference {
  double worst = 0, mean = 0;
};
/// Compares pictures with those of "everything", at an exposure at which no channel of the latter clips: a
/// clipped channel would hide errors, and the channels beside it would overstate them.
class PictureJudge {
 public:
  PictureJudge(ErrorUnit unit, const std::vector<Vec3>& everything);

  /// `chosen` must hold the same pixels as `everything`, in the same order.
  PictureDifference difference_of(const std::vector<Vec3>& chosen) const;
  std::size_t pixels() const { return everything_.size(); }

 private:
  Vec3 exposed(const Vec3& pixel) const;

  ErrorUnit unit_;
  double exposure_ = 1;
  std::vector<Vec3> everything_;  // exposed
  std::vector<Lab> labs_;         // those of everything_, for ErrorUnit::delta_e alone
};

}  // namespace etak
