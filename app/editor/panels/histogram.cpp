// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/histogram.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "app/viewport/qt_text.h"
#include "core/base/number.h"
#include "core/color/luminance.h"
#include "core/color/srgb.h"
#include "core/image/linear_tables.h"
#include "core/judge/settings.h"

namespace etak::editor {
namespace {

constexpr int bar_height = 48;

}  // namespace

Histogram::Histogram(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Histogram"));
  setFixedHeight(bar_height);
  setMinimumWidth(64);
}

void Histogram::show_picture(const QImage& picture, bool f0) {
  counts_ = {};
  grey_ = true;
  f0_ = f0;
  summary_.clear();
  const ZoneSettings zone;
  const auto& linear = linear_tables().srgb;
  const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
  double sum = 0, inside = 0;
  int least = 255, most = 0;
  for (int y = 0; y < rgb.height(); ++y) {
    const uchar* row = rgb.constScanLine(y);
    for (int x = 0; x < rgb.width(); ++x, row += 3) {
      for (std::size_t c = 0; c < 3; ++c) {
        ++counts_[c][row[c]];
        sum += row[c];
      }
      const auto [low, high] = std::minmax({int{row[0]}, int{row[1]}, int{row[2]}});
      grey_ = grey_ && low == high;
      least = std::min(least, low);
      most = std::max(most, high);
      if (!f0) continue;
      const double y_f0 =
          luminance_of(double{linear[row[0]]}, double{linear[row[1]]}, double{linear[row[2]]});
      if (y_f0 > zone.low && y_f0 < zone.high) ++inside;
    }
  }
  const double all = double(rgb.width()) * rgb.height();
  if (all > 0) {
    summary_ = tr("codes %1 to %2, mean %3").arg(least).arg(most).arg(qt_text(number(sum / (3 * all), 3)));
    if (f0) summary_ += tr("; %1 % in the forbidden zone").arg(qt_text(number(100 * inside / all, 3)));
  }
  setAccessibleDescription(summary_);
  setToolTip(summary_);
  update();
}

void Histogram::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor(40, 40, 40));
  if (summary_.isEmpty()) return;
  const double step = width() / 256.0;
  if (f0_) {
    const ZoneSettings zone;
    const double from = srgb_u8(zone.low) * step, to = (srgb_u8(zone.high) + 1) * step;
    painter.fillRect(QRectF(from, 0, to - from, bar_height), QColor(150, 60, 50));
  }
  int largest = 1;
  for (const auto& channel : counts_) largest = std::max(largest, *std::ranges::max_element(channel));
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setCompositionMode(QPainter::CompositionMode_Plus);
  const std::array colors{QColor(200, 60, 60), QColor(60, 180, 60), QColor(70, 90, 220)};
  for (std::size_t c = 0; c < (grey_ ? 1 : 3); ++c) {
    QPainterPath path(QPointF(0, bar_height));
    // Roots, so that a few texels beside a large plateau are seen.
    for (std::size_t code = 0; code < 256; ++code) {
      const double top = bar_height - (bar_height - 2) * std::sqrt(double(counts_[c][code]) / largest);
      path.lineTo(double(code) * step, top);
      path.lineTo(double(code + 1) * step, top);
    }
    path.lineTo(width(), bar_height);
    painter.fillPath(path, grey_ ? QColor(170, 170, 170) : colors[c]);
  }
}

}  // namespace etak::editor
