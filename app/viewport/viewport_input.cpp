// SPDX-License-Identifier: Apache-2.0
// The mouse over the viewport; core/render/view_moves.h holds what it does to a state. Keys are in viewport_keys.cpp.
#include <QDragEnterEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "app/viewport/sides.h"
#include "app/viewport/viewport_private.h"
#include "core/base/error.h"
#include "core/color/delta_e.h"
#include "core/color/srgb.h"

namespace etak {
namespace {

constexpr double separator_reach = 6;  // pixels from the separator in which a press drags it
constexpr double mark_reach = 0.15;  // radii from a mark in which a drag does not move it to the cursor first
constexpr double step_of_wheel = 1.1;   // factor of a notch of the wheel
constexpr double zoom_of_drag = 1.005;  // factor of a pixel of a drag

Lab lab_of_codes(const std::array<int, 3>& code) {
  const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
  return to_lab(srgb_decode(Srgb8{byte(code[0]), byte(code[1]), byte(code[2])}));
}

}  // namespace

std::optional<PlaceUnder> Viewport::Private::under(const QPointF& position) const {
  const QSize size = picture_size();
  if (size.isEmpty()) return std::nullopt;
  const double ratio = q.devicePixelRatioF();
  try {
    return place_under(state, size.width(), size.height(), position.x() * ratio, position.y() * ratio);
  } catch (const Error&) {
    return std::nullopt;
  }
}

double Viewport::Private::separator_x() const {
  return state.separator * q.width();
}

bool Viewport::Private::on_separator(const QPointF& position) const {
  return state.split && state.shape != ViewShape::wedge &&
         std::abs(position.x() - separator_x()) <= separator_reach;
}

void Viewport::Private::edited() {
  refresh();
  emit q.state_edited(state, press_id);
}

int Viewport::Private::nearest_light(const ViewPlace& place, double& distance) const {
  int found = hemispheres_mark;
  distance = 1e9;
  for (const LightMark& mark : light_marks(state.lights, state.camera)) {
    const double away = std::hypot(mark.place.x - place.x, mark.place.y - place.y);
    if (away >= distance) continue;
    distance = away;
    found = mark.light;
  }
  return found;
}

void Viewport::Private::begin(Drag kind, const QPointF& position) {
  drag = kind;
  last = position;
  ++press_id;
  if (kind != Drag::light) return;
  const auto at = under(position);
  double distance = 0;
  if (!at || (state.lights.lights.empty() && !state.lights.hemispheres)) {
    drag = Drag::none;
    return;
  }
  held_light = nearest_light(at->place, distance);
  grip = {};
  if (distance < mark_reach)
    for (const LightMark& mark : light_marks(state.lights, state.camera))
      if (mark.light == held_light) grip = {mark.place.x - at->place.x, mark.place.y - at->place.y};
  drag_to(position);
}

void Viewport::Private::drag_to(const QPointF& position) {
  const auto at = under(position);
  if (!at) return;
  const double per_radius = at->radius_pixels / q.devicePixelRatioF();
  const ViewPlace way{(position.x() - last.x()) / per_radius, (last.y() - position.y()) / per_radius};
  // The angle of an orbit follows the pixels that the cursor moved, whatever the zoom.
  const ViewPlace turn{way.x * state.camera.zoom, way.y * state.camera.zoom};
  const ViewState before = state;
  switch (drag) {
    case Drag::none:
      return;
    case Drag::orbit:
      state.camera = orbited(state.camera, turn);
      break;
    case Drag::pan:
      state.camera = panned(state.camera, way);
      break;
    case Drag::zoom:
      state.camera = zoomed(state.camera, std::pow(zoom_of_drag, last.y() - position.y()),
                            {state.camera.pan_x, state.camera.pan_y});
      break;
    case Drag::environment:
      state.environment_turn_deg = turned_environment(state.environment_turn_deg, turn);
      break;
    case Drag::light:
      state.lights =
          moved_light(state.lights, state.camera, held_light, {at->place.x + grip.x, at->place.y + grip.y});
      break;
    case Drag::separator:
      state.separator = std::clamp(position.x() / std::max(1, q.width()), 0.0, 1.0);
      break;
  }
  last = position;
  if (!(state == before)) edited();
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  using Drag = Private::Drag;
  if (d_->drag != Drag::none) return;  // a second button during a drag is ignored
  const QPointF at = event->position();
  const Qt::KeyboardModifiers keys = event->modifiers();
  if (event->button() == Qt::LeftButton) {
    if (keys & Qt::ControlModifier)
      d_->begin(Drag::environment, at);
    else if (keys & Qt::ShiftModifier)
      d_->begin(Drag::light, at);
    else if (d_->on_separator(at))
      d_->begin(Drag::separator, at);
    else
      d_->begin(Drag::orbit, at);
  } else if (event->button() == Qt::MiddleButton) {
    d_->begin(Drag::pan, at);
  } else if (event->button() == Qt::RightButton && (keys & Qt::AltModifier)) {
    d_->begin(Drag::zoom, at);
  } else {
    event->ignore();
    return;
  }
  d_->readout.clear();
  d_->refresh_overlay();
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  if (d_->drag != Private::Drag::none) return d_->drag_to(event->position());
  d_->show_cursor(event->position());
  const bool shift = (event->modifiers() & Qt::ShiftModifier) != 0;
  if (shift != d_->shift_held || d_->light_by_keys) {
    d_->shift_held = shift;
    d_->light_by_keys = false;
    d_->refresh_overlay();
  }
  d_->hover_at = event->position();
  if (!d_->hover_timer.isActive()) d_->hover_timer.start();
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  if (d_->drag == Private::Drag::none) return event->ignore();
  if (event->buttons() != Qt::NoButton) return;
  d_->drag = Private::Drag::none;
  d_->refresh();  // draws the picture at its whole size again
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier)
    reset_camera();
  else
    mousePressEvent(event);
}

