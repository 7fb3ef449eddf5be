// SPDX-License-Identifier: Apache-2.0
#include "core/study/sphere_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/brdf/models.h"
#include "core/color/srgb.h"
#include "core/material/seen_stack.h"
#include "core/math/functions.h"
#include "core/render/reference.h"

namespace etak {
namespace {

struct LightAngle {
  double from_viewer_deg, turn_deg, irradiance;
};
// Surfaces reflect more of light that comes from behind. With these irradiances the three highlights are
// about equally bright.
constexpr std::array light_angles{LightAngle{50, 120, 3.0}, LightAngle{100, 10, 2.0},
                                  LightAngle{150, 235, 0.5}};

Vec3 towards_light(const LightAngle& light) {
  constexpr double radian = std::numbers::pi / 180;
  const double away = light.from_viewer_deg * radian, turn = light.turn_deg * radian;
  return {math::sin(away) * math::cos(turn), math::sin(away) * math::sin(turn), math::cos(away)};
}

// The lobe of a model with the width of that gloss and F = 1.
Lobe unit_lobe(const Model& model, double gloss) {
  SurfaceValues surface;
  surface.gloss = gloss;
  const Model& shared = lobe_model(model);
  auto lobe = lobe_of(shared, model_values(shared, surface, {}));
  if (!lobe) throw Error::at("model " + std::string(model.id), "has no F", "a specular model");
  return *lobe;
}

Scene empty_scene(int side) {
  Scene scene;
  scene.width = scene.height = side;
  scene.background = {0, 0, 0};
  scene.lights = sphere_lights();
  return scene;
}

std::size_t index_of(int side, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x);
}

}  // namespace

SphereMaterial sphere_material(const MaterialLibrary& library, std::string_view id, const Vec3& body) {
  const auto material = library.find(id);
  if (!material) throw Error::at(std::string(id), "is not in the library");
  const Dataset& dataset = material->preferred_dataset();
  const auto* optics = std::get_if<OpticalConstants>(&dataset.optics);
  if (optics == nullptr) throw Error::at(std::string(id), without_constants(dataset.optics), "n and k");
  SphereMaterial out{std::string(id), surface_of(*material, dataset, body, 0.5), fresnel_truth(*optics, id)};
  out.surface.optics = *optics;
  return out;
}

LightSetup sphere_lights() {
  LightSetup setup;
  for (const LightAngle& angle : light_angles) {
    Light light;
    light.kind = LightKind::directional;
    const Vec3 l = towards_light(angle);
    light.direction = {-l[0], -l[1], -l[2]};
    light.intensity = angle.irradiance;
    setup.lights.push_back(light);
  }
  return setup;
}

Scene sphere_scene(const Model& model, const SphereMaterial& material, double gloss, int side) {
  Scene scene = empty_scene(side);
  scene.surface = material.surface;
  scene.surface.gloss = gloss;
  scene.specular = &model;
  scene.specular_values = model_values(model, scene.surface, {});
  if (model.fresnel != nullptr && (model.fresnel->id == "lazanyi" || model.fresnel->id == "gulbrandsen")) {
    // The values of a model begin with the parameters of its Fresnel term, three channels of each number.
    const FresnelValues fitted = fresnel_form(model.fresnel->id)->fit(material.truth);
    for (std::size_t i = 0; i < model.fresnel->parameters.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) scene.specular_values[3 * i + c] = fitted[c][i];
  }
  if (model.kind == ModelKind::specular && scene.surface.diffuse != Vec3{0, 0, 0}) {
    scene.diffuse = find_model(default_diffuse);
    scene.diffuse_values = model_values(*scene.diffuse, scene.surface, {});
  }
  return scene;
}

Scene timed_scene(const Model& model, const SphereMaterial& material) {
  Scene scene = sphere_scene(model, material, timed_gloss, timed_side);
  scene.lights.lights = spread_lights(timed_lights);
  return scene;
}

