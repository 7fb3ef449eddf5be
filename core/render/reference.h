// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/render/cpu_renderer.h"
#include "core/render/environment.h"
#include "core/render/scene.h"

namespace etak {

/// Fresnel reflectance as a colour, from a spectrum: exact F(wavelength, c) at 1 nm over 360..830 nm, seen
/// under D65 by the CIE 1931 observer, as linear sRGB.
///   error   3e-5 against the sum itself: 4096 steps in the cosine, linear between them
class SpectralFresnel {
 public:
  explicit SpectralFresnel(const OpticalConstants& optics);
  Vec3 at(double c) const;

  /// The sum itself, for one cosine.
  static Vec3 exact(const OpticalConstants& optics, double c);

 private:
  std::vector<Vec3> table_;
};

struct ReferenceOptions {
  int samples_per_side = 4;  // of a pixel: 4 x 4 points, each a ray of its own
  int light_samples = 16;    // per point, for hemispheres and environment; 0: those are left out
  unsigned threads = 1;
};

/// A judge's picture and how sure it is of itself.
struct Reference {
  Image picture;  // as render_cpu gives it
  // Of a pixel's luminance where light was sampled: root mean square over covered pixels.
  double standard_error = 0;
  double worst_error = 0;  // largest of a pixel
};

/// Draws `scene` in double with nothing approximated but by sampling: discrete lights summed; hemispheres and
/// environment integrated over the model's own lobe by multiple importance sampling (one third each after the
/// light, the cosine, and the lobe of the scene's gloss; balance heuristic); coverage by counting rays. Where
/// the surface has optics, Fresnel is taken per wavelength: the model's lobe (its f_r with F = 1) times
/// SpectralFresnel at the half angle. Random numbers follow from pixel and sample, so the picture is the same
/// for any number of threads.
Reference render_reference(const Scene& scene, const Environment* environment,
                           const ReferenceOptions& options, const RowsDone& rows_done = {});

/// How far the real-time terms for hemispheres and environment are from the sampled ones, on `scene` without
/// its discrete lights: luminance over the object's fully covered pixels, relative to the reference's mean.
struct AmbientError {
  double mean = 0, worst = 0;  // absolute differences
  double bias = 0;             // mean of signed differences
  double standard_error = 0;   // of the reference's pixels, rms: what of `mean` may be noise
};
AmbientError ambient_error(Scene scene, const Environment* environment, const ReferenceOptions& options);

/// The model with F = 1 that `model` is a lobe of, and its values: for the spectral reference. None for a
/// model whose Fresnel term cannot be set to 1, and for one whose diffuse part is not black.
struct Lobe {
  const Model* model;
  std::vector<double> values;
};
std::optional<Lobe> lobe_of(const Model& model, const std::vector<double>& values);

}  // namespace etak
