// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/view_bar.h"

#include <QAction>
#include <QMenu>
#include <QToolButton>
#include <algorithm>

#include "app/document/press_id.h"
#include "app/editor/panels/shape_box.h"
#include "app/editor/panels/view_panel.h"
#include "app/fields/flow_layout.h"
#include "app/viewport/qt_text.h"
#include "core/light/studio.h"

namespace etak::editor {

ViewBar::ViewBar(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      environment_(new QuietComboBox(tr("Environment"), this)),
      tone_(new QuietComboBox(tr("Tone curve"), this)),
      shape_(new ShapeBox(document, tr("Shown on"), this)),
      exposure_(new FineSpinBox(this)) {
  setAccessibleName(tr("Bar of the viewport"));
  auto* row = new FlowLayout(2, this);  // all are in one line of a window of 1280
  row->setContentsMargins(3, 3, 3, 3);
  for (QWidget* each : std::initializer_list<QWidget*>{environment_, exposure_, tone_, shape_})
    row->addWidget(each);
  for (QComboBox* each : std::initializer_list<QComboBox*>{environment_, tone_, shape_})
    each->setMinimumContentsLength(5);
  tone_->setMinimumContentsLength(9);
  shape_->setMinimumContentsLength(6);
  make_environment();
  make_picture();
  connect(&document, &Document::view_changed, this, &ViewBar::show_view);
  connect(&document, &Document::replaced, this, &ViewBar::show_view);
  show_view();
}

void ViewBar::make_environment() {
  environment_->setToolTip(tr(
      "Light from all sides; choosing one switches the two hemispheres off (tab Light has its turn and scale)"));
  environment_->addItem(tr("none"), QString());
  for (const NamedStudio& each : named_studios())
    environment_->addItem(qt_text(each.name), qt_text(each.name));
  environment_->addItem(tr("Open a picture\u2026"));
  connect(environment_, &QComboBox::activated, this, [this](int row) {
    const QVariant name = environment_->itemData(row);
    if (!name.isValid()) {
      show_view();  // the one that is shown stays chosen
      return emit open_environment_asked();
    }
    document_.change_view(tr("environment"), next_press_id(), [&](ProjectView& view) {
      choose_environment(view.lights, name.toString().toStdString());
    });
  });
}

void ViewBar::make_picture() {
  exposure_->setAccessibleName(tr("Exposure of the picture"));
  exposure_->setToolTip(tr("Exposure in stops (EV): each one more doubles the light"));
  exposure_->setRange(exposure_range.least, exposure_range.most);
  exposure_->setSingleStep(0.25);
  exposure_->setSuffix(tr(" EV"));
  connect(exposure_, &FineSpinBox::edited, this, [this](double stops, int press) {
    document_.change_view(tr("exposure"), press,
                          [&](ProjectView& view) { stops_of_exposure().set(view, stops); });
  });
  tone_->setToolTip(tr("The tone curve before the one of sRGB; a config's displays are in the tab View"));
  // The titles of the tab View would need more room than the bar has.
  tone_->addItems({tr("plain sRGB"), tr("Neutral"), tr("AgX-like"), tr("Filament"), tr("false colours")});
  for (int row = 0; row < tone_->count(); ++row)
    tone_->setItemData(row, tone_titles().at(row), Qt::ToolTipRole);
  connect(tone_, &QComboBox::activated, this, [this](int row) {
    document_.change_view(tr("tone curve"), next_press_id(),
                          [&](ProjectView& view) { view.tone = tones[static_cast<std::size_t>(row)]; });
  });
  connect(shape_, &ShapeBox::mesh_asked, this, &ViewBar::mesh_asked);
}

void ViewBar::add(QAction* action) {
  auto* out = new QToolButton(this);
  out->setDefaultAction(action);
  out->setProperty("chip", true);  // shows clearly that it is on, in both themes
  out->setAccessibleName(action->text().remove('&'));
  out->setFocusPolicy(Qt::TabFocus);
  layout()->addWidget(out);
}

void ViewBar::add_menu(const QString& title, const QString& tip, const QList<QAction*>& actions) {
  auto* out = new QToolButton(this);
  out->setText(title);
  out->setToolTip(tip);
  out->setAccessibleName(title);
  out->setPopupMode(QToolButton::InstantPopup);
  out->setFocusPolicy(Qt::TabFocus);
  auto* menu = new QMenu(title, out);
  menu->setAccessibleName(title);
  menu->setToolTipsVisible(true);
  menu->addActions(actions);
  out->setMenu(menu);
  layout()->addWidget(out);
}

void ViewBar::show_view() {
  const ProjectView& view = document_.project().view;
  const QString environment = qt_text(view.lights.environment);
  if (environment_->findData(environment) < 0)
    environment_->insertItem(environment_->count() - 1, environment.section('/', -1), environment);
  environment_->setCurrentIndex(environment_->findData(environment));
  exposure_->show_value(stops_of_exposure().get(view));
  const bool plain = view.config.empty() && view.display.empty() && view.view.empty();
  tone_->setCurrentIndex(plain ? static_cast<int>(std::ranges::find(tones, view.tone) - tones.begin()) : -1);
  tone_->setEnabled(plain);
}

}  // namespace etak::editor
