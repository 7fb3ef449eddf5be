// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/viewport.h"

#include <QPainter>

#include "core/base/error.h"
#include "core/render/display.h"

namespace etak {

class Viewport::Private {
 public:
  ViewState state;
  QString message;

  QImage draw(int width, int height) {
    QImage out(width, height, QImage::Format_RGB888);
    try {
      const Image8 codes = to_codes(draw_view(state, width, height, 2), 1, Transfer::srgb);
      for (int y = 0; y < height; ++y)
        std::copy_n(codes.at(0, y).data(), static_cast<std::size_t>(width) * 3, out.scanLine(y));
      message.clear();
    } catch (const Error& error) {
      out.fill(Qt::darkGray);
      message = QString::fromUtf8(error.what());
    }
    return out;
  }
};

Viewport::Viewport(QWidget* parent, Backend) : QWidget(parent), d_(std::make_unique<Private>()) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Viewport"));
  setAcceptDrops(true);
}
Viewport::~Viewport() = default;

void Viewport::set_state(const ViewState& state) {
  d_->state = state;
  update();
}
const ViewState& Viewport::state() const {
  return d_->state;
}
QImage Viewport::grab_picture() {
  return d_->draw(width(), height());
}
bool Viewport::uses_gl() const {
  return false;
}
QString Viewport::gl_name() const {
  return {};
}
QString Viewport::fallback_reason() const {
  return tr("not built yet");
}
QString Viewport::message() const {
  return d_->message;
}
QString Viewport::shader_text() const {
  return {};
}
double Viewport::compile_ms() const {
  return 0;
}
double Viewport::frame_ms() const {
  return 0;
}
std::optional<PatchUnderCursor> Viewport::patch_at(const QPointF&) const {
  return std::nullopt;
}
QSize Viewport::sizeHint() const {
  return {640, 640};
}
QSize Viewport::minimumSizeHint() const {
  return {160, 160};
}
void Viewport::frame_object() {}
void Viewport::reset_camera() {}

void Viewport::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.drawImage(0, 0, d_->draw(width(), height()));
  painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, d_->message);
}

}  // namespace etak
