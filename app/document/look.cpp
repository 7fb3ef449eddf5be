// SPDX-License-Identifier: Apache-2.0
#include "app/document/look.h"

#include "core/render/engines.h"

namespace etak::editor {
namespace {

ViewSide side_of(const Document& document, const ProjectMaterial& m, const std::string& model) {
  ViewSide out;
  out.surface = document.surface_of(m);
  out.specular = drawn_model(find_model(model.empty() ? m.specular_model : model), out.surface);
  out.diffuse = find_model(m.diffuse_model);
  if (out.specular != nullptr && out.specular->kind == ModelKind::combined) out.diffuse = nullptr;
  // The material's values for parameters belong to its own model, not to the one that it is compared with.
  if (model.empty() || model == m.specular_model) out.overrides = m.parameters;
  out.texture_scale = m.uv_scale;
  out.label = m.name;
  if (out.specular != nullptr) out.label += ", " + std::string(out.specular->title);
  return out;
}

// Takes the display off, which both ways of looking do.
void take_plain_display(ProjectView& view, Tone tone, const Backdrop& backdrop) {
  view.config.clear();
  view.display.clear();
  view.view.clear();
  view.tone = tone;
  view.backdrop = backdrop;
}

}  // namespace

void take_look(ProjectView& view) {
  take_plain_display(view, Tone::neutral, {true, 0.3, true});
}

void take_measure(ProjectView& view) {
  take_plain_display(view, Tone::plain, {});
  view.background = ProjectView().background;
  view.exposure = 1;
}

bool is_look(const ProjectView& view) {
  ProjectView out = view;
  take_look(out);
  return out == view;
}

bool is_measure(const ProjectView& view) {
  ProjectView out = view;
  take_measure(out);
  return out == view;
}

Project new_project() {
  Project out;
  take_look(out.view);
  return out;
}

ViewState view_state_of(const Document& document, const Look& look,
                        std::shared_ptr<const Environment> environment,
                        std::shared_ptr<const SurfaceTextures> textures,
                        std::shared_ptr<const SurfaceTextures> in_blocks) {
  ViewState out;
  const ProjectView& view = document.project().view;
  ProjectMaterial nothing;
  nothing.name = "no material";
  const ProjectMaterial& m = look.preview                     ? *look.preview
                             : document.material() != nullptr ? *document.material()
                                                              : nothing;
  // The document keeps the surface that was solved last. The current material is solved last, because it is
  // the one that is edited.
  const ProjectMaterial& other = view.compare.pinned ? *view.compare.pinned : m;
  out.b = side_of(document, other, view.compare.model);
  out.a = side_of(document, m, {});
  if (&m == &nothing) out.a.label = out.b.label = nothing.name;  // whatever its model
  if (look.textured && !look.preview) out.a.textures = std::move(textures);
  if (look.textured && !view.compare.pinned) out.b.textures = out.a.textures;
  for (ViewSide* side : {&out.a, &out.b})
    if (side->textures && side->textures->has.emission) side->surface.emission = vec(m.emission);
  out.split = view.compare.on;
  const Engine* engine = find_engine(look.engine);
  if (engine != nullptr) {
    out.a = shown_as(*engine, std::move(out.a));
    if (&m != &nothing) out.a.label = m.name + ", " + std::string(out.a.specular->title);
  }
  if (out.a.textures && in_blocks) {
    out.a.textures = std::move(in_blocks);
    out.a.label += ", BC7";
  }
  if (!look.photograph.empty()) out.b.label = look.photograph;
  if (out.split) {
    out.a.label.insert(0, "A: ");
    out.b.label.insert(0, "B: ");
  }
  out.separator = look.separator;
  out.shape = view.wedge.on               ? ViewShape::wedge
              : view.shape == Shape::quad ? ViewShape::quad
                                          : ViewShape::sphere;
  if (!view.mesh.empty()) out.mesh = look.mesh;
  out.wedge_parameter = view.wedge.parameter;
  out.wedge_steps = view.wedge.steps;
  out.lights = view.lights;
  out.environment = std::move(environment);
  out.environment_turn_deg = view.environment_turn_deg;
  out.camera = look.camera;
  out.perspective = look.perspective;
  out.exposure = view.exposure;
  out.ocio_config = view.config;
  out.ocio_display = view.display;
  out.ocio_view = view.view;
  out.tone = engine != nullptr ? engine->tone : view.tone;
  out.background = vec(view.background);
  out.backdrop = view.backdrop;
  out.zone_overlay = look.zone_overlay;
  out.energy_overlay = look.energy_overlay;
  out.angle_overlay = look.angle_overlay;
  return out;
}

}  // namespace etak::editor
