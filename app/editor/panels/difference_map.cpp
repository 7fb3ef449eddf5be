// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/difference_map.h"

#include <QPainter>

#include "app/viewport/qt_picture.h"
#include "core/color/srgb.h"
#include "core/render/display.h"

namespace etak::editor {

DifferenceMap::DifferenceMap(const QString& name, QWidget* parent) : QLabel(parent) {
  setAccessibleName(name);
  setToolTip(
      tr("dE2000 of each place of the object; the scale below tells which colour is which difference"));
}

void DifferenceMap::show_map(const DifferencePicture& difference) {
  constexpr int gap = 4, bar = 8;
  const QImage map = qt_image(to_codes(difference.map, 1, Transfer::srgb));
  const double ratio = devicePixelRatioF();
  const int text = fontMetrics().height(), width = map.width();
  QPixmap out(QSize(width, map.height() + gap + bar + text) * ratio);
  out.setDevicePixelRatio(ratio);
  out.fill(Qt::transparent);
  QPainter painter(&out);
  painter.setFont(font());
  painter.drawImage(0, 0, map);
  for (int x = 0; x < width; ++x)
    painter.fillRect(
        x, map.height() + gap, 1, bar,
        qt_color(srgb_u8(to_rgb(difference_color(largest_shown_de * x / std::max(1, width - 1))))));
  painter.setPen(palette().color(QPalette::WindowText));
  const QRect below(0, map.height() + gap + bar, width, text);
  painter.drawText(below, Qt::AlignLeft, QStringLiteral("0"));
  painter.drawText(below, Qt::AlignHCenter, QString::number(largest_shown_de / 2));
  painter.drawText(below, Qt::AlignRight, tr("dE %1+").arg(largest_shown_de));
  painter.end();
  setPixmap(out);
  setAccessibleDescription(
      tr("mean dE2000 %1, largest %2").arg(difference.mean_de, 0, 'g', 3).arg(difference.max_de, 0, 'g', 3));
}

}  // namespace etak::editor
