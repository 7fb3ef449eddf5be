// SPDX-License-Identifier: Apache-2.0
#include "core/render/engines.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/color/luminance.h"
#include "core/render/cpu_renderer.h"

namespace etak {
namespace {

constexpr std::array all{
    Engine{
        "unreal", "Unreal Engine", "as-unreal", Tone::plain, 0.08,
        "Karis 2013, Real Shading in Unreal Engine 4",
        "the shaders of later versions and the formula of the filmic tone curve, which are published to licensees alone"},
    Engine{"unity-hdrp", "Unity HDRP", "as-unity-hdrp", Tone::plain, 1,
           "Lit.hlsl, BSDF.hlsl, specular colour; no tone curve by default", ""},
    Engine{"unity-urp", "Unity URP", "as-unity-urp", Tone::plain, 1,
           "BRDF.hlsl, specular setup; no tone curve by default", ""},
    Engine{
        "blender", "Blender (Cycles)", "as-blender", Tone::plain, 1, "Principled BSDF of Cycles 4",
        "AgX, a table of Blender's OpenColorIO config, and the table of what a rough dielectric leaves to its body"},
    Engine{"filament", "Filament", "as-filament", Tone::filament, 0.16,
           "Physically Based Rendering in Filament; ToneMapper.cpp", ""},
    Engine{"gltf", "glTF viewers", "as-gltf", Tone::neutral, 1,
           "glTF 2.0, Appendix B; glTF Sample Renderer; Khronos PBR Neutral", ""}};

bool is_metal(const SurfaceValues& surface) {
  return surface.diffuse == Vec3{} && luminance_of(surface.f0) >= forbidden_zone_first;
}

}  // namespace

std::span<const Engine> engines() {
  return all;
}

const Engine* find_engine(std::string_view id) {
  const auto at = std::ranges::find(all, id, &Engine::id);
  return at == all.end() ? nullptr : &*at;
}

std::vector<std::string> engine_ids() {
  std::vector<std::string> out;
  for (const Engine& each : all) out.emplace_back(each.id);
  return out;
}

SurfaceValues held_by(const Engine& engine, SurfaceValues surface, std::vector<ClampedValue>& changed) {
  const double most = is_metal(surface) ? 1 : engine.most_f0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double wanted = surface.f0[c];
    surface.f0[c] = std::clamp(wanted, 0.0, most);
    if (surface.f0[c] != wanted) changed.push_back({std::string("F0.") + "rgb"[c], wanted, surface.f0[c]});
    surface.f82[c] = std::clamp(surface.f82[c], 0.0, 1.0);
  }
  surface.curve.reset();
  return surface;
}

Scene shown_as(const Engine& engine, Scene scene, std::vector<ClampedValue>& changed) {
  const bool metal = is_metal(scene.surface);
  scene.surface = held_by(engine, scene.surface, changed);
  scene.specular = find_model(engine.model);
  scene.specular_values = model_values(*scene.specular, scene.surface, {}, &changed);
  if (scene.specular->parameters.back().name == "metallic") scene.specular_values.back() = metal;
  scene.diffuse = nullptr;
  scene.diffuse_values.clear();
  if (scene.tone == Tone::plain) scene.tone = engine.tone;
  return scene;
}

ViewSide shown_as(const Engine& engine, ViewSide side) {
  std::vector<ClampedValue> changed;
  const bool metal = is_metal(side.surface);
  side.surface = held_by(engine, side.surface, changed);
  side.specular = find_model(engine.model);
  side.diffuse = nullptr;
  side.overrides.clear();
  if (metal && side.specular->parameters.back().name == "metallic") side.overrides = {{"metallic", 1}};
  return side;
}

Scene exact_scene(Scene scene) {
  const Model* exact = find_model(scene.textured().f0 ? "ggx-schlick-compensated" : "ggx-exact-compensated");
  FittedModels fitted = fit_models(exact, find_model(default_diffuse), {}, scene.surface);
  scene.specular = fitted.specular;
  scene.specular_values = std::move(fitted.specular_values);
  scene.diffuse = fitted.diffuse;
  scene.diffuse_values = std::move(fitted.diffuse_values);
  scene.refined = true;
  return scene;
}

DifferencePicture engine_difference(const Engine& engine, const Scene& scene, const Environment* environment,
                                    unsigned threads) {
  std::vector<ClampedValue> changed;
  const Scene as = shown_as(engine, scene, changed);
  Image exact, picture;
  render_cpu(exact_scene(scene), environment, threads, Precision::f32, exact);
  render_cpu(as, environment, threads, Precision::f32, picture);
  return difference_picture(exact, picture, scene.exposure, as.tone);
}

}  // namespace etak
