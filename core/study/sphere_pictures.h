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

// A sphere under three lights, as models draw it and by the spectral reference.

/// A material on the sphere.
struct SphereMaterial {
  std::string id;
  SurfaceValues surface;
  FresnelTruth truth;
};

/// A material of the library by its preferred dataset. Throws Error for a material that is not there or has
/// no n and k.
///   body   diffuse colour of a dielectric, linear; (0, 0, 0) for conductors and semiconductors
SphereMaterial sphere_material(const MaterialLibrary& library, std::string_view id, const Vec3& body);

/// Directional lights 50, 100 and 150 degrees from the viewer: half vectors at 25, 50 and 75 degrees.
LightSetup sphere_lights();

/// The scene in which `model` draws the material. The model's parameters are set by their roles; Fresnel
/// terms that need a fit get fitted numbers. A specular model gets a Lambert body beside it where the
/// material has a diffuse colour; a model of both kinds draws the body itself.
Scene sphere_scene(const Model& model, const SphereMaterial& material, double gloss, int side);

/// The scene for measuring times: under three lights all models take the same time, most of it for what they share, and
/// under so many the lobe has most of it.
inline constexpr int timed_lights = 48, timed_side = 256;
inline constexpr double timed_gloss = 0.5;
Scene timed_scene(const Model& model, const SphereMaterial& material);

/// Which pixels of a picture, row by row, lie at least one pixel inside the rim of the sphere. The rim is not
/// judged, because its smoothing depends on the renderer and not on the model.
std::vector<bool> sphere_pixels(int side);

/// The model that stands for the lobe of `model`: the same one for all models that differ in F alone.
const Model& lobe_model(const Model& model);

/// The pictures that render_reference() gives for the lobes of models and any material, in less time. Lights
/// and viewer are far away, so that each light has one half angle, at which F is one colour. Each lobe is
/// drawn once for each light with F = 1; the pictures of a material are sums of these times F.
///   error   1e-6 against render_reference(), relative to the brightest pixel
class SphereTruth {
 public:
  /// Throws Error for a model whose F cannot be set to 1.
  ///   rays   on each side of a pixel: rays x rays for a pixel
  SphereTruth(const std::vector<const Model*>& models, double gloss, int side, int rays, unsigned threads);

  /// The material with the lobe of `model`, which must be one of the constructor's models; linear sRGB, three
  /// channels.
  Image picture(const Model& model, const SphereMaterial& material) const;

 private:
  std::map<std::string, std::vector<Image>, std::less<>> lobes_;  // by id of lobe_model(); one for each light
  Image white_body_;
};

/// A picture as it is seen on a display; pixels that are not judged are black.
struct SeenPicture {
  Image8 codes;  // sRGB
  std::vector<Lab> lab;
  FlipView flip;
};
SeenPicture seen(const Image& picture, double exposure, const std::vector<bool>& judged);

/// The largest channel of the judged pixels, at least 1e-6. Its inverse is an exposure at which nothing
/// clips.
double brightest(const Image& picture, const std::vector<bool>& judged);

/// Sums of errors over the judged pixels of pictures. The order of add() decides the last digits of the sums.
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
