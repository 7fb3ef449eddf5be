// SPDX-License-Identifier: Apache-2.0
#include "app/curves/plot_widget.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "app/viewport/qt_text.h"
#include "core/base/number.h"

namespace etak::editor {
namespace {

QColor color_of(std::string_view hex) {
  return QColor(QString::fromLatin1(hex.data(), static_cast<qsizetype>(hex.size())));
}

}  // namespace

PlotWidget::PlotWidget(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PlotWidget::plot_changed() {
  setAccessibleName(qt_text(title()));
  setAccessibleDescription(qt_text(description()));
  QString tip = qt_text(description());
  for (const PlotKey& key : keys()) tip += '\n' + qt_text(key.text);
  setToolTip(tip);
  if (cursor_) {
    const auto [least, most] = range();
    if (empty() || *cursor_ < least || *cursor_ > most) cursor_.reset();
    emit readout_changed(readout());
  }
  update();
}

bool PlotWidget::dark() const {
  return palette().color(QPalette::Base).lightness() < 128;
}

const PlotColors& PlotWidget::colors() const {
  return plot_colors(dark());
}

QColor PlotWidget::ink() const {
  return color_of(colors().ink);
}
QColor PlotWidget::ink_soft() const {
  return color_of(colors().ink_soft);
}
QColor PlotWidget::line() const {
  return color_of(colors().line);
}

QPen PlotWidget::pen_of(std::string_view css_class) const {
  const PlotStyle style = plot_style(css_class);
  QPen pen(color_of(colors().series[style.color]), style.dots ? 4.5 : style.bold ? 2.2 : 1.5);
  pen.setCapStyle(Qt::RoundCap);
  pen.setJoinStyle(Qt::RoundJoin);
  // Dash patterns are in units of the pen's width.
  if (style.dash == PlotStyle::Dash::dashed) pen.setDashPattern({4, 3});
  if (style.dash == PlotStyle::Dash::dotted) pen.setDashPattern({0.5, 2.5});
  if (style.dash == PlotStyle::Dash::dashdot) pen.setDashPattern({5, 2.5, 0.5, 2.5});
  return pen;
}

QString PlotWidget::csv_text() const {
  return qt_text(csv_of());
}
QString PlotWidget::svg_text() const {
  return qt_text(svg_of(dark()));
}

void PlotWidget::copy_csv() const {
  QApplication::clipboard()->setText(csv_text());
}

void PlotWidget::copy_svg() const {
  const QString text = svg_text();
  auto* copied = new QMimeData;
  copied->setText(text);
  copied->setData("image/svg+xml", text.toUtf8());
  QApplication::clipboard()->setMimeData(copied);
}

QString PlotWidget::readout() const {
  if (!cursor_ || empty()) return {};
  QString out;
  for (const Reading& each : readings(*cursor_))
    out += (out.isEmpty() ? place_text(*cursor_) + ": " : QString(", ")) + each.name + ' ' +
           qt_text(number(each.value, 4));
  return out;
}

void PlotWidget::set_cursor(std::optional<double> at) {
  if (at) {
    const auto [least, most] = range();
    at = std::clamp(*at, least, most);
  }
  if (at == cursor_) return;
  cursor_ = at;
  const QString text = readout();
  setAccessibleDescription(text.isEmpty() ? qt_text(description()) : text);
  emit readout_changed(text);
  update();
}

std::vector<PlotWidget::Reading> PlotWidget::readings(double at) const {
  std::vector<Reading> out;
  for (const PlotCurve& curve : curves()) {
    const double value = value_at(curve, at);
    if (curve.dots || !std::isfinite(value)) continue;
    out.push_back({qt_text(curve.title), value, pen_of(curve.css_class).color(), place_of(curve, at, value)});
  }
  return out;
}

// ---- drawing

void PlotWidget::draw_curves(QPainter& painter) const {
  painter.setBrush(Qt::NoBrush);
  for (const PlotCurve& curve : curves()) {
    painter.setPen(pen_of(curve.css_class));
    QPainterPath path;
    bool begun = false;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (!std::isfinite(curve.y[i])) {
        begun = false;
        continue;
      }
      const QPointF at = place_of(curve, curve.x[i], curve.y[i]);
      if (curve.dots) {
        painter.drawPoint(at);
      } else if (begun) {
        path.lineTo(at);
      } else {
        path.moveTo(at);
        begun = true;
      }
    }
    painter.drawPath(path);
  }
}

double PlotWidget::legend(QPainter* painter, bool brief) const {
  constexpr double sample = 28, gap = 6, between = 16, edge = 8;
  const QFontMetricsF metrics(font());
  const double row = metrics.height() + 2;
  double x = edge, y = 4;
  for (const PlotKey& key : keys()) {
    const QString text = qt_text(brief && !key.brief.empty() ? key.brief : key.text);
    const double wide = (key.css_class.empty() ? 0 : sample + gap) + metrics.horizontalAdvance(text);
    if (x > edge && x + wide > width() - edge) {
      x = edge;
      y += row;
    }
    if (painter != nullptr) {
      double text_x = x;
      if (!key.css_class.empty()) {
        painter->setPen(pen_of(key.css_class));
        const double middle = y + row / 2;
        if (plot_style(key.css_class).dots)
          painter->drawPoint(QPointF(x + sample / 2, middle));
        else
          painter->drawLine(QPointF(x, middle), QPointF(x + sample, middle));
        text_x += sample + gap;
      }
      painter->setPen(ink());
      painter->drawText(QPointF(text_x, y + metrics.ascent() + 1), text);
    }
    x += wide + between;
  }
  return keys().empty() ? 4 : y + row + 2;
}

void PlotWidget::draw_cursor(QPainter& painter) const {
  painter.setPen(QPen(ink_soft(), 1, Qt::DotLine));
  const QLineF at = cursor_line(*cursor_);
  painter.drawLine(at);
  const std::vector<Reading> all = readings(*cursor_);
  const QFontMetricsF metrics(painter.font());
  double name_width = 0, value_width = 0;
  std::vector<QString> values;
  for (const Reading& each : all) {
    values.push_back(qt_text(number(each.value, 4)));
    name_width = std::max(name_width, metrics.horizontalAdvance(each.name));
    value_width = std::max(value_width, metrics.horizontalAdvance(values.back()));
    painter.setPen(QPen(each.color, 1.2));
    painter.setBrush(color_of(colors().background));
    painter.drawEllipse(each.place, 3.2, 3.2);
  }
  const double row = metrics.height(), pad = 5;
  const QString head = place_text(*cursor_);
  const double wide = std::max(metrics.horizontalAdvance(head), name_width + 10 + value_width) + 2 * pad;
  QRectF box(0, 0, wide, row * (static_cast<double>(all.size()) + 1) + 2 * pad);
  const double x = std::max(at.x1(), at.x2());
  box.moveTopLeft({x + 10 + wide <= width() ? x + 10 : std::min(at.x1(), at.x2()) - 10 - wide,
                   std::min(at.y1(), at.y2()) + 6});
  // The box stands above or below, where fewer of the values are.
  const double low = std::max(at.y1(), at.y2()) - box.height() - 6;
  const auto above = std::count_if(
      all.begin(), all.end(), [&](const Reading& each) { return each.place.y() < (at.y1() + at.y2()) / 2; });
  if (2 * above > static_cast<std::ptrdiff_t>(all.size())) box.moveTop(std::max(box.top(), low));
  box.moveLeft(std::max(box.left(), 2.0));
  box.moveBottom(std::min(box.bottom(), height() - 2.0));
  QColor ground = color_of(colors().background);
  ground.setAlpha(225);
  painter.setPen(QPen(line(), 1));
  painter.setBrush(ground);
  painter.drawRoundedRect(box, 3, 3);
  painter.setPen(ink());
  double y = box.top() + pad + metrics.ascent();
  painter.drawText(QPointF(box.left() + pad, y), head);
  for (std::size_t i = 0; i < all.size(); ++i) {
    y += row;
    painter.setPen(all[i].color);
    painter.drawText(QPointF(box.left() + pad, y), all[i].name);
    painter.setPen(ink());
    painter.drawText(QPointF(box.right() - pad - metrics.horizontalAdvance(values[i]), y), values[i]);
  }
}

void PlotWidget::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), color_of(colors().background));
  if (empty()) {
    painter.setPen(ink_soft());
    painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                     qt_text(description()));
  } else {
    // A legend that would take more than a third of the height is shortened; the tool tip holds all of it.
    const double top = legend(&painter, legend(nullptr, false) > height() / 3.0);
    draw(painter, QRectF(0, top, width(), height() - top));
    if (cursor_) draw_cursor(painter);
  }
  if (hasFocus()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
  }
}

