// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/viewport.h"

#include <QPainter>
#include <QResizeEvent>

#include "app/viewport/background.h"
#include "app/viewport/sides.h"
#include "app/viewport/viewport_private.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/glsl/glsl_text.h"

namespace etak {

Viewport::Viewport(QWidget* parent, Backend backend) : QWidget(parent), d_(std::make_unique<Private>(*this)) {
  qRegisterMetaType<ViewState>();
  qRegisterMetaType<PatchUnderCursor>();
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAcceptDrops(true);
  setAccessibleName(tr("Viewport"));
  setAccessibleDescription(tr(
      "Picture of the material. Drag to orbit, Shift and drag to move a light, Ctrl and drag to turn the environment, F to frame, Space to see the other side."));
  d_->overlay = new Overlay(this);
  d_->hover_timer.setSingleShot(true);
  d_->hover_timer.setInterval(30);
  connect(&d_->hover_timer, &QTimer::timeout, this, [this] { d_->hover(); });
  const QString why = backend == Backend::cpu ? tr("The CPU was asked for.") : why_no_gl();
  d_->gl_threaded = backend == Backend::automatic;
  if (why.isEmpty())
    d_->use_gl();
  else
    d_->use_cpu(why);
}

Viewport::~Viewport() {
  // The views are deleted first: their last signals must not reach an object that is partly destroyed.
  delete d_->gl;
  delete d_->cpu;
}

void Viewport::Private::use_gl() {
  delete gl;
  gl = new GlView(&q, gl_threaded);
  gl->setAttribute(Qt::WA_TransparentForMouseEvents);
  gl->setFocusPolicy(Qt::NoFocus);
  gl->setGeometry(q.rect());
  gl->show();
  overlay->raise();
  QObject::connect(gl, &GlView::drawn, &q, [this](double ms) {
    frame_ms = ms;
    refusal.clear();
    tell_message();
    emit q.frame_drawn(ms);
  });
  QObject::connect(gl, &GlView::refused, &q, [this](const QString& why) {
    refusal = why;
    tell_message();
  });
  // These signals are queued, because they come while the view draws, and their slots delete the view.
  QObject::connect(
      gl, &GlView::failed, &q, [this](const QString& why) { use_cpu(why); }, Qt::QueuedConnection);
  QObject::connect(gl, &GlView::lost, &q, &Viewport::recover_from_lost_context, Qt::QueuedConnection);
  refresh();
}

void Viewport::Private::use_cpu(const QString& why) {
  no_gl = why;
  delete gl;
  gl = nullptr;
  QTimer::singleShot(cpu_note_ms, &q, [this] {
    cpu_note_over = true;
    refresh_overlay();
  });
  refresh();
  emit q.backend_changed(false);
}

void Viewport::Private::make_cpu() {
  cpu = new CpuView(&q);
  cpu->setAttribute(Qt::WA_TransparentForMouseEvents);
  cpu->setGeometry(q.rect());
  cpu->show();
  overlay->raise();
  QObject::connect(cpu, &CpuView::drawn, &q, [this](double ms) {
    frame_ms = ms;
    refusal.clear();
    tell_message();
    emit q.frame_drawn(ms);
  });
  QObject::connect(cpu, &CpuView::refused, &q, [this](const QString& message) {
    refusal = message;
    tell_message();
  });
}

void Viewport::recover_from_lost_context() {
  if (d_->gl == nullptr) return;
  if (++d_->contexts_lost > 1) return d_->use_cpu(tr("OpenGL lost its context twice."));
  d_->use_gl();
}

ViewState Viewport::Private::shown_state() const {
  ViewState out = state;
  if (flipped && !shows_photograph() && (out.b.specular != nullptr || out.b.diffuse != nullptr))
    std::swap(out.a, out.b);
  return out;
}

void Viewport::Private::refresh() {
  if (state.plain_display()) {
    display = etak::open_display("", "", "", state.tone);
    display_failure.clear();
  } else if (!display.is_of(state)) {
    open_display();
  }
  const bool hurry = q.is_hurried();
  const bool by_cpu = draws_by_cpu();
  if (by_cpu && cpu == nullptr) make_cpu();
  if (cpu != nullptr) cpu->setVisible(by_cpu);
  if (gl != nullptr) gl->setVisible(!by_cpu);
  if (by_cpu)
    cpu->show_state(shown_state(), display, hurry);
  else
    gl->show_state(shown_state(), display, hurry);
  refresh_overlay();
  tell_message();
}

// Opens the display of the state in a thread, because a config takes a tenth of a second to read. The last
// display stays in use until then.
void Viewport::Private::open_display() {
  if (opening) return;
  opening = true;
  struct Opened {
    ViewDisplay display;
    QString failure;
  };
  in_background(
      openers, &q,
      [config = state.ocio_config, name = state.ocio_display, view = state.ocio_view] {
        Opened out{{config, name, view, nullptr, nullptr, Tone::plain}, {}};
        out.failure = failure_of([&] { out.display = etak::open_display(config, name, view); });
        return out;
      },
      [this](const Opened& opened) {
        opening = false;
        if (!opened.display.is_of(state)) return refresh();  // the state names another display by now
        display = opened.display;
        display_failure = opened.failure;
        refresh();
      });
}

QString Viewport::Private::message() const {
  if (!refusal.isEmpty()) return refusal;
  if (!display_failure.isEmpty()) return display_failure;
  return no_gl.isEmpty() ? QString() : tr("Drawn by the CPU. %1").arg(no_gl);
}

void Viewport::Private::tell_message() {
  const QString now = message();
  if (now == last_message) return;
  last_message = now;
  refresh_overlay();
  emit q.message_changed(now);
}

QSize Viewport::Private::picture_size() const {
  return q.size() * q.devicePixelRatioF();
}

void Viewport::set_state(const ViewState& state, const QAbstractSlider* dragged) {
  if (state == d_->state) return;
  if (dragged != nullptr && dragged->isSliderDown() && d_->slider != dragged) {
    d_->slider = dragged;
    connect(
        dragged, &QAbstractSlider::sliderReleased, this,
        [this] {
          d_->slider.clear();
          d_->refresh();  // draws the picture at its whole size again
        },
        Qt::SingleShotConnection);
  }
  // The readout names the colours under the cursor until the cursor moves: the difference to a side that is
  // gone must not stay there.
  if (state.split != d_->state.split) d_->readout.clear();
  d_->state = state;
  d_->refusal.clear();
  d_->refresh();
}

const ViewState& Viewport::state() const {
  return d_->state;
}

void Viewport::set_photograph(const QImage& photograph) {
  d_->photograph = photograph;
  d_->refresh();
}

std::function<DifferencePicture()> Viewport::difference_work(int width) const {
  const QSize size(width, std::max(1, width * height() / std::max(1, this->width())));
  return [state = d_->state, display = d_->display, photograph = d_->photograph, size] {
    return difference_of_sides(state, display, photograph, size);
  };
}

SavedView Viewport::saved_view() const {
  return {d_->shown_state(), d_->display, d_->shows_photograph() ? d_->photograph : QImage(),
          d_->photograph_from(), d_->picture_size()};
}

QImage Viewport::grab_picture(bool refined) {
  const QSize size = d_->picture_size();
  ViewState state = d_->shown_state();
  state.refined = refined;
  try {
    if (!d_->display.is_of(d_->state)) {
      const ViewState& s = d_->state;
      d_->openers.waitForDone();
      d_->display = etak::open_display(s.ocio_config, s.ocio_display, s.ocio_view, s.tone);
    }
    QImage out = d_->draws_by_cpu() ? cpu_picture(state, d_->display, size, thread_count(0))
                                    : d_->gl->picture(state, d_->display, size);
    if (d_->shows_photograph()) {
      QPainter painter(&out);
      paint_photograph(painter, d_->photograph, out.rect(), d_->photograph_from() * out.width());
    }
    return out;
  } catch (const Error& error) {
    d_->refusal = QString::fromUtf8(error.what());
    d_->tell_message();
  }
  QImage out(size.expandedTo(QSize(1, 1)), QImage::Format_RGB888);
  out.fill(QColor(51, 51, 51));
  return out;
}

bool Viewport::is_refining() const {
  return is_drawing() || (d_->draws_by_cpu() ? d_->cpu->is_refining() : d_->gl->is_refining());
}

bool Viewport::is_hurried() const {
  return d_->drag != Private::Drag::none || (d_->slider && d_->slider->isSliderDown());
}

bool Viewport::is_drawing() const {
  return d_->opening || (d_->draws_by_cpu() ? d_->cpu->is_drawing() : d_->gl->is_drawing());
}
bool Viewport::uses_gl() const {
  return !d_->draws_by_cpu();
}
QString Viewport::gl_name() const {
  return d_->gl == nullptr ? QString() : d_->gl->gl_name();
}
QString Viewport::fallback_reason() const {
  return d_->gl != nullptr && d_->draws_by_cpu() ? tr("Meshes are drawn by the CPU.") : d_->no_gl;
}
QString Viewport::message() const {
  return d_->message();
}
QString Viewport::readout() const {
  return d_->readout;
}
double Viewport::compile_ms() const {
  return d_->gl == nullptr ? 0 : d_->gl->compile_ms();
}
double Viewport::frame_ms() const {
  return d_->frame_ms;
}

QString Viewport::shader_text() const {
  try {
    const QSize size = d_->picture_size().expandedTo(QSize(1, 1));
    const std::vector<ViewTile> tiles = view_tiles(d_->shown_state(), size.width(), size.height());
    if (tiles.empty()) return {};
    GlslDisplay shown;
    if (d_->display.gpu) shown = {d_->display.gpu->text, d_->display.gpu->function, "OpenColorIO"};
    const GlslText text =
        glsl_text(tiles.front().scene, GlslVersion::core_330, d_->display.gpu ? &shown : nullptr);
    QString out;
    for (const bool in : {true, false}) {
      out += in ? tr("// In the shader:\n") : tr("// Left out:\n");
      for (const GlslFeature& each : text.features)
        if (each.in == in)
          out += QStringLiteral("//   %1: %2\n")
                     .arg(QString::fromStdString(each.name), QString::fromStdString(each.reason));
    }
    return out + '\n' + QString::fromStdString(text.fragment);
  } catch (const Error& error) {
    return QString::fromUtf8(error.what());
  }
}

QSize Viewport::sizeHint() const {
  return {640, 640};
}
QSize Viewport::minimumSizeHint() const {
  return {160, 160};
}

void Viewport::resizeEvent(QResizeEvent*) {
  if (d_->gl != nullptr) d_->gl->setGeometry(rect());
  if (d_->cpu != nullptr) d_->cpu->setGeometry(rect());
  d_->overlay->setGeometry(rect());
  d_->refresh_overlay();
}

}  // namespace etak
