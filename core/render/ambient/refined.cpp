// SPDX-License-Identifier: Apache-2.0
// Based on:
//   Krivanek and Colbert 2008, "Real-time Shading with Filtered Importance Sampling"
//   Swinbank and Purser 2006, "Fibonacci grids": the even set of directions of any size
#include "core/render/ambient/refined.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/render/lobe_density.h"
#include "core/render/surface_textures.h"

namespace etak {
namespace {

using std::numbers::pi;

// A lobe of which half lies beyond this polar angle of half vectors, in radians, is wide enough for the bright lights of
// an environment to lie close together in it.
constexpr double wide_lobe = 0.08;

// Where a flat body is evaluated: far from the lobe of a model of kind both.
constexpr Directions flat_directions{0.8, 0, 0.6, 0.8, 0, 0.6};

// f_r of the diffuse part.
Vec3 body_at(const AmbientPlan& plan, const Directions& d) {
  double all[3], lobe[3] = {};
  plan.diffuse->f64(d, plan.diffuse_values.data(), all);
  if (plan.combined) plan.diffuse->f64(d, plan.specular_values.data(), lobe);
  return {all[0] - lobe[0], all[1] - lobe[1], all[2] - lobe[2]};
}

bool is_flat(const AmbientPlan& plan) {
  const Vec3 here = body_at(plan, flat_directions);
  for (const Directions& d : {Directions{0, 0, 1, 0.6, 0, 0.8}, Directions{-0.6, 0, 0.8, 0, 0.96, 0.28}}) {
    const Vec3 there = body_at(plan, d);
    for (std::size_t c = 0; c < 3; ++c)
      if (std::abs(there[c] - here[c]) > 1e-9 * (std::abs(there[c]) + std::abs(here[c]))) return false;
  }
  return true;
}

// The values of a model at a texel of a grey body, F0 of 0.5 and a gloss.
std::vector<double> textured_values(const Model& model, const std::vector<double>& values, double body,
                                    double gloss) {
  TexturedValues textured(model, values);
  const double* const at = textured.at({body, body, body, 1}, {0.5, 0.5, 0.5, gloss});
  return {at, at + values.size()};
}

// Sample i of `count`: an even spiral, by the share of the density that lies within it and the azimuth.
struct OnSpiral {
  double share, azimuth;
};
OnSpiral on_spiral(int i, int count) {
  const double turns = i / std::numbers::phi;
  return {(i + 0.5) / count, 2 * pi * (turns - std::floor(turns))};
}

void set_sample(Image& samples, int i, int row, double cosine, double azimuth, double weight) {
  const double sine = std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine)));
  const double values[4] = {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine, weight};
  for (std::size_t c = 0; c < 4; ++c) samples.at(i, row)[c] = static_cast<float>(values[c]);
}

}  // namespace

bool is_refined(const Scene& scene, bool has_environment) {
  const auto& sky = scene.lights.hemispheres;
  return scene.ambient_samples > 0 && (has_environment || sky) &&
         !(sky && sky->form == HemisphereForm::printed);
}

AmbientPlan ambient_plan(const Scene& scene) {
  AmbientPlan out;
  const bool textured = scene.textures != nullptr;
  if (scene.specular != nullptr) {
    out.specular = scene.specular;
    const std::vector<double> seen = seen_specular_values(scene);
    out.specular_values = without_body(*scene.specular, seen);
    if (scene.specular->kind == ModelKind::combined && (textured || seen != out.specular_values)) {
      out.combined = true;
      out.diffuse = scene.specular;
      out.diffuse_values = seen;
    }
  }
  if (scene.diffuse != nullptr && (textured || !body_is_black(*scene.diffuse, scene.diffuse_values))) {
    out.diffuse = scene.diffuse;
    out.diffuse_values = scene.diffuse_values;
  }
  if (textured) {
    // Flat bodies are judged, and later scaled by the colour of the texel, as if they were white.
    const auto with_body = [&](const Model* model, std::vector<double>& values, double color) {
      if (model == nullptr) return;
      values = textured_values(*model, values, color, 0.5);
    };
    with_body(out.specular, out.specular_values, 0);
    with_body(out.diffuse, out.diffuse_values, 1);
  }
  if (out.diffuse != nullptr) out.flat = body_at(out, flat_directions);
  if (out.diffuse != nullptr) out.body = is_flat(out) ? AmbientPlan::Body::flat : AmbientPlan::Body::sampled;

  const int count = scene.ambient_samples,
            lobes = textured && scene.textures->has.gloss ? AmbientPlan::lobe_rows : 1;
  out.samples = Image(count, 1 + lobes, 4);
  for (int i = 0; i < count; ++i) {
    const auto [share, azimuth] = on_spiral(i, count);
    const double cosine = std::sqrt(1 - share);
    set_sample(out.samples, i, 0, cosine, azimuth, pi / (count * cosine));
  }
  for (int row = 0; row < lobes && out.specular != nullptr; ++row) {
    std::vector<double> values = out.specular_values;
    if (textured) {
      const double gloss = lobes == 1 ? double{scene.surface.gloss} : double(row) / (lobes - 1);
      values = textured_values(*out.specular, values, 0, gloss);
    }
    const LobeDensity density(*out.specular, values);
    out.wide = lobes == 1 && density.polar(0.5) > wide_lobe;
    for (int i = 0; i < count; ++i) {
      const auto [share, azimuth] = on_spiral(i, count);
      const double polar = density.polar(share);
      // The density of the mirrored direction is that of the half vector over 4 lh.
      set_sample(out.samples, i, 1 + row, std::cos(polar), azimuth, 4 / (count * density.pdf(polar)));
    }
  }
  return out;
}

}  // namespace etak
