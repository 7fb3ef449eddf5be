// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/sides.h"

#include <QPainter>
#include <algorithm>

#include "core/color/srgb.h"

namespace etak {
namespace {

const QColor beside_photograph(51, 51, 51);

// The codes of a picture as linear light, with the coverage of another one.
Image seen(const QImage& codes, const Image& covered) {
  Image out(covered.width, covered.height, 4);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const QColor color = codes.pixelColor(x, y);
      const std::array<int, 3> code{color.red(), color.green(), color.blue()};
      for (std::size_t c = 0; c < 3; ++c) out.at(x, y)[c] = static_cast<float>(srgb_decode(code[c] / 255.0));
      out.at(x, y)[3] = covered.at(x, y)[3];
    }
  return out;
}

}  // namespace

QRectF photograph_place(const QImage& photograph, const QRectF& view) {
  const QSizeF size = QSizeF(photograph.size()).scaled(view.size(), Qt::KeepAspectRatio);
  QRectF out(QPointF(), size);
  out.moveCenter(view.center());
  return out;
}

void paint_photograph(QPainter& painter, const QImage& photograph, const QRectF& view, double from) {
  painter.save();
  painter.setClipRect(QRectF(QPointF(from, view.top()), view.bottomRight()));
  painter.fillRect(view, beside_photograph);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(photograph_place(photograph, view), photograph);
  painter.restore();
}

std::optional<std::array<int, 3>> photograph_codes(const QImage& photograph, const QRectF& view,
                                                   const QPointF& at, double side) {
  const QRectF place = photograph_place(photograph, view);
  if (!place.contains(at)) return std::nullopt;
  const double scale = photograph.width() / place.width();
  const QPointF middle = (at - place.topLeft()) * scale;
  const double reach = side * scale / 2;
  const QRect patch = QRectF(middle - QPointF(reach, reach), middle + QPointF(reach, reach))
                          .toAlignedRect()
                          .intersected(photograph.rect());
  if (patch.isEmpty()) return std::nullopt;
  std::array<double, 3> sum{};
  for (int y = patch.top(); y <= patch.bottom(); ++y)
    for (int x = patch.left(); x <= patch.right(); ++x) {
      const QColor color = photograph.pixelColor(x, y);
      sum[0] += srgb_decode(color.redF());
      sum[1] += srgb_decode(color.greenF());
      sum[2] += srgb_decode(color.blueF());
    }
  const double count = static_cast<double>(patch.width()) * patch.height();
  std::array<int, 3> out{};
  for (std::size_t c = 0; c < 3; ++c) out[c] = srgb_u8(sum[c] / count);
  return out;
}

DifferencePicture difference_of_sides(ViewState state, const ViewDisplay& display, const QImage& photograph,
                                      const QSize& size) {
  state.split = state.zone_overlay = state.energy_overlay = state.angle_overlay = false;
  state.refined = has_refined(state);
  Image drawn = draw_view(state, size.width(), size.height(), 1);
  const QImage codes = shown(drawn, display, 1);
  QImage other;
  if (photograph.isNull()) {
    state.a = state.b;
    other = cpu_picture(state, display, size, 1);
  } else {
    other = QImage(size, QImage::Format_RGB888);
    const QRectF view(QPointF(), size);
    QPainter painter(&other);
    paint_photograph(painter, photograph, view, 0);
    painter.end();
    const QRect judged = photograph_place(photograph, view).toAlignedRect().adjusted(1, 1, -1, -1);
    for (int y = 0; y < drawn.height; ++y)
      for (int x = 0; x < drawn.width; ++x)
        if (!judged.contains(x, y)) drawn.at(x, y)[3] = 0;
  }
  return difference_picture(seen(other, drawn), seen(codes, drawn), 1);
}

}  // namespace etak
