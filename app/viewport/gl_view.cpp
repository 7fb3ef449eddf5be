// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/gl_view.h"

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QOpenGLContext>
#include <QScopeGuard>
#include <utility>

#include "app/viewport/gl_program.h"
#include "app/viewport/gl_thread.h"
#include "core/base/error.h"

namespace etak {
namespace {

QSurfaceFormat wanted_format() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(0);
  format.setStencilBufferSize(0);
  format.setSwapInterval(1);
  return format;
}

}  // namespace

QString why_no_gl() {
  // These platforms do not support QOpenGLWidget; some of them end the program.
  for (const char* platform : {"offscreen", "minimal", "vnc", "linuxfb", "minimalegl"})
    if (QGuiApplication::platformName() == QLatin1String(platform))
      return GlView::tr("Qt's platform \"%1\" has no OpenGL.").arg(QLatin1String(platform));
  QOpenGLContext context;
  context.setFormat(wanted_format());
  if (!context.create()) return GlView::tr("OpenGL gives no context.");
  const auto version = context.format().version();
  if (version < qMakePair(3, 3))
    return GlView::tr("OpenGL is %1.%2; 3.3 is needed.").arg(version.first).arg(version.second);
  return {};
}

GlView::GlView(QWidget* parent, bool threaded) : QOpenGLWidget(parent), threaded_(threaded) {
  setFormat(wanted_format());
  setUpdateBehavior(QOpenGLWidget::NoPartialUpdate);
  poll_.setInterval(1);
  connect(&poll_, &QTimer::timeout, this, &GlView::look_for_end);
}

GlView::~GlView() {
  // The base class destroys the context when this part of the object is gone already; the signal of the
  // context must not reach it then.
  if (context() != nullptr) disconnect(context(), nullptr, this, nullptr);
  drop();
}

void GlView::drop() {
  if (!thread_ && !frames_) return;
  makeCurrent();
  thread_.reset();
  frames_.reset();
  forget_read();
  poll_.stop();
  if (end_ != nullptr) current_gl().glDeleteSync(std::exchange(end_, nullptr));
  current_gl().glDeleteFramebuffers(1, &reader_);
  doneCurrent();
  frame_ = {};
  drawing_ = fresh_ = false;
  band_ = -1;
  wanted_ = true;
}

void GlView::show_state(const ViewState& state, const ViewDisplay& display, bool hurry) {
  state_ = state;
  display_ = display;
  hurry_ = hurry;
  wanted_ = true;
  begin();
}

void GlView::initializeGL() {
  try {
    Gl& gl = current_gl();
    gl_name_ = QString::fromStdString(renderer_name(gl));
    gl.glGenFramebuffers(1, &reader_);
    if (threaded_) thread_ = GlThread::beside(*context());
    if (!thread_) frames_ = std::make_unique<GlFrames>(false);
    // Qt makes another context where the window changes; drop() then frees all that belongs to this one.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GlView::drop, Qt::UniqueConnection);
  } catch (const Error& error) {
    emit failed(QString::fromUtf8(error.what()));
  }
  begin();
}

GlJob GlView::next_job() {
  refining_ = !wanted_;
  if (wanted_) {
    wanted_ = false;
    whole_ = picture_size();
    band_ = !hurry_ && has_refined(state_) ? 0 : -1;
    return {state_, display_, whole_, hurry_ ? shares_.next() : 1};
  }
  GlJob out{state_, display_, whole_, 1, band_};
  out.state.refined = true;
  band_ = out.is_last_band() ? -1 : band_ + 1;
  return out;
}

void GlView::begin() {
  if (frames_ && wants_more() && !drawing_) update();  // without a thread, the frame is begun in paintGL()
  if (!thread_ || !wants_more() || drawing_ || picture_size().isEmpty()) return;
  drawing_ = true;
  GlJob job = next_job();
  job.after = std::exchange(read_, nullptr);
  thread_->draw(job, [this](const GlFrame& frame) {
    drawing_ = false;
    take(frame);
    update();
    begin();
  });
}

