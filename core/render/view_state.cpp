// SPDX-License-Identifier: Apache-2.0
#include "core/render/view_state.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/render/cpu_renderer.h"
#include "core/render/energy.h"
#include "core/render/environment.h"
#include "core/render/ground_bounce.h"
#include "core/render/mesh/mesh_shape.h"
#include "core/render/surface_textures.h"

namespace etak {
namespace {

// The scene without its surface: everything that both sides share.
Scene frame_of(const ViewState& state, int width, int height) {
  Scene out;
  out.width = width;
  out.height = height;
  out.shape = state.shape == ViewShape::quad ? Shape::quad : Shape::sphere;
  if (out.shape == Shape::sphere) out.mesh = state.mesh;
  out.lights = with_ground(state.lights);
  out.lights.environment = state.environment ? "given" : "";
  out.environment_turn_deg = state.environment_turn_deg;
  out.refined = state.refined;
  out.exposure = state.exposure;
  out.background = state.background;
  out.backdrop = state.backdrop;
  out.tone = state.plain_display() ? state.tone : Tone::plain;
  out.mark_zone = state.zone_overlay;
  out.mark_angles = state.angle_overlay;
  out.view = state.camera;
  out.perspective = state.perspective;
  out.view->zoom *= std::min(1.0, double(width) / height);
  return out;
}

void set_side(const ViewSide& side, bool energy_overlay, Scene& scene) {
  scene.surface = side.surface;
  if (side.textures && side.textures->has.f0) scene.surface.curve.reset();  // F0 is that of the texels
  FittedModels fitted = fit_models(side.specular, side.diffuse, side.overrides, scene.surface);
  scene.specular = fitted.specular;
  scene.diffuse = fitted.diffuse;
  scene.specular_values = std::move(fitted.specular_values);
  scene.diffuse_values = std::move(fitted.diffuse_values);
  scene.textures = side.textures;
  scene.texture_scale = side.texture_scale;
  if (scene.mesh && scene.textures && !scene.mesh->mesh().has_uvs)
    throw Error::at("mesh", "has no UVs", "TEXCOORD_0 in each primitive, by which textures are laid");
  scene.textures = textures_for_pixels(scene);
  // The albedo is computed here, so that the CPU and the GPU mark the same pixels.
  if (energy_overlay) scene.mark_energy = quick_albedo(scene, 17);
}

const Parameter* parameter_named(const ViewSide& side, std::string_view name) {
  for (const Model* model : {side.specular, side.diffuse})
    if (model != nullptr)
      for (const Parameter& each : model->parameters)
        if (each.name == name) return &each;
  return nullptr;
}

// `side` with the parameter of the wedge at `share` of its range.
ViewSide wedge_side(ViewSide side, const std::string& parameter, double share) {
  if (const Parameter* found = parameter_named(side, parameter))
    side.overrides.emplace_back(parameter, std::lerp(found->min, found->max, share));
  else if (parameter == "gloss")
    side.surface.gloss = share;
  else if (parameter == "opacity")
    side.surface.opacity = share;
  else
    throw Error::at("wedge", "no parameter " + printable(parameter),
                    "gloss, opacity or a parameter of the models");
  return side;
}

}  // namespace

bool has_refined(const ViewState& state) {
  return state.environment ? !state.environment->is_quick() : state.lights.hemispheres.has_value();
}

std::vector<ViewTile> view_tiles(const ViewState& state, int width, int height) {
  std::vector<ViewTile> out;
  if (state.shape != ViewShape::wedge) {
    const int middle =
        state.split ? static_cast<int>(std::lround(std::clamp(state.separator, 0.0, 1.0) * width)) : width;
    const auto add = [&](const ViewSide& side, int first, int last) {
      if (first >= last) return;
      ViewTile tile{frame_of(state, width, height), 0, 0, first, last};
      set_side(side, state.energy_overlay, tile.scene);
      validate(tile.scene, true);
      out.push_back(std::move(tile));
    };
    add(state.a, 0, middle);
    add(state.b, middle, width);
    return out;
  }
  if (state.wedge_steps < 2 || state.wedge_steps > 16)
    throw Error::at("wedge", std::to_string(state.wedge_steps) + " steps", "2 to 16");
  const int rows = state.split ? 2 : 1;
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < state.wedge_steps; ++i) {
      const int left = width * i / state.wedge_steps, right = width * (i + 1) / state.wedge_steps;
      const int top = height * row / rows, bottom = height * (row + 1) / rows;
      if (left >= right || top >= bottom) continue;
      ViewTile tile{frame_of(state, right - left, bottom - top), left, top, left, right};
      set_side(wedge_side(row == 0 ? state.a : state.b, state.wedge_parameter,
                          double(i) / (state.wedge_steps - 1)),
               state.energy_overlay, tile.scene);
      validate(tile.scene, true);
      out.push_back(std::move(tile));
    }
  return out;
}

Image draw_view(const ViewState& state, int width, int height, unsigned threads, const RowsDone& rows_done) {
  Image out(width, height, 4);
  Image part;
  for (const ViewTile& tile : view_tiles(state, width, height)) {
    render_cpu(tile.scene, state.environment.get(), threads, Precision::f32, part, rows_done);
    for (int y = 0; y < part.height; ++y)
      for (int x = tile.clip_first; x < tile.clip_last; ++x) {
        const auto from = part.at(x - tile.x, y);
        const auto to = out.at(x, tile.y + y);
        for (std::size_t c = 0; c < 3; ++c) to[c] = from[c] * static_cast<float>(state.exposure);
        to[3] = from[3];
      }
  }
  return out;
}

}  // namespace etak
