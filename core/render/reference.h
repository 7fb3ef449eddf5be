// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/render/cpu_renderer.h"
#include "core/render/environment.h"
#include "core/render/scene.h"

namespace etak {

/// The Fresnel reflectance of a spectrum as a colour: the exact F(wavelength, cosine) in steps of 1 nm over
/// 360..830 nm, under D65 for the CIE 1931 observer, in linear sRGB. It is a table of 4096 steps in the
/// cosine, linear between them.
///   error   3e-5 against SeenStack
class SpectralFresnel {
 public:
  explicit SpectralFresnel(const Optics& optics);
  Vec3 at(double c) const;

 private:
  std::vector<Vec3> table_;
};

struct ReferenceOptions {
  int samples_per_side = 4;  // of a pixel: 4 x 4 rays
  // For each ray and each part of the surface (specular, diffuse), of hemispheres and environment; 0: these are
  // left out. The error is known from 2 samples per pixel on.
  int light_samples = 16;
  unsigned threads = 1;
};

/// A reference picture and its statistical error.
struct Reference {
  Image picture;  // in the form of render_cpu()
  // The standard error of the luminance of sampled light: root mean square over the covered pixels, and that
  // of the worst pixel.
  double standard_error = 0, worst_error = 0;
};

/// Draws `scene` in double, with sampling as the only approximation. Discrete lights are summed. Hemispheres
/// and environment are integrated over the model itself: the specular part by samples that follow its own lobe
/// (LobeDensity), the diffuse part by samples that follow the cosine, and in an environment that is not even,
/// half of the samples of either follow the light; they are combined by multiple importance sampling with the
/// balance heuristic. Samples are lattices over the rays of a pixel, eight sets of them with shifts of their own.
/// So Lambert in an even surrounding is exact. Coverage is the share of rays that meet the object. Where the
/// surface has optics, Fresnel is computed for each wavelength: f_r is the model's lobe (its f_r with F = 1)
/// times SpectralFresnel at the half angle. Random shifts depend on the pixel alone, so the picture is the same
/// for any number of threads. Throws Error for scenes that validate() refuses.
Reference render_reference(const Scene& scene, const Environment* environment,
                           const ReferenceOptions& options, const RowsDone& rows_done = {});

/// The error of the real-time terms for hemispheres and environment against the sampled reference, on `scene`
/// without its discrete lights. All numbers are of luminance over the fully covered pixels, relative to the
/// mean of the reference.
struct AmbientError {
  double mean = 0, worst = 0;  // of absolute differences
  double bias = 0;             // mean of signed differences
  double standard_error = 0;   // of the reference's pixels, rms: so much of `mean` may be noise
};
AmbientError ambient_error(Scene scene, const Environment* environment, const ReferenceOptions& options);

/// A model and the values with which its Fresnel term is 1.
struct Lobe {
  const Model* model;
  std::vector<double> values;
};

/// The lobe of `model` with `values`, for the spectral reference; nullopt for a model whose Fresnel term
/// cannot be set to 1, and for one whose diffuse part is not black. That of a compensated model is of one reflection.
std::optional<Lobe> lobe_of(const Model& model, const std::vector<double>& values);

}  // namespace etak