// ---- pointer and keys

// The tooltip is a list of all curves. Below the plot it covers none of them.
bool PlotWidget::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  QToolTip::showText(mapToGlobal(QPoint(0, height())), toolTip(), this);
  return true;
}

void PlotWidget::mouseMoveEvent(QMouseEvent* event) {
  if (!empty()) set_cursor(place_at(event->position()));
}

void PlotWidget::leaveEvent(QEvent* /*event*/) {
  set_cursor(std::nullopt);
}

void PlotWidget::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) return copy_csv();
  if (event->key() == Qt::Key_C && event->modifiers() == (Qt::ControlModifier | Qt::ShiftModifier))
    return copy_svg();
  const auto [least, most] = range();
  const double step = (most - least) / (event->modifiers() & Qt::ShiftModifier ? 20 : 200);
  const double from = cursor_.value_or((least + most) / 2);
  switch (event->key()) {
    case Qt::Key_Left:
      return set_cursor(cursor_ ? from - step : from);
    case Qt::Key_Right:
      return set_cursor(cursor_ ? from + step : from);
    case Qt::Key_Home:
      return set_cursor(least);
    case Qt::Key_End:
      return set_cursor(most);
    case Qt::Key_Escape:
      if (cursor_) return set_cursor(std::nullopt);
      break;
    default:
      break;
  }
  QWidget::keyPressEvent(event);
}

void PlotWidget::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  const QAction* as_csv = menu.addAction(tr("Copy as CSV\tCtrl+C"));
  const QAction* as_svg = menu.addAction(tr("Copy as SVG\tCtrl+Shift+C"));
  const QAction* chosen = menu.exec(event->globalPos());
  if (chosen == as_csv) copy_csv();
  if (chosen == as_svg) copy_svg();
}

void PlotWidget::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  update();
}

void PlotWidget::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  update();
}

}  // namespace etak::editor
