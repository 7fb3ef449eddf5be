// SPDX-License-Identifier: Apache-2.0
#include "app/curves/curves_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QStackedWidget>
#include <QTabWidget>
#include <QtMath>
#include <cmath>
#include <utility>

#include "app/curves/line_plot_widget.h"
#include "app/curves/polar_plot_widget.h"
#include "app/fields/add_button.h"
#include "app/viewport/background.h"
#include "core/base/number.h"

namespace etak::editor {
namespace {

bool same_view(const F0Options& a, const F0Options& b) {
  return a.viewing == b.viewing && a.interpolation == b.interpolation && a.outside.label == b.outside.label &&
         a.outside.index == b.outside.index;
}

constexpr PlotChannel luminance[] = {PlotChannel::luminance};

QLabel* label_for(QWidget* control, const QString& text) {
  auto* label = new QLabel(text);
  label->setBuddy(control);
  control->setAccessibleName(QString(text).remove('&').remove(':'));
  return label;
}

}  // namespace

CurvesPanel::CurvesPanel(QWidget* parent)
    : QWidget(parent),
      tabs_(new QTabWidget),
      beside_tabs_(new QStackedWidget),
      index_(new LinePlotWidget),
      reflectance_(new LinePlotWidget),
      angles_(new LinePlotWidget),
      lobe_(new PolarPlotWidget),
      channel_(new QComboBox),
      scale_(new QCheckBox(tr("lo&g"))),
      light_(new QDoubleSpinBox) {
  tabs_->setAccessibleName(tr("Curves"));
  tabs_->setCornerWidget(beside_tabs_);
  channel_->addItems({tr("Red"), tr("Green"), tr("Blue"), tr("Luminance")});
  channel_->setCurrentIndex(3);
  scale_->setAccessibleName(tr("Logarithmic scale"));
  scale_->setToolTip(tr("Logarithmic scale of the lobe, which shows its foot"));
  light_->setRange(0, 89);
  light_->setValue(45);
  light_->setDecimals(0);
  light_->setSuffix("°");

  tabs_->addTab(with_controls(index_, {}), tr("n, k"));
  tabs_->addTab(with_controls(reflectance_, {}), tr("R(λ)"));
  tabs_->addTab(with_controls(angles_, {label_for(channel_, tr("C&hannel:")), channel_}), tr("F(θ)"));
  tabs_->addTab(with_controls(lobe_, {label_for(light_, tr("&Light at:")), light_, scale_}), tr("Lobe"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(tabs_);

  connect(tabs_, &QTabWidget::currentChanged, beside_tabs_, &QStackedWidget::setCurrentIndex);
  connect(channel_, &QComboBox::currentIndexChanged, this, [this] { show_angles(); });
  connect(scale_, &QCheckBox::toggled, this, [this] { show_lobe(); });
  connect(light_, &QDoubleSpinBox::valueChanged, this, [this] { ask(); });
  for (PlotWidget* plot : {static_cast<PlotWidget*>(index_), static_cast<PlotWidget*>(reflectance_),
                           static_cast<PlotWidget*>(angles_), static_cast<PlotWidget*>(lobe_)})
    connect(plot, &PlotWidget::readout_changed, this, &CurvesPanel::readout_changed);
}

QWidget* CurvesPanel::with_controls(PlotWidget* plot, const std::vector<QWidget*>& controls) {
  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(plot);
  // The controls stand beside the tabs, where they take no height from the plot.
  auto* own = new QWidget;
  auto* row = new QHBoxLayout(own);
  row->setContentsMargins(0, 0, 4, 0);
  row->setSpacing(4);
  row->addStretch();
  for (QWidget* control : controls) row->addWidget(control);
  // One narrow button, since several with words would make the window wider than a small screen.
  QToolButton* const more = add_button(*row, QString(QChar(0x22ef)),
                                       tr("Copy the curves, or keep them beside those of the next material"),
                                       tr("Curves: copy or keep"));
  auto* menu = new QMenu(more);
  menu->addAction(tr("Copy as &CSV"), plot, &PlotWidget::copy_csv);
  menu->addAction(tr("Copy as &SVG"), plot, &PlotWidget::copy_svg);
  if (plot != index_) {
    menu->addSeparator();
    menu->addAction(tr("&Keep these curves"), this, &CurvesPanel::keep);
    menu->addAction(tr("&Forget the kept curves"), this, &CurvesPanel::forget_kept);
  }
  more->setMenu(menu);
  more->setPopupMode(QToolButton::InstantPopup);
  beside_tabs_->addWidget(own);
  return page;
}

PlotWidget* CurvesPanel::current_plot() const {
  return tabs_->currentWidget()->findChild<PlotWidget*>();
}

void CurvesPanel::set_material(const Material& material, const Dataset& dataset, const F0Options& options,
                               double gloss, const Model* model, const std::vector<double>& values) {
  wanted_.optics = dataset.optics;
  wanted_.options = options;
  wanted_.what = material.id + "/" + dataset.id;
  want(material.name, gloss, model, values);
}

void CurvesPanel::set_surface(const QString& name, double gloss, const Model* model,
                              const std::vector<double>& values) {
  wanted_.optics.reset();
  wanted_.what.clear();
  want(name.toStdString(), gloss, model, values);
}

// ---- work

void CurvesPanel::want(const std::string& name, double gloss, const Model* model,
                       const std::vector<double>& values) {
  wanted_.name = name;
  wanted_.gloss = gloss;
  wanted_.model = model;
  wanted_.values = values;
  ask();
}

void CurvesPanel::ask() {
  wanted_.theta_l_deg = light_->value();
  waiting_ = true;
  if (!running_) start();
}

void CurvesPanel::start() {
  waiting_ = false;
  running_ = true;
  Request request = wanted_;
  request.same_optics = has_shown_ && request.what == shown_.what && request.optics == shown_.optics &&
                        same_view(request.options, shown_.options);
  request.time_them = exact_ns_ == 0;
  const auto asked = std::make_shared<const Request>(std::move(request));
  in_background(
      pool_, this, [asked] { return compute(*asked); },
      [this, asked](Result&& result) { take(*asked, std::move(result)); });
}

CurvesPanel::Result CurvesPanel::compute(const Request& request) {
  Result out;
  if (request.optics && !request.same_optics) {
    const QString refusal = failure_of([&] {
      out.optics = curves_of(*request.optics, request.options);
      out.angles = angle_curves(*request.optics, request.options, request.what);
      if (request.time_them) time_angle_curves(*out.angles);
    });
    out.refusal = refusal.toStdString();
  }
  if (request.model != nullptr && request.values.size() == request.model->value_count())
    out.lobe = lobe_curve(*request.model, request.values, request.theta_l_deg);
  return out;
}

void CurvesPanel::take(const Request& request, Result result) {
  running_ = false;
  const bool new_name = request.name != shown_.name;
  if (!request.same_optics) {
    result_.optics = std::move(result.optics);
    result_.angles = std::move(result.angles);
    result_.refusal = std::move(result.refusal);
    if (AngleCurves* const angles = result_.angles ? &*result_.angles : nullptr) {
      if (request.time_them && !angles->exact.empty()) {
        exact_ns_ = angles->exact_ns;
        form_ns_.clear();
        for (const AngleCurve& form : angles->forms) form_ns_.emplace_back(form.id, form.ns);
      }
      // The time is that of n and k.
      if (!angles->exact.empty())
        angles->exact_ns = std::holds_alternative<Stack>(*request.optics) ? 0 : exact_ns_;
      for (AngleCurve& form : angles->forms)
        for (const auto& [id, ns] : form_ns_)
          if (id == form.id) form.ns = ns;
    }
  }
  result_.lobe = std::move(result.lobe);
  shown_ = request;
  has_shown_ = true;
  if (!request.same_optics || new_name) {
    show_optics();
    show_angles();
  }
  show_lobe();
  // A request that has come meanwhile is computed before drawn() is emitted, which speaks of the last
  // request.
  if (waiting_)
    start();
  else
    emit drawn();
}

// ---- kept curves

bool CurvesPanel::Request::operator==(const Request& other) const {
  return name == other.name && what == other.what && optics == other.optics &&
         same_view(options, other.options) && model == other.model && values == other.values;
}

void CurvesPanel::keep() {
  if (!has_shown_) return;
  std::erase_if(kept_, [&](const Kept& each) { return each.request == shown_; });
  kept_.push_back({shown_, result_});
  if (kept_.size() > most_kept) kept_.erase(kept_.begin());
  show_all();
}

void CurvesPanel::forget_kept() {
  kept_.clear();
  show_all();
}

void CurvesPanel::show_all() {
  show_optics();
  show_angles();
  show_lobe();
}

template <class CurveOf>
std::vector<ColorCurve> CurvesPanel::several(const CurveOf& curve_of) const {
  std::vector<ColorCurve> out;
  const auto add = [&](const Request& request, const Result& result) {
    ColorCurve curve = curve_of(request, result);
    if (curve.x.empty()) return;
    curve.title.insert(0, request.what.empty() ? request.name : request.what);
    out.push_back(std::move(curve));
  };
  bool in_hand = true;  // not kept yet
  for (const Kept& each : kept_) {
    add(each.request, each.result);
    in_hand = in_hand && !(each.request == shown_);
  }
  if (in_hand) add(shown_, result_);
  return out;
}

// ---- results to plots

void CurvesPanel::show_optics() {
  const auto nothing = [&](const char* title) {
    LinePlot plot;
    plot.title = shown_.name + title;
    plot.description =
        result_.refusal.empty() ? "no measured data: pick a material of the library" : result_.refusal;
    return plot;
  };
  // A record of reflectance alone has no n and k: R is shown in their place.
  const bool has_index = !result_.optics || !result_.optics->n.empty();
  if (!has_index && tabs_->currentIndex() == 0) index_left_ = true;
  tabs_->setTabEnabled(0, has_index);
  tabs_->setTabToolTip(0, has_index ? QString() : tr("The record has no n and k, but R alone"));
  if (has_index && std::exchange(index_left_, false)) tabs_->setCurrentIndex(0);
  index_->set_plot(result_.optics ? index_plot(shown_.name, *result_.optics) : nothing(": n and k"), " nm");
  const std::vector<ColorCurve> all = several([](const Request&, const Result& result) {
    ColorCurve out;
    if (!result.optics) return out;
    out.x = result.optics->r_nm;
    for (const double value : result.optics->r0) out.rgb.push_back({value, value, value});
    return out;
  });
  const bool compared = !kept_.empty() && !all.empty();
  reflectance_->set_plot(compared ? curves_plot(CurveKind::reflectance, all, luminance, 0)
                         : result_.optics
                             ? reflectance_plot(shown_.name, *result_.optics, shown_.options.viewing.observer)
                             : nothing(": reflectance"),
                         " nm");
}

void CurvesPanel::show_angles() {
  const PlotChannel channel[] = {static_cast<PlotChannel>(channel_->currentIndex())};
  const std::vector<ColorCurve> all = several([](const Request&, const Result& result) {
    ColorCurve out;
    if (!result.angles || result.angles->forms.empty()) return out;
    const bool exact = !result.angles->exact.empty();
    out.x = result.angles->angle_deg;
    out.rgb = exact ? result.angles->exact : result.angles->forms[0].rgb;
    if (!exact) out.title = ", " + std::string(result.angles->forms[0].title);
    return out;
  });
  if (!kept_.empty() && !all.empty())
    return angles_->set_plot(curves_plot(CurveKind::fresnel, all, channel, 0), "°");
  if (result_.angles && !result_.angles->forms.empty()) {
    angles_->set_plot(angle_plot(shown_.name, *result_.angles, channel[0]), "°");
    return;
  }
  LinePlot plot;
  plot.title = shown_.name + ": F over angle";
  plot.description = !result_.refusal.empty() ? result_.refusal : "no F0 is known";
  angles_->set_plot(std::move(plot), {});
}

void CurvesPanel::show_lobe() {
  const auto scale = scale_->isChecked() ? RadialScale::logarithmic : RadialScale::linear;
  const auto model_text = [](const Request& request) {
    return ", " + std::string(request.model->title) + ", gloss " + number(request.gloss, 3);
  };
  // Kept lobes are drawn under the light that is set now.
  const double light_deg = light_->value();
  const std::vector<ColorCurve> all = several([&](const Request& request, const Result& result) {
    ColorCurve out;
    if (!result.lobe) return out;
    LobeCurve lobe = lobe_curve(*request.model, request.values, light_deg);
    out = {model_text(request), std::move(lobe.angle_deg), std::move(lobe.rgb)};
    for (Vec3& rgb : out.rgb)
      for (double& each : rgb) each *= std::cos(qDegreesToRadians(light_deg));
    return out;
  });
  if (!kept_.empty() && !all.empty())
    return lobe_->set_plot(
        polar_plot(curves_plot(CurveKind::lobe, all, luminance, light_deg), light_deg, scale));
  if (result_.lobe) {
    const std::string name = shown_.name + model_text(shown_);
    lobe_->set_plot(lobe_plot(name, *result_.lobe, scale));
    return;
  }
  PolarPlot plot;
  plot.title = shown_.name + ": lobe";
  plot.description = "no specular model";
  lobe_->set_plot(std::move(plot));
}

}  // namespace etak::editor
