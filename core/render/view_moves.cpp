// SPDX-License-Identifier: Apache-2.0
#include "core/render/view_moves.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/math/functions.h"
#include "core/render/camera.h"
#include "core/render/cpu_renderer.h"

namespace etak {
namespace {

constexpr double quarter_turn_deg = 90;

// The angle in [-180, 180), so that numbers stay readable after many turns.
double one_turn(double degrees) {
  return degrees - 360 * std::floor((degrees + 180) / 360);
}

Vec3 to_light(const Light& light) {
  if (light.kind == LightKind::directional) return scaled(light.direction, -1);
  const double length = std::sqrt(dot(light.position, light.position));
  return length > 0 ? scaled(light.position, 1 / length) : Vec3{0, 0, 1};
}

// The place where a mirroring sphere shows what lies in direction `l`: where the normal is the half vector.
ViewPlace highlight(const Vec3& l, const Mat3& axes) {
  Vec3 half{};
  for (std::size_t i = 0; i < 3; ++i) half[i] = l[i] + axes[2][i];
  const double length = std::sqrt(dot(half, half));
  // A light straight behind the object has no highlight; its mark is put at the rim.
  if (length < 1e-9) return {silhouette_limit, 0};
  return {dot(half, axes[0]) / length, dot(half, axes[1]) / length};
}

Vec3 mirrored_at(const ViewPlace& place, const Mat3& axes) {
  const double r = math::hypot(place.x, place.y), scale = r > silhouette_limit ? silhouette_limit / r : 1;
  const double x = place.x * scale, y = place.y * scale, z = std::sqrt(1 - x * x - y * y);
  // 2 (n v) n - v in the camera's axes, where v is (0, 0, 1).
  const Vec3 seen{2 * z * x, 2 * z * y, 2 * z * z - 1};
  Vec3 out{};
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = seen[0] * axes[0][i] + seen[1] * axes[1][i] + seen[2] * axes[2][i];
  return scaled(out, 1 / std::sqrt(dot(out, out)));
}

const ViewTile& tile_at(const std::vector<ViewTile>& tiles, int column, int row) {
  for (const ViewTile& tile : tiles)
    if (column >= tile.clip_first && column < tile.clip_last && row >= tile.y &&
        row < tile.y + tile.scene.height)
      return tile;
  return tiles.front();
}

// The pixels around a place for one side alone, which is drawn at the same place as in the picture of both
// sides.
Image side_patch(ViewState state, const ViewSide& side, int width, int height, int column, int row) {
  state.a = side;
  state.split = state.zone_overlay = state.energy_overlay = state.angle_overlay = false;
  const std::vector<ViewTile> tiles = view_tiles(state, width, height);
  const ViewTile& tile = tile_at(tiles, column, row);
  constexpr int reach = 2;
  const int left = std::max(tile.clip_first, column - reach),
            right = std::min(tile.clip_last, column + reach + 1);
  const int top = std::max(tile.y, row - reach),
            bottom = std::min(tile.y + tile.scene.height, row + reach + 1);
  Image out;
  render_cpu(cropped(tile.scene, left - tile.x, top - tile.y, right - left, bottom - top),
             state.environment.get(), 1, Precision::f32, out);
  for (std::size_t i = 0; i < out.values.size(); ++i)
    if (i % 4 != 3) out.values[i] *= static_cast<float>(state.exposure);
  return out;
}

}  // namespace

PlaceUnder place_under(const ViewState& state, int width, int height, double column, double row) {
  const std::vector<ViewTile> tiles = view_tiles(state, width, height);
  const ViewTile& tile =
      tile_at(tiles, static_cast<int>(std::floor(column)), static_cast<int>(std::floor(row)));
  const Camera camera(tile.scene);
  return {{camera.x(column - tile.x), camera.y(row - tile.y)}, 1 / camera.pixel()};
}

View orbited(const View& view, const ViewPlace& way) {
  View out = view;
  out.turn_deg = one_turn(view.turn_deg - quarter_turn_deg * way.x);
  out.rise_deg = std::clamp(view.rise_deg - quarter_turn_deg * way.y, -90.0, 90.0);
  return out;
}

View panned(const View& view, const ViewPlace& way) {
  View out = view;
  out.pan_x -= way.x;
  out.pan_y -= way.y;
  return out;
}

View zoomed(const View& view, double factor, const ViewPlace& fixed) {
  View out = view;
  out.zoom = std::clamp(view.zoom * factor, 0.05, 50.0);
  const double share = view.zoom / out.zoom;
  out.pan_x = fixed.x - (fixed.x - view.pan_x) * share;
  out.pan_y = fixed.y - (fixed.y - view.pan_y) * share;
  return out;
}

View framed(const View& view) {
  return {view.turn_deg, view.rise_deg, 0, 0, 1};
}

View on_turntable(const View& view, int number, int count) {
  View out = view;
  out.turn_deg = one_turn(view.turn_deg + 360.0 * number / count);
  return out;
}

std::string on_turntable(const std::string& path, int number, int count) {
  const std::string digits = std::to_string(number + 1), most = std::to_string(count);
  const std::size_t ending = path.rfind('.');
  return path.substr(0, ending) + '_' + std::string(most.size() - digits.size(), '0') + digits +
         path.substr(ending);
}

double turned_environment(double turn_deg, const ViewPlace& way) {
  return one_turn(turn_deg + quarter_turn_deg * way.x);
}

std::vector<LightMark> light_marks(const LightSetup& setup, const View& view) {
  const Mat3 axes = camera_axes(view);
  std::vector<LightMark> out;
  for (std::size_t i = 0; i < setup.lights.size(); ++i)
    out.push_back({static_cast<int>(i), highlight(to_light(setup.lights[i]), axes)});
  if (setup.hemispheres) out.push_back({hemispheres_mark, highlight(setup.hemispheres->axis, axes)});
  return out;
}

LightSetup moved_light(const LightSetup& setup, const View& view, int mark, const ViewPlace& place) {
  const Vec3 l = mirrored_at(place, camera_axes(view));
  LightSetup out = setup;
  if (mark == hemispheres_mark) {
    if (out.hemispheres) out.hemispheres->axis = l;
    return out;
  }
  if (mark < 0 || mark >= static_cast<int>(setup.lights.size()))
    throw Error::at("lights", "no light " + std::to_string(mark));
  Light& light = out.lights[static_cast<std::size_t>(mark)];
  if (light.kind != LightKind::directional)
    light.position = scaled(l, std::sqrt(dot(light.position, light.position)));
  if (light.kind != LightKind::point) light.direction = scaled(l, -1);
  return out;
}

Scene cropped(const Scene& scene, int x, int y, int width, int height) {
  const Camera camera(scene);
  Scene out = scene;
  out.width = width;
  out.height = height;
  View view = scene.view.value_or(View{});
  view.zoom *= double(scene.height) / height;
  view.pan_x = (width / 2.0 - (camera.centre_column() - x)) * camera.pixel();
  view.pan_y = ((camera.centre_row() - y) - height / 2.0) * camera.pixel();
  out.view = view;
  return out;
}

Vec3 mean_color(const Image& picture) {
  Vec3 sum{};
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) sum[c] += double{picture.at(x, y)[c]};
  return scaled(sum, 1.0 / std::max<double>(1, static_cast<double>(picture.pixel_count())));
}

ViewPatch patch_under(const ViewState& state, int width, int height, int column, int row) {
  if (state.shape == ViewShape::wedge && state.split) {
    // Each side is one of the two rows of spheres.
    height = std::max(1, height / 2);
    row %= height;
  }
  return {side_patch(state, state.a, width, height, column, row),
          side_patch(state, state.b, width, height, column, row)};
}

}  // namespace etak