void Viewport::wheelEvent(QWheelEvent* event) {
  // Some platforms report the wheel as horizontal while Alt or Shift is held.
  const QPoint angle = event->angleDelta();
  const double notches = (angle.y() != 0 ? angle.y() : angle.x()) / 120.0;
  const auto at = d_->under(event->position());
  if (notches == 0 || !at) return event->ignore();
  const ViewState before = d_->state;
  const double factor = std::pow(step_of_wheel, notches);
  ++d_->press_id;
  if (event->modifiers() & Qt::ShiftModifier) {
    double distance = 0;
    const int light = d_->nearest_light(at->place, distance);
    if (light >= 0) {
      d_->state.lights.lights[static_cast<std::size_t>(light)].intensity *= factor;
    } else if (d_->state.lights.hemispheres) {
      for (Vec3* radiance : {&d_->state.lights.hemispheres->upper, &d_->state.lights.hemispheres->lower})
        for (double& each : *radiance) each *= factor;
    }
  } else {
    d_->state.camera = zoomed(d_->state.camera, factor, at->place);
  }
  event->accept();
  if (!(d_->state == before)) d_->edited();
}

void Viewport::set_flipped(bool on) {
  if (d_->flipped == on) return;
  d_->flipped = on;
  d_->refresh();
}

void Viewport::frame_object() {
  const View before = d_->state.camera;
  d_->state.camera = framed(before);
  if (d_->state.camera == before) return;
  ++d_->press_id;
  d_->edited();
}

void Viewport::reset_camera() {
  if (d_->state.camera == View{}) return;
  d_->state.camera = {};
  ++d_->press_id;
  d_->edited();
}

void Viewport::leaveEvent(QEvent*) {
  d_->hover_timer.stop();
  d_->shift_held = d_->light_by_keys = false;
  d_->readout.clear();
  d_->refresh_overlay();
  emit hover_ended();
}

void Viewport::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  d_->refresh_overlay();
}

void Viewport::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  d_->shift_held = d_->light_by_keys = false;
  set_flipped(false);  // the release of Space will go to another widget
  d_->refresh_overlay();
}

void Viewport::Private::show_cursor(const QPointF& position) {
  q.setCursor(on_separator(position) ? Qt::SplitHCursor : Qt::ArrowCursor);
}

std::optional<PatchUnderCursor> Viewport::patch_at(const QPointF& position) const {
  const QSize size = d_->picture_size();
  const double ratio = devicePixelRatioF();
  const int column = static_cast<int>(position.x() * ratio), row = static_cast<int>(position.y() * ratio);
  if (!QRect(QPoint(), size).contains(column, row) || !d_->display.is_of(d_->state)) return std::nullopt;
  try {
    ViewState state = d_->state;
    if (state.b.specular == nullptr && state.b.diffuse == nullptr) state.b = state.a;
    const ViewPatch patch = patch_under(state, size.width(), size.height(), column, row);
    PatchUnderCursor out;
    out.position = position;
    const auto lab_of = [&](const Image& side, std::array<int, 3>& code) {
      const Vec3 mean = mean_color(side);
      Image pixel(1, 1, 4);
      for (std::size_t c = 0; c < 3; ++c) pixel.values[c] = static_cast<float>(mean[c]);
      const QColor color = shown(pixel, d_->display, 1).pixelColor(0, 0);
      code = {color.red(), color.green(), color.blue()};
      return lab_of_codes(code);
    };
    const Lab a = lab_of(patch.a, out.code_a);
    Lab b = lab_of(patch.b, out.code_b);
    if (d_->shows_photograph()) {
      constexpr double side = 5;
      const auto codes = photograph_codes(d_->photograph, rect(), position, side / ratio);
      if (!codes) return std::nullopt;
      out.code_b = *codes;
      b = lab_of_codes(out.code_b);
    }
    for (std::size_t c = 0; c < 3; ++c) out.difference[c] = out.code_b[c] - out.code_a[c];
    out.delta_e = delta_e2000(a, b);
    out.on_object = std::any_of(patch.a.values.begin(), patch.a.values.end(),
                                [&, i = 0](float v) mutable { return i++ % 4 == 3 && v > 0; });
    return out;
  } catch (const Error&) {
    return std::nullopt;
  }
}