std::vector<bool> sphere_pixels(int side) {
  std::vector<bool> out(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  const double step = 2.2 / side;  // width of a pixel in radii of the sphere, as struct Scene has it
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      out[index_of(side, x, y)] =
          math::hypot((x + 0.5 - side / 2.0) * step, (y + 0.5 - side / 2.0) * step) <= 1 - step;
  return out;
}

const Model& lobe_model(const Model& model) {
  if (model.distribution != nullptr)
    return *find_model("microfacet:" + std::string(model.distribution->id) + ",schlick," +
                       std::string(model.visibility->id));
  // For both forms of Optimized lobe_of() gives the lobe of the bounded form.
  if (model.id == "schueler-optimized") return *find_model("schueler-optimized-bounded");
  return model;
}

SphereTruth::SphereTruth(const std::vector<const Model*>& models, double gloss, int side, int rays,
                         unsigned threads) {
  std::vector<std::pair<const Model*, std::vector<Image>*>> todo;
  for (const Model* model : models) {
    const auto [place, is_new] = lobes_.try_emplace(std::string(lobe_model(*model).id));
    if (!is_new) continue;
    place->second.resize(light_angles.size());
    todo.push_back({model, &place->second});
  }
  ReferenceOptions options;
  options.samples_per_side = rays;
  options.light_samples = 0;
  parallel_chunks(todo.size() * light_angles.size(), threads, 1, [&](std::size_t i, std::size_t, unsigned) {
    const auto& [model, pictures] = todo[i / light_angles.size()];
    const std::size_t light = i % light_angles.size();
    Lobe lobe = unit_lobe(*model, gloss);
    Scene scene = empty_scene(side);
    scene.surface.gloss = gloss;
    scene.specular = lobe.model;
    scene.specular_values = std::move(lobe.values);
    scene.lights.lights = {scene.lights.lights[light]};
    (*pictures)[light] = render_reference(scene, nullptr, options).picture;
  });
  Scene scene = empty_scene(side);
  scene.diffuse = find_model(default_diffuse);
  scene.surface.diffuse = {1, 1, 1};
  scene.diffuse_values = model_values(*scene.diffuse, scene.surface, {});
  options.threads = threads;
  white_body_ = render_reference(scene, nullptr, options).picture;
}

Image SphereTruth::picture(const Model& model, const SphereMaterial& material) const {
  const std::vector<Image>& lobes = lobes_.find(lobe_model(model).id)->second;
  Image out(white_body_.width, white_body_.height, 3);
  std::array<Vec3, light_angles.size()> f;
  for (std::size_t light = 0; light < f.size(); ++light)
    f[light] = SeenStack(*material.surface.optics)(
        math::cos(light_angles[light].from_viewer_deg / 2 * std::numbers::pi / 180));
  for (std::size_t i = 0; i < out.pixel_count(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      double sum = static_cast<double>(white_body_.values[4 * i + c]) * material.surface.diffuse[c];
      for (std::size_t light = 0; light < f.size(); ++light)
        sum += static_cast<double>(lobes[light].values[4 * i + c]) * f[light][c];
      out.values[3 * i + c] = static_cast<float>(sum);
    }
  return out;
}

double brightest(const Image& picture, const std::vector<bool>& judged) {
  float most = 1e-6f;
  const auto channels = static_cast<std::size_t>(picture.channels);
  for (std::size_t i = 0; i < judged.size(); ++i)
    if (judged[i])
      for (std::size_t c = 0; c < 3; ++c) most = std::max(most, picture.values[channels * i + c]);
  return static_cast<double>(most);
}

SeenPicture seen(const Image& picture, double exposure, const std::vector<bool>& judged) {
  SeenPicture out{Image8(picture.width, picture.height, 3), std::vector<Lab>(judged.size()), {}};
  const auto channels = static_cast<std::size_t>(picture.channels);
  for (std::size_t i = 0; i < judged.size(); ++i) {
    if (!judged[i]) continue;
    Vec3 linear{};
    for (std::size_t c = 0; c < 3; ++c) {
      linear[c] = std::clamp(exposure * static_cast<double>(picture.values[channels * i + c]), 0.0, 1.0);
      out.codes.values[3 * i + c] = srgb_u8(linear[c]);
    }
    out.lab[i] = to_lab(to_rgb(linear));
  }
  out.flip = flip_view(out.codes);
  return out;
}

PictureErrors picture_errors(const SeenPicture& reference, const SeenPicture& test,
                             const std::vector<bool>& judged) {
  PictureErrors out;
  const FlipError flips = flip(reference.flip, test.flip);
  for (std::size_t i = 0; i < judged.size(); ++i) {
    if (!judged[i]) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const int codes = reference.codes.values[3 * i + c] - test.codes.values[3 * i + c];
      out.squares += codes * codes / 3.0;
    }
    const double de = delta_e2000(reference.lab[i], test.lab[i]);
    out.de += de;
    out.worst_de = std::max(out.worst_de, de);
    out.flip += flips.map[i];
    ++out.pixels;
  }
  return out;
}

void PictureErrors::add(const PictureErrors& other) {
  squares += other.squares;
  de += other.de;
  worst_de = std::max(worst_de, other.worst_de);
  flip += other.flip;
  pixels += other.pixels;
}

double PictureErrors::rms_codes() const {
  return std::sqrt(squares / static_cast<double>(pixels));
}

double PictureErrors::psnr_db() const {
  return 20 * math::log10(255 / std::max(rms_codes(), 1e-6));
}

}  // namespace etak
