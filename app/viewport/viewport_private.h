// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractSlider>
#include <QElapsedTimer>
#include <QPointer>
#include <QTimer>

#include "app/viewport/background.h"
#include "app/viewport/cpu_view.h"
#include "app/viewport/gl_view.h"
#include "app/viewport/overlay.h"
#include "app/viewport/viewport.h"
#include "core/render/view_moves.h"

namespace etak {

class Viewport::Private {
 public:
  explicit Private(Viewport& viewport) : q(viewport) {}

  Viewport& q;
  ViewState state;
  ViewDisplay display;
  GlView* gl = nullptr;  // either gl or cpu draws; the other is null
  CpuView* cpu = nullptr;
  Overlay* overlay = nullptr;
  QImage photograph;
  QString no_gl, refusal, display_failure;
  QString last_message;
  double frame_ms = 0;
  int contexts_lost = 0;
  bool gl_threaded = true, flipped = false, opening = false;
  bool cpu_note_over = false;  // the note that the CPU draws has been shown long enough

  enum class Drag { none, orbit, pan, zoom, environment, light, separator };
  Drag drag = Drag::none;
  int press_id = 0;
  QPointF last;    // last position of the drag
  ViewPlace grip;  // vector from the cursor to the mark that it drags
  int held_light = 0;
  QPointer<const QAbstractSlider> slider;  // outside of the viewport, which the user drags
  bool shift_held = false;
  bool light_by_keys = false;  // keys move held_light, so that its mark is shown
  QElapsedTimer key_pause;     // since the last step of a key
  int last_key = 0;
  QTimer hover_timer;
  QPointF hover_at;
  QString readout;
  std::function<bool(const QStringList&)> can_take;
  Worker openers;  // the last member, so that its thread ends before the others are destroyed

  void use_gl();
  void use_cpu(const QString& why);
  void make_cpu();
  bool draws_by_cpu() const { return gl == nullptr || state.mesh != nullptr; }
  ViewState shown_state() const;
  void refresh();  // updates picture and overlay
  void refresh_overlay();
  void open_display();  // works in a thread
  void tell_message();
  QString message() const;
  QSize picture_size() const;

  // The place of the scene below a point of the widget; none for a state that cannot be drawn.
  std::optional<PlaceUnder> under(const QPointF& position) const;
  double separator_x() const;
  /// Whether the photograph is shown as side b.
  bool shows_photograph() const {
    return state.split && state.shape != ViewShape::wedge && !photograph.isNull();
  }
  /// From which share of the width on.
  double photograph_from() const { return flipped ? 0 : state.separator; }
  bool on_separator(const QPointF& position) const;
  void edited();  // the user has changed the state: draws it and emits state_edited()
  void begin(Drag kind, const QPointF& position);
  void drag_to(const QPointF& position);
  /// Does what a key does to the state. Returns whether the key is one of the viewport.
  bool step(int key, Qt::KeyboardModifiers keys);
  void step_light(const ViewPlace& way);
  void choose_next_light();
  int nearest_light(const ViewPlace& place, double& distance) const;
  void hover();
  void show_cursor(const QPointF& position);
};

}  // namespace etak