void Viewport::Private::hover() {
  const auto patch = q.patch_at(hover_at);
  if (!patch) return;
  const auto codes = [](const std::array<int, 3>& c, bool sign) {
    QStringList out;
    for (const int each : c) out << (sign && each > 0 ? "+" : "") + QString::number(each);
    return out.join(' ');
  };
  readout = state.split ? tr("A %1   B %2   difference %3   ΔE2000 %4")
                              .arg(codes(patch->code_a, false), codes(patch->code_b, false),
                                   codes(patch->difference, true))
                              .arg(patch->delta_e, 0, 'f', 2)
                        : tr("8 bit %1").arg(codes(patch->code_a, false));
  refresh_overlay();
  emit q.hovered(*patch);
}

void Viewport::Private::refresh_overlay() {
  Overlay::Content content;
  const ViewState shown = shown_state();
  content.left_name = QString::fromStdString(shown.a.label);
  if (state.split && state.shape == ViewShape::wedge)
    content.left_name =
        tr("%1 above, %2 below").arg(content.left_name, QString::fromStdString(shown.b.label));
  if (state.split && state.shape != ViewShape::wedge) {
    content.separator = shows_photograph() && flipped ? 0 : separator_x();
    if (shows_photograph()) content.photograph = photograph;
    content.right_name = QString::fromStdString(shown.b.label);
  }
  if (const bool lights = drag == Drag::light || shift_held || light_by_keys;
      lights && state.shape != ViewShape::wedge) {
    // Places of marks become widget pixels by the place and the scale in the middle of the widget.
    if (const auto middle = under(QPointF(q.width() / 2.0, q.height() / 2.0))) {
      const double radius = middle->radius_pixels / q.devicePixelRatioF();
      for (const LightMark& mark : light_marks(state.lights, state.camera)) {
        const QPointF at(q.width() / 2.0 + (mark.place.x - middle->place.x) * radius,
                         q.height() / 2.0 - (mark.place.y - middle->place.y) * radius);
        const QString name =
            mark.light == hemispheres_mark
                ? tr("hemispheres")
                : tr("%1 %2")
                      .arg(QString::fromUtf8(
                          std::string(
                              etak::name(state.lights.lights[static_cast<std::size_t>(mark.light)].kind))
                              .c_str()))
                      .arg(mark.light + 1);
        const bool held = (drag == Drag::light || light_by_keys) && mark.light == held_light;
        content.marks.push_back({at, name, held});
      }
    }
  }
  content.readout = readout;
  content.angle_zones = state.angle_overlay;
  if (!cpu_note_over || !refusal.isEmpty() || !display_failure.isEmpty()) content.message = message();
  overlay->show_content(std::move(content));
}

QStringList dragged_files(const QMimeData& data) {
  QStringList out;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) out << url.toLocalFile();
  return out;
}

void Viewport::set_drop_filter(std::function<bool(const QStringList&)> can_take) {
  d_->can_take = std::move(can_take);
}

void Viewport::dragEnterEvent(QDragEnterEvent* event) {
  const QStringList paths = dragged_files(*event->mimeData());
  if (event->mimeData()->hasFormat(material_mime) ||
      (!paths.isEmpty() && (!d_->can_take || d_->can_take(paths))))
    event->acceptProposedAction();
  else
    event->ignore();
}

void Viewport::dropEvent(QDropEvent* event) {
  const QMimeData& mime = *event->mimeData();
  if (mime.hasFormat(material_mime)) {
    event->acceptProposedAction();
    emit material_dropped(QString::fromUtf8(mime.data(material_mime)));
    return;
  }
  const QStringList paths = dragged_files(mime);
  if (paths.isEmpty()) return event->ignore();
  event->acceptProposedAction();
  const bool environment = paths.size() == 1 && (paths[0].endsWith(".hdr", Qt::CaseInsensitive) ||
                                                 paths[0].endsWith(".exr", Qt::CaseInsensitive));
  if (environment)
    emit environment_dropped(paths[0]);
  else
    emit textures_dropped(paths);
}

}  // namespace etak
