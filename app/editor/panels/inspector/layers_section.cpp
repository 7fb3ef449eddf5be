// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/inspector/layers_section.h"

#include <QLineEdit>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionSlider>
#include <cmath>

#include "app/curves/line_plot_widget.h"
#include "app/fields/add_button.h"
#include "app/fields/number_field.h"
#include "app/viewport/qt_text.h"
#include "core/base/error.h"
#include "core/color/srgb.h"
#include "core/material/seen_stack.h"
#include "core/pages/material_plots.h"

namespace etak::editor {
namespace {

constexpr std::size_t strip_colors = 96;
constexpr double plot_step_deg = 2;
constexpr double most_typed_nm = 1e9;

// The end of a slider for a layer: above its thickness, of the steps 500, 1000, 2000, 5000, ... nm.
double slider_end(double nm) {
  for (double decade = 500;; decade *= 10)
    for (const double factor : {1.0, 2.0, 4.0})
      if (nm <= decade * factor) return decade * factor;
}

// What a worker computes for the section: the colours over each layer's slider, and the plots.
struct Seen {
  std::vector<std::vector<QColor>> strips;
  LinePlot reflectance, angles;
  QString failure;
};

Seen seen_of(const std::string& name, const Optics& optics, const F0Options& options,
             const std::vector<double>& most_nm) {
  Seen out;
  out.failure = failure_of([&] {
    if (const auto* stack = std::get_if<Stack>(&optics))
      for (std::size_t layer = 0; layer < most_nm.size(); ++layer) {
        SeenStack seen(*stack, options);
        std::vector<QColor>& strip = out.strips.emplace_back();
        for (std::size_t i = 0; i < strip_colors; ++i) {
          seen.set_thickness(layer, most_nm[layer] * double(i) / (strip_colors - 1));
          const Srgb8 code = srgb_u8(to_rgb(seen(1)));
          strip.emplace_back(code.r, code.g, code.b);
        }
      }
    out.reflectance = reflectance_plot(name, curves_of(optics, options), options.viewing.observer);
    out.angles = angle_plot(name, angle_curves(optics, options, name, plot_step_deg), PlotChannel::luminance);
  });
  return out;
}

}  // namespace

ThicknessStrip::ThicknessStrip(NumberField& field, QWidget* parent) : QWidget(parent), field_(field) {
  setFixedHeight(10);
  setToolTip(tr("The colour at normal incidence over the range of the slider"));
}

void ThicknessStrip::show_colors(std::vector<QColor> colors) {
  colors_ = std::move(colors);
  update();
}

void ThicknessStrip::paintEvent(QPaintEvent*) {
  if (colors_.empty()) return;
  QPainter painter(this);
  // The middle of the slider's handle goes over this range.
  const FieldSlider& slider = field_.slider();
  QStyleOptionSlider option;
  option.initFrom(&slider);
  const double handle = style()->pixelMetric(QStyle::PM_SliderLength, &option, &slider);
  const double left = slider.mapTo(parentWidget(), QPoint(0, 0)).x() - x() + handle / 2,
               wide = std::max(1.0, slider.width() - handle), step = wide / double(colors_.size());
  for (std::size_t i = 0; i < colors_.size(); ++i)
    painter.fillRect(QRectF(left + step * double(i), 0, step + 0.5, height()), colors_[i]);
}

LayersSection::LayersSection(Document& document, QWidget* parent)
    : Section(tr("Layers"), parent),
      document_(document),
      base_(new QLineEdit(this)),
      reflectance_(new LinePlotWidget),
      angles_(new LinePlotWidget),
      plots_(new QWidget(this)) {
  auto* list = new QWidget(this);
  list->setAccessibleName(tr("Layers, the outermost first"));
  list_ = new QVBoxLayout(list);
  list_->setContentsMargins(0, 0, 0, 0);
  add(list);
  add(tr("Base"), base_,
      tr("The material under the layers: an id of the library, ID/DATASET for one dataset"));
  connect(base_, &QLineEdit::editingFinished, this, [this] {
    const std::string wanted = base_->text().trimmed().toStdString();
    if (wanted != stack_.base) edit(tr("base of the layers"), [&](StackText& stack) { stack.base = wanted; });
  });
  QHBoxLayout& line = add_line(tr("Add a layer"));
  connect(add_button(line, tr("Add a layer"), tr("A layer of silica, 100 nm, on top of the others"),
                     tr("Add a layer on top")),
          &QToolButton::clicked, this, [this] {
            edit(tr("add a layer"), [](StackText& stack) {
              StackText::Layer layer;
              layer.name = "fused_silica";
              set_thickness(layer, 100);
              stack.layers.insert(stack.layers.begin(), layer);
            });
          });
  line.addStretch(1);
  plots_->setAccessibleName(tr("Reflectance of the layers"));
  auto* column = new QVBoxLayout(plots_);
  column->setContentsMargins(0, 0, 0, 0);
  for (LinePlotWidget* each : {reflectance_, angles_}) column->addWidget(each);
  add(plots_);
}

void LayersSection::edit(const QString& what, const Change& change, int press_id) {
  const ProjectMaterial* now = document_.material();
  if (now == nullptr || !now->measured || !isEnabled()) return;
  StackText text = stack_;
  change(text);
  ProjectMaterial next = *now;
  const std::size_t slash = text.layers.empty() ? text.base.find('/') : std::string::npos;
  next.measured->material = text.layers.empty() ? text.base.substr(0, slash) : format_stack(text);
  next.measured->dataset = slash == std::string::npos ? "" : text.base.substr(slash + 1);
  const QString failure = failure_of([&] { next = with_measured(next, *document_.library()); });
  if (!failure.isEmpty()) {
    emit told(failure);
    return show_material(now, true);
  }
  document_.edit(document_.current(), next, what, press_id);
}

LayersSection::Row LayersSection::row_of(std::size_t layer) {
  const QString number = QString::number(layer + 1);
  Row row{new QWidget(this), nullptr, nullptr, nullptr};
  row.box->setAccessibleName(tr("Layer %1").arg(number));
  auto* column = new QVBoxLayout(row.box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  auto* line = new QHBoxLayout;
  column->addLayout(line);
  row.medium = new QLineEdit(row.box);
  row.medium->setAccessibleName(tr("Layer %1, medium").arg(number));
  row.medium->setToolTip(tr("An id of the library, ID/DATASET for one dataset"));
  line->addWidget(row.medium, 1);
  connect(row.medium, &QLineEdit::editingFinished, this, [this, layer, medium = row.medium] {
    const std::string wanted = medium->text().trimmed().toStdString();
    if (layer < stack_.layers.size() && wanted != stack_.layers[layer].name)
      edit(tr("medium of a layer"), [&](StackText& stack) { stack.layers[layer].name = wanted; });
  });
  const auto button = [&](const QString& text, const QString& name, const QString& what, bool on,
                          const Change& change) {
    auto* made = add_button(*line, text, name, tr("Layer %1: %2").arg(number, name));
    made->setEnabled(on);
    connect(made, &QToolButton::clicked, this, [this, what, change] { edit(what, change); });
  };
  const auto swap_with = [layer](std::size_t other) {
    return [=](StackText& stack) { std::swap(stack.layers[layer], stack.layers[other]); };
  };
  button(QStringLiteral("\u2191"), tr("outwards"), tr("order of the layers"), layer > 0,
         swap_with(layer - 1));
  button(QStringLiteral("\u2193"), tr("inwards"), tr("order of the layers"), layer + 1 < stack_.layers.size(),
         swap_with(layer + 1));
  button(QStringLiteral("\u00d7"), tr("remove"), tr("remove a layer"), true, [layer](StackText& stack) {
    stack.layers.erase(stack.layers.begin() + static_cast<std::ptrdiff_t>(layer));
  });
  const double now = *stack_.layers[layer].thickness_nm;
  row.thickness = new NumberField(tr("Layer %1, thickness in nm").arg(number),
                                  {0, most_nm_[layer], now, 0, most_typed_nm}, row.box);
  row.strip = new ThicknessStrip(*row.thickness, row.box);
  row.strip->setAccessibleName(tr("Layer %1, colours over its thickness").arg(number));
  column->addWidget(row.strip);
  column->addWidget(row.thickness);
  connect(row.thickness, &NumberField::edited, this, [this, layer](double nm, int press) {
    edit(
        tr("thickness of a layer"), [&](StackText& stack) { set_thickness(stack.layers[layer], nm); }, press);
  });
  return row;
}

void LayersSection::rebuild() {
  for (const Row& row : rows_) {
    row.box->hide();
    row.box->deleteLater();  // one of its buttons may be what was pressed
  }
  rows_.clear();
  for (std::size_t layer = 0; layer < stack_.layers.size(); ++layer) {
    rows_.push_back(row_of(layer));
    list_->addWidget(rows_.back().box);
  }
}

void LayersSection::show_material(const ProjectMaterial* material, bool editable) {
  std::optional<FoundDataset> found;
  StackText text;
  F0Options options;
  const QString failure = failure_of([&] {
    if (material == nullptr || !material->measured) return;
    const MeasuredF0& measured = *material->measured;
    found = find_dataset(*document_.library(), measured.material, measured.dataset, {});
    if (const auto* stack = std::get_if<Stack>(&found->chosen().optics))
      text = parse_stack(stack->text, measured.material);
    else if (std::holds_alternative<OpticalConstants>(found->chosen().optics))
      text.base = measured.material + (measured.dataset.empty() ? "" : "/" + measured.dataset);
    options = f0_options(measured, *document_.library());
  });
  const bool has_layers = failure.isEmpty() && !text.base.empty();
  setVisible(has_layers);
  setEnabled(editable);
  if (!has_layers) return shown_.reset();
  std::vector<double> most;
  for (std::size_t i = 0; i < text.layers.size(); ++i) {
    const double nm = *text.layers[i].thickness_nm;
    const bool fits = rows_.size() == text.layers.size() && nm <= most_nm_[i];
    most.push_back(fits ? most_nm_[i] : slider_end(nm));
  }
  stack_ = std::move(text);
  if (rows_.size() != stack_.layers.size() || most != most_nm_) {
    most_nm_ = std::move(most);
    rebuild();
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i].medium->setText(qt_text(stack_.layers[i].name));
    rows_[i].thickness->show_value(*stack_.layers[i].thickness_nm);
  }
  base_->setText(qt_text(stack_.base));
  for (QWidget* each : std::initializer_list<QWidget*>{base_, plots_})
    rows().setRowVisible(each, !rows_.empty());
  if (shown_ == material->measured) return;
  shown_ = material->measured;
  if (rows_.empty()) return;
  in_background(
      pool_, this,
      [name = material->name, optics = found->chosen().optics, options, most = most_nm_] {
        return seen_of(name, optics, options, most);
      },
      [this, of = *material->measured](Seen&& seen) {
        if (shown_ != of || !seen.failure.isEmpty()) return;
        for (std::size_t i = 0; i < rows_.size() && i < seen.strips.size(); ++i)
          rows_[i].strip->show_colors(std::move(seen.strips[i]));
        reflectance_->set_plot(std::move(seen.reflectance), QStringLiteral(" nm"));
        angles_->set_plot(std::move(seen.angles), QStringLiteral("\u00b0"));
      });
}

}  // namespace etak::editor
