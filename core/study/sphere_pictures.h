// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/color/delta_e.h"
#include "core/image/flip.h"
#include "core/image/image.h"
#include "core/material/library.h"
#include "core/render/scene.h"
#include "core/study/fresnel_forms.h"

namespace etak {

// A sphere under three lights, as models draw it and as it is.

/// A material on the sphere.
struct SphereMaterial {
  std::string id;
  SurfaceValues surface;
  FresnelTruth truth;
};

/// Throws Error for a material that is not there or has no n and k.
///   body   of a dielectric; conductors and semiconductors have none
SphereMaterial sphere_material(const MaterialLibrary& library, std::string_view id, const Vec3& body);

/// Directional lights 50, 100 and 150 degrees from the viewer: half vectors at 25, 50 and 75 degrees.
LightSetup sphere_lights();

/// `model` with what it is given of the material: its parameters by role, fitted numbers where a Fresnel term
/// asks for them. A specular model gets a Lambert body beside it; one of both kinds draws the body itself.
Scene sphere_scene(const Model& model, const SphereMaterial& material, double gloss, int side);

/// The pixels that the sphere covers whole, with a pixel to spare. The rim is not judged: how a renderer
/// smooths it is no matter of its models.
std::vector<bool> sphere_pixels(int side);

/// The lobe that `model` shares with others: the same for models that differ in F alone.
const Model& lobe_model(const Model& model);

/// What render_reference() gives for the lobes of models and any material, in less time: lights and viewer
/// are far away, so that each light has one half angle and F is one colour. A lobe is drawn once per light
/// with F = 1.
///   error   1e-6 against render_reference(), relative to the brightest pixel
class SphereTruth {
 public:
  /// `rays`: per side of a pixel. Models whose F cannot be set to 1 are the caller's mistake.
  SphereTruth(const std::vector<const Model*>& models, double gloss, int side, int rays, unsigned threads);

  /// The lobe of `model` (one of the constructor's) with the material's F, linear, three channels.
  Image picture(const Model& model, const SphereMaterial& material) const;

 private:
  std::map<std::string, std::vector<Image>, std::less<>> lobes_;  // by id of lobe_model(): one per light
  Image white_body_;
};

/// A picture as it is seen on a display; pixels that are not judged are black.
struct SeenPicture {
  Image8 codes;  // sRGB
  std::vector<Lab> lab;
  FlipView flip;
};
SeenPicture seen(const Image& picture, double exposure, const std::vector<bool>& judged);

/// Largest channel of the judged pixels, at least 1e-6: 1 / it is an exposure at which nothing clips.
double brightest(const Image& picture, const std::vector<bool>& judged);

/// Sums over pictures: add one after the other, in the same order for the same result.
struct PictureErrors {
  double squares = 0, de = 0, worst_de = 0, flip = 0;
  std::size_t pixels = 0;

  void add(const PictureErrors& other);
  double rms_codes() const;
  double psnr_db() const;  // against 255 codes
  double mean_de() const { return de / static_cast<double>(pixels); }
  double mean_flip() const { return flip / static_cast<double>(pixels); }
};
PictureErrors picture_errors(const SeenPicture& reference, const SeenPicture& test,
                             const std::vector<bool>& judged);

}  // namespace etak
