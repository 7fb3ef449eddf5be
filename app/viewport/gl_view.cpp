// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/gl_view.h"

#include <QGuiApplication>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <array>

#include "core/base/error.h"

namespace etak {
namespace {

constexpr double fluid_ms = 33;

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
  // On these a QOpenGLWidget is not supported, or ends the program.
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

GlView::GlView(QWidget* parent) : QOpenGLWidget(parent) {
  setFormat(wanted_format());
  setUpdateBehavior(QOpenGLWidget::NoPartialUpdate);
}

GlView::~GlView() {
  drop_painter();
}

void GlView::drop_painter() {
  if (!painter_) return;
  makeCurrent();
  painter_.reset();
  doneCurrent();
}

void GlView::show_state(const ViewState& state, const ViewDisplay& display, bool hurry) {
  state_ = state;
  display_ = display;
  hurry_ = hurry;
  update();
}

void GlView::initializeGL() {
  try {
    painter_ = std::make_unique<GlPainter>();
    gl_name_ = QString::fromStdString(painter_->name());
    // Qt makes another context where the window changes; what belongs to this one goes with it.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GlView::drop_painter,
            Qt::UniqueConnection);
  } catch (const Error& error) {
    painter_.reset();
    emit failed(QString::fromUtf8(error.what()));
  }
}

void GlView::paintGL() {
  if (!painter_) return;
  const QSize whole = picture_size();
  const bool half = hurry_ && whole_ms_ > fluid_ms;
  const QSize size = half ? QSize((whole.width() + 1) / 2, (whole.height() + 1) / 2) : whole;
  std::vector<ViewTile> tiles;
  try {
    tiles = view_tiles(state_, size.width(), size.height());
  } catch (const Error& error) {
    emit refused(QString::fromUtf8(error.what()));
  }
  try {
    const GlPainter::Drawn drawn_frame =
        half ? painter_->draw_small(tiles, state_.environment, display_, size, whole,
                                    defaultFramebufferObject())
             : painter_->draw(tiles, state_.environment, display_, whole, defaultFramebufferObject());
    if (drawn_frame.context_lost || !context()->isValid()) {
      emit lost();
      return;
    }
    compile_ms_ = painter_->compile_ms();
    // A small frame tells what a whole one would take now: four times as much at most.
    whole_ms_ = half ? 4 * drawn_frame.frame_ms : drawn_frame.frame_ms;
    if (!tiles.empty()) emit drawn(drawn_frame.frame_ms);
  } catch (const Error& error) {
    emit failed(QString::fromUtf8(error.what()));
  }
}

QImage GlView::picture(const QSize& size) {
  if (!painter_) (void)grabFramebuffer();  // a view that was never shown has no context yet
  if (!painter_) throw Error::at("OpenGL", "gives no picture");
  const std::vector<ViewTile> tiles = view_tiles(state_, size.width(), size.height());
  makeCurrent();
  try {
    QImage out = painter_->picture(tiles, state_.environment, display_, size);
    compile_ms_ = painter_->compile_ms();
    doneCurrent();
    return out;
  } catch (...) {
    doneCurrent();
    throw;
  }
}

}  // namespace etak
