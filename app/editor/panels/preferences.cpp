// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/preferences.h"

#include <QDialogButtonBox>
#include <QSettings>
#include <algorithm>

#include "app/editor/panels/inspector/model_list.h"
#include "app/editor/panels/inspector/sections.h"
#include "app/viewport/qt_text.h"

namespace etak::editor {

Preferences Preferences::remembered() {
  const QSettings settings;
  Preferences out{settings.value("new/model").toString().toStdString(),
                  settings.value("new/measure", false).toBool()};
  if (find_model(out.model) == nullptr) out.model.clear();  // another version may have had it
  return out;
}

void Preferences::remember() const {
  QSettings settings;
  settings.setValue("new/model", qt_text(model));
  settings.setValue("new/measure", measure);
}

PreferencesDialog::PreferencesDialog(const Preferences& now, QWidget* parent)
    : QDialog(parent),
      model_(new QuietComboBox(tr("Model of new materials"), this)),
      look_(new QuietComboBox(tr("New projects begin with"), this)) {
  setWindowTitle(tr("Preferences"));
  setAccessibleName(tr("Preferences"));
  auto* column = panel_column(this, 6);
  auto* section = new Section(tr("New materials and projects"), this);
  column->addWidget(section);
  model_->addItem(tr("the usual one"), QString());
  add_models(*model_, [](const Model& each) { return each.kind != ModelKind::diffuse; });
  model_->setCurrentIndex(std::max(0, model_->findData(qt_text(now.model))));
  model_->setMinimumContentsLength(26);
  section->add(tr("Model"), model_,
               tr("The specular model of materials that are new or come from the library from now on"));
  look_->addItems({tr("Look"), tr("Measure")});
  look_->setCurrentIndex(now.measure ? 1 : 0);
  section->add(
      tr("Projects begin with"), look_,
      tr("Look: environment behind, ground and a neutral tone curve. Measure: 18 % grey is code 118"));
  auto* note = quiet_label(tr("What the preferences do not change"), this);
  note->setText(tr("Materials and projects that are there stay as they are. The theme is in the menu View."));
  column->addWidget(note);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons->setAccessibleName(tr("Buttons"));
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

Preferences PreferencesDialog::chosen() const {
  return {model_->currentData().toString().toStdString(), look_->currentIndex() == 1};
}

}  // namespace etak::editor
