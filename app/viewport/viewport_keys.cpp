// SPDX-License-Identifier: Apache-2.0
// Keys of the viewport. With the arrows they do what the mouse does with the same modifier key.
#include <QKeyEvent>
#include <algorithm>

#include "app/viewport/viewport_private.h"

namespace etak {
namespace {

constexpr double step_of_turn = 1.0 / 18;       // radii of a drag, which are 5 degrees
constexpr double step_of_light = 0.05;          // radii
constexpr double step_of_zoom = 1.1;            // a factor
constexpr double step_of_separator = 1 / 64.0;  // of the width

// The way of an arrow key, x to the right and y up; nothing for other keys.
std::optional<ViewPlace> way_of(int key) {
  switch (key) {
    case Qt::Key_Left:
      return ViewPlace{-1, 0};
    case Qt::Key_Right:
      return ViewPlace{1, 0};
    case Qt::Key_Up:
      return ViewPlace{0, 1};
    case Qt::Key_Down:
      return ViewPlace{0, -1};
    default:
      return std::nullopt;
  }
}

ViewPlace scaled(const ViewPlace& way, double factor) {
  return {way.x * factor, way.y * factor};
}

}  // namespace

void Viewport::Private::choose_next_light() {
  const std::vector<LightMark> marks = light_marks(state.lights, state.camera);
  if (marks.empty()) return;
  const auto at = std::ranges::find(marks, held_light, &LightMark::light);
  held_light =
      at == marks.end() || !light_by_keys || at + 1 == marks.end() ? marks.front().light : at[1].light;
  light_by_keys = true;
  refresh_overlay();
}

void Viewport::Private::step_light(const ViewPlace& way) {
  const std::vector<LightMark> marks = light_marks(state.lights, state.camera);
  if (marks.empty()) return;
  auto at = std::ranges::find(marks, held_light, &LightMark::light);
  if (at == marks.end()) at = marks.begin();
  held_light = at->light;
  light_by_keys = true;
  state.lights =
      moved_light(state.lights, state.camera, held_light, {at->place.x + way.x, at->place.y + way.y});
}

bool Viewport::Private::step(int key, Qt::KeyboardModifiers keys) {
  const ViewState before = state;
  const auto way = way_of(key);
  if (way && keys == Qt::AltModifier) {
    state.camera = orbited(state.camera, scaled(*way, step_of_turn));
  } else if (way && keys == Qt::ControlModifier) {
    state.environment_turn_deg = turned_environment(state.environment_turn_deg, scaled(*way, step_of_turn));
  } else if (way && keys == Qt::ShiftModifier) {
    step_light(scaled(*way, step_of_light));
  } else if (key == Qt::Key_Plus || key == Qt::Key_Equal || key == Qt::Key_Minus) {
    const double factor = key == Qt::Key_Minus ? 1 / step_of_zoom : step_of_zoom;
    state.camera = zoomed(state.camera, factor, {state.camera.pan_x, state.camera.pan_y});
  } else if (keys == Qt::NoModifier && (key == Qt::Key_Comma || key == Qt::Key_Period)) {
    if (!state.split || state.shape == ViewShape::wedge) return true;
    state.separator = std::clamp(
        state.separator + (key == Qt::Key_Comma ? -step_of_separator : step_of_separator), 0.0, 1.0);
  } else {
    return false;
  }
  if (state == before) return true;
  // Steps that follow each other closely are one press, as those of a held key are.
  constexpr qint64 pause_ms = 800;
  const int pressed = key | static_cast<int>(keys);
  if (pressed != last_key || !key_pause.isValid() || key_pause.elapsed() > pause_ms) ++press_id;
  last_key = pressed;
  key_pause.start();
  edited();
  return true;
}

void Viewport::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Shift) {
    d_->shift_held = true;
    d_->refresh_overlay();
  }
  const Qt::KeyboardModifiers keys = event->modifiers() & ~Qt::KeypadModifier;
  if (d_->drag == Private::Drag::none && d_->step(event->key(), keys)) return;
  if (keys == Qt::NoModifier && event->key() == Qt::Key_F) return frame_object();
  if (keys == Qt::NoModifier && event->key() == Qt::Key_L) return d_->choose_next_light();
  if (keys == Qt::NoModifier && event->key() == Qt::Key_Space) {
    if (!event->isAutoRepeat()) set_flipped(true);
    return;
  }
  event->ignore();  // the window handles arrows without modifiers and all other keys
}

void Viewport::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Shift) {
    d_->shift_held = false;
    d_->refresh_overlay();
  }
  if (event->key() == Qt::Key_Space) {
    if (!event->isAutoRepeat()) set_flipped(false);
    return;
  }
  event->ignore();
}

}  // namespace etak
