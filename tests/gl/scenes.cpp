// SPDX-License-Identifier: Apache-2.0
#include "tests/gl/scenes.h"

#include <cmath>
#include <cstdio>
#include <memory>

#include "core/render/display.h"

namespace etak::test {
namespace {

Light directional() {
  Light light;
  light.direction = {-0.48, -0.6, -0.64};
  light.intensity = 2;
  return light;
}

Light point() {
  Light light;
  light.kind = LightKind::point;
  light.position = {1.5, 1, 2};
  light.color = {1, 0.8, 0.6};
  light.intensity = 6;
  return light;
}

Light spot() {
  Light light;
  light.kind = LightKind::spot;
  light.position = {-1.5, 1.5, 2};
  light.direction = {0.514495755427527, -0.514495755427527, -0.6859943405700353};
  light.intensity = 8;
  light.inner_deg = 10;
  light.outer_deg = 25;
  return light;
}

Light area(LightKind kind) {
  Light light;
  light.kind = kind;
  light.position = {1, 1.5, 2.5};
  light.direction = normalised_direction({-1, -1.5, -2.5});
  light.width = 2;
  light.height = 1.2;
  return light;
}

Scene scene_with(const Model& model) {
  Scene scene;
  scene.surface.f0 = {0.95, 0.64, 0.54};
  const bool diffuse_only = model.kind == ModelKind::diffuse;
  (diffuse_only ? scene.diffuse : scene.specular) = &model;
  std::vector<double>& values = diffuse_only ? scene.diffuse_values : scene.specular_values;
  values = model_values(model, scene.surface, {});
  return scene;
}

// A diffuse colour that is not 0, in the surface and in the models' values.
void add_body(Scene& scene) {
  scene.surface.diffuse = {0.5, 0.4, 0.3};
  if (scene.specular != nullptr) scene.specular_values = model_values(*scene.specular, scene.surface, {});
  if (scene.specular == nullptr || scene.specular->kind == ModelKind::specular) {
    if (scene.diffuse == nullptr) scene.diffuse = find_model("lambert");
    scene.diffuse_values = model_values(*scene.diffuse, scene.surface, {});
  }
}

// Small textures whose texels differ.
std::shared_ptr<const SurfaceTextures> textures(const SurfaceTextures::Quantities& has) {
  const auto picture = [](int width, int height) {
    Image out(width, height, 4);
    for (std::size_t i = 0; i < out.values.size(); ++i)
      out.values[i] = 0.2F + static_cast<float>(i * 7 % 13) / 20;
    return out;
  };
  return std::make_shared<const SurfaceTextures>(
      SurfaceTextures{picture(4, 3), picture(3, 5), has, picture(6, 4)});
}

using Change = void (*)(Scene&);
struct Feature {
  const char* name;
  Change on, off;
};

const Feature features[] = {
    {"diffuse", add_body,
     [](Scene& s) {
       s.surface.diffuse = {0, 0, 0};
       if (s.specular != nullptr) s.diffuse = nullptr;
       if (s.specular != nullptr) s.specular_values = model_values(*s.specular, s.surface, {});
       if (s.diffuse != nullptr) s.diffuse_values = model_values(*s.diffuse, s.surface, {});
     }},
    {"directional", [](Scene& s) { s.lights.lights.push_back(directional()); },
     [](Scene& s) {
       std::erase_if(s.lights.lights, [](const Light& l) { return l.kind == LightKind::directional; });
     }},
    {"point", [](Scene& s) { s.lights.lights.push_back(point()); },
     [](Scene& s) {
       std::erase_if(s.lights.lights, [](const Light& l) { return l.kind == LightKind::point; });
     }},
    {"spot", [](Scene& s) { s.lights.lights.push_back(spot()); },
     [](Scene& s) {
       std::erase_if(s.lights.lights, [](const Light& l) { return l.kind == LightKind::spot; });
     }},
    {"area", [](Scene& s) { s.lights.lights.push_back(area(LightKind::rectangle)); },
     [](Scene& s) { std::erase_if(s.lights.lights, [](const Light& l) { return is_area(l.kind); }); }},
    {"hemispheres", [](Scene& s) { s.lights.hemispheres.emplace(); },
     [](Scene& s) { s.lights.hemispheres.reset(); }},
    {"environment", [](Scene& s) { s.lights.environment = "sky.exr"; },
     [](Scene& s) { s.lights.environment.clear(); }},
    {"transparency", [](Scene& s) { s.surface.opacity = 0.4; }, [](Scene& s) { s.surface.opacity = 1; }},
    {"exposure", [](Scene& s) { s.exposure = 0.8; }, [](Scene& s) { s.exposure = 1; }},
    {"perspective", [](Scene& s) { s.perspective = true; }, [](Scene& s) { s.perspective = false; }},
    {"quad", [](Scene& s) { s.shape = Shape::quad; }, [](Scene& s) { s.shape = Shape::sphere; }},
    {"srgb", [](Scene& s) { s.transfer = Transfer::srgb; }, [](Scene& s) { s.transfer = Transfer::linear; }},
};

}  // namespace

Scene bare_scene(const Model& model) {
  Scene scene = scene_with(model);
  if (model.kind == ModelKind::diffuse) add_body(scene);
  scene.lights.lights = {directional()};
  scene.transfer = Transfer::linear;
  return scene;
}

Scene full_scene(const Model& model) {
  Scene scene = scene_with(model);
  for (const Feature& each : features)
    if (each.name != std::string("quad")) each.on(scene);
  return scene;
}

std::vector<Variant> variants(const Model& model) {
  std::vector<Variant> out{{"everything-on", full_scene(model)}, {"everything-off", bare_scene(model)}};
  for (const Feature& each : features) {
    out.push_back({std::string("without-") + each.name, full_scene(model)});
    each.off(out.back().scene);
    out.push_back({std::string("only-") + each.name, bare_scene(model)});
    each.on(out.back().scene);
  }
  // Nothing lights the object: the model is not in the text at all.
  out.push_back({"no-light", bare_scene(model)});
  out.back().scene.lights.lights.clear();
  for (const HemisphereForm form :
       {HemisphereForm::model, HemisphereForm::corrected, HemisphereForm::wide, HemisphereForm::printed}) {
    out.push_back({"hemispheres-" + std::string(name(form)), full_scene(model)});
    out.back().scene.lights.hemispheres->form = form;
  }
  for (const Transfer transfer : {Transfer::power_045, Transfer::square_root}) {
    out.push_back({transfer == Transfer::power_045 ? "power-0.45" : "square-root", full_scene(model)});
    out.back().scene.transfer = transfer;
  }
  const auto changed = [&](const char* name, auto change) {
    for (const bool view : {false, true}) {
      out.push_back({std::string(name) + (view ? "-turned" : ""), full_scene(model)});
      change(out.back().scene);
      if (view) out.back().scene.view = View{30, 20, 0.2, -0.1, 0.8};
    }
  };
  changed("backdrop", [](Scene& s) { s.backdrop = {true, 0.25, false}; });
  changed("sharp-backdrop", [](Scene& s) { s.backdrop = {true, 0, false}; });
  changed("backdrop-and-ground", [](Scene& s) { s.backdrop = {true, 0.5, true}; });
  changed("ground", [](Scene& s) {
    s.backdrop.ground = true;
    s.perspective = false;
  });
  changed("clear-ball", [](Scene& s) {
    s.surface.n = {1.5, 1.5, 1.5};
    s.surface.passing = Vec3{0.9, 0.6, 0.99};
  });
  changed("clear-ball-alone", [](Scene& s) {
    s.surface.passing = Vec3{1, 1, 1};
    s.surface.opacity = 0;
    s.perspective = false;
    s.lights.lights.clear();
    s.lights.hemispheres.reset();
  });
  changed("clear-ball-with-layers", [](Scene& s) {
    s.surface.passing = Vec3{0.9, 0.6, 0.99};
    s.surface.layers = {1.4, fitted_curve([](double c) {
                          return Vec3{0.9 * c, 0.5 + 0.4 * c * c, 0.95 * (1 - (1 - c) * (1 - c))};
                        })};
  });
  changed("emission-and-occlusion-textures", [](Scene& s) {
    s.surface.emission = {0.5, 1, 0};
    s.surface.occlusion = 0.9;
    s.textures = textures({false, false, false, false, true, true});
  });
  changed("occlusion-texture", [](Scene& s) {
    s.textures = textures({false, false, false, false, false, true});
  });
  changed("normal-map", [](Scene& s) {
    SurfaceTextures map = *textures({false, false, false, false, false, false, true});
    map.normal = Image(4, 3, 4, 1);
    for (int i = 0; i < 12; ++i) {
      const double x = 0.4 * std::sin(2.5 * i), y = 0.4 * std::cos(1.5 * i);
      const std::array<double, 3> n{x, y, std::sqrt(1 - x * x - y * y)};
      for (std::size_t c = 0; c < 3; ++c) map.normal.at(i % 4, i / 4)[c] = static_cast<float>(n[c]);
    }
    s.textures = std::make_shared<const SurfaceTextures>(std::move(map));
    s.texture_scale = {3, 2};
  });
  changed("repeated-textures", [](Scene& s) {
    s.textures = textures({true, true, true, true, false, true});
    s.texture_scale = {2.5, 1.5};
  });
  changed("all-textures", [](Scene& s) {
    s.surface.emission = {1, 1, 1};
    s.textures = textures({true, true, true, true, true, true});
  });
  for (const Tone tone : {Tone::neutral, Tone::agx_like, Tone::filament, Tone::false_color}) {
    out.push_back({"tone-" + std::string(name(tone)), full_scene(model)});
    out.back().scene.tone = tone;
  }
  return out;
}

std::pair<std::string, int> run(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return {"popen failed", -1};
  std::string out;
  for (int c; (c = std::fgetc(pipe)) != EOF;) out += static_cast<char>(c);
  return {out, pclose(pipe)};
}

}  // namespace etak::test