void GlView::draw_here() {
  drawing_ = true;
  pending_ = frames_->draw(next_job());
  since_.start();
  Gl& gl = current_gl();
  end_ = gl.glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.glFlush();
  poll_.start();
}

void GlView::look_for_end() {
  makeCurrent();
  if (!context()->isValid()) {
    poll_.stop();
    return tell_loss();
  }
  if (current_gl().glClientWaitSync(end_, 0, 0) == GL_TIMEOUT_EXPIRED) return;
  poll_.stop();
  current_gl().glDeleteSync(std::exchange(end_, nullptr));
  drawing_ = false;
  pending_.frame_ms += static_cast<double>(since_.nsecsElapsed()) * 1e-6;
  take(pending_);
  update();
  begin();
}

void GlView::take(const GlFrame& frame) {
  if (frame.context_lost) return tell_loss();
  if (!frame.failed.isEmpty()) emit failed(frame.failed);
  if (!frame.refused.isEmpty()) emit refused(frame.refused);
  if (!frame.failed.isEmpty() || !frame.refused.isEmpty()) band_ = -1;
  if (frame.texture == 0) return;
  const double compile_ms = frame.refined ? frame_.compile_ms : frame.compile_ms;
  frame_ = frame;
  frame_.compile_ms = compile_ms;
  fresh_ = frame.refused.isEmpty() && !frame.refined;
}

void GlView::tell_loss() {
  if (!lost_) emit lost();
  lost_ = true;
}

void GlView::paintGL() {
  if (!thread_ && !frames_) return;
  if (whole_ != picture_size()) wanted_ = true;
  if (frames_ && wants_more() && !drawing_) draw_here();
  begin();
  if (!context()->isValid()) return tell_loss();
  QElapsedTimer timer;
  timer.start();
  show_frame();
  if (!fresh_) return;
  fresh_ = false;
  const double ms = frame_.frame_ms + static_cast<double>(timer.nsecsElapsed()) * 1e-6;
  shares_.took(frame_.share, ms);
  emit drawn(ms);
}

// Shows the last frame. Where the view has another size by now, the frame lies in its middle, not scaled.
void GlView::show_frame() {
  Gl& gl = current_gl();
  const GLuint target = defaultFramebufferObject();
  const QSize view = picture_size();
  gl.glBindFramebuffer(GL_FRAMEBUFFER, target);
  if (frame_.size != view || frame_.texture == 0) {
    gl.glDisable(GL_SCISSOR_TEST);
    gl.glClearColor(frame_.background.redF(), frame_.background.greenF(), frame_.background.blueF(), 1);
    gl.glClear(GL_COLOR_BUFFER_BIT);
  }
  if (frame_.texture == 0) return;
  gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, reader_);
  gl.glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, frame_.texture, 0);
  const QRect from(QPoint(), frame_.size);
  const QRect shown = from.intersected(QRect(
      (from.width() - view.width()) / 2, (from.height() - view.height()) / 2, view.width(), view.height()));
  const int x = (view.width() - shown.width()) / 2, y = (view.height() - shown.height()) / 2;
  gl.glBlitFramebuffer(shown.x(), shown.y(), shown.x() + shown.width(), shown.y() + shown.height(), x, y,
                       x + shown.width(), y + shown.height(), GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.glBindFramebuffer(GL_FRAMEBUFFER, target);
  if (!thread_) return;
  // The thread will draw into this texture again, which must be read before. The GPU waits for that, not this thread.
  forget_read();
  read_ = gl.glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.glFlush();
}

// A later fence of the same context is signalled after this one.
void GlView::forget_read() {
  if (read_ != nullptr) current_gl().glDeleteSync(std::exchange(read_, nullptr));
}

QImage GlView::picture(const ViewState& state, const ViewDisplay& display, const QSize& size) {
  if (!thread_ && !frames_) (void)grabFramebuffer();  // a view that was never shown has no context yet
  const GlJob job{state, display, size, 1};
  if (thread_) return thread_->picture(job);
  if (!frames_) throw Error::at("OpenGL", "gives no picture");
  makeCurrent();
  const auto done = qScopeGuard([this] { doneCurrent(); });
  return frames_->picture(job);
}

}  // namespace etak
