// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/image/image.h"
#include "core/render/cpu_renderer.h"
#include "core/render/environment.h"
#include "core/render/scene.h"

namespace etak {

/// One of the two surfaces that a viewport compares.
struct ViewSide {
  SurfaceValues surface;
  const Model* specular = nullptr;                        // null: no specular part
  const Model* diffuse = nullptr;                         // null: none, or `specular` is of kind both
  std::vector<std::pair<std::string, double>> overrides;  // as fit_models() takes them
  std::shared_ptr<const SurfaceTextures> textures;        // null: the surface is the same everywhere
  std::array<double, 2> texture_scale{1, 1};              // as in struct Scene
  std::string label;
  friend bool operator==(const ViewSide&, const ViewSide&) = default;
};

enum class ViewShape { sphere, quad, wedge };

/// Everything that a viewport shows, as a plain value.
struct ViewState {
  ViewSide a, b;
  bool split = false;      // both: a left of the separator, b right of it; in a wedge, a above and b below
  double separator = 0.5;  // share of the width
  ViewShape shape = ViewShape::sphere;
  std::shared_ptr<const MeshShape> mesh;  // in place of spheres; drawn by the CPU alone; null: none
  std::string wedge_parameter = "gloss";  // "gloss", "opacity" or a parameter of a model
  int wedge_steps = 7;                    // spheres in a row, 2 to 16
  LightSetup lights;                      // the environment's file and scale in it are ignored
  std::shared_ptr<const Environment> environment;
  double environment_turn_deg = 0;
  View camera;
  bool perspective = false;                          // as in struct Scene
  bool refined = false;                              // as in struct Scene
  double exposure = 1;                               // linear factor
  std::string ocio_config, ocio_display, ocio_view;  // of OpenColorIO; all three empty: `tone`, then sRGB
  Tone tone = Tone::plain;
  bool zone_overlay = false, energy_overlay = false, angle_overlay = false;
  Vec3 background{0.18, 0.18, 0.18};  // linear
  Backdrop backdrop;
  friend bool operator==(const ViewState&, const ViewState&) = default;

  bool plain_display() const { return ocio_config.empty() && ocio_display.empty() && ocio_view.empty(); }
};

/// Whether the picture has light from all around that is worth refining: a quick environment is soon another.
bool has_refined(const ViewState& state);

/// A scene and the part of the whole picture that shows it.
struct ViewTile {
  Scene scene;
  int x = 0, y = 0;                   // place of the scene's top left corner; rows from the top
  int clip_first = 0, clip_last = 0;  // columns of the whole picture, [first, last), that show it
};

/// The scenes that make up a picture of `state` of `width` x `height` pixels; every pixel belongs to exactly
/// one of them. The object keeps its proportions: in a picture that is higher than wide, it fits the width.
/// Throws Error for states that cannot be drawn.
std::vector<ViewTile> view_tiles(const ViewState& state, int width, int height);

/// Draws the picture on the CPU: linear radiance times exposure over the background, and the object's
/// coverage as fourth channel. Throws Error as view_tiles() does.
///   rows_done   as in render_cpu(); what it throws ends the drawing
Image draw_view(const ViewState& state, int width, int height, unsigned threads,
                const RowsDone& rows_done = {});

}  // namespace etak
