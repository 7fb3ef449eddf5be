// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/inspector/source_section.h"

#include <QCompleter>
#include <QLineEdit>

#include "app/document/press_id.h"
#include "app/editor/panels/inspector/data_sentences.h"
#include "app/fields/add_button.h"
#include "app/viewport/background.h"
#include "app/viewport/qt_text.h"
#include "core/base/text/text.h"
#include "core/color/srgb.h"
#include "core/material/quality.h"
#include "core/pages/f0/report.h"

namespace etak::editor {
namespace {

// The texts about a measured F0. A worker makes them, because F0 of every dataset of the material is computed
// for the spread.
struct SourceText {
  QString result, body, spread, citation;
};

SourceText source_text(const ProjectMaterial& material, const MaterialLibrary& library) {
  SourceText out;
  const MeasuredF0& measured = *material.measured;
  const QString failure = failure_of([&] {
    const FoundF0 found = find_f0(measured, library);
    const F0Result& r = found.result;
    out.result = QStringLiteral("%1   Y %2%3   F82 %4")
                     .arg(qt_text(hex(r.srgb8)), qt_text(fixed(r.luminance, 3)),
                          r.zone ? QStringLiteral(" (%1)").arg(qt_text(name(*r.zone))) : QString(),
                          r.f82 ? qt_text(hex(srgb_u8(*r.f82))) : "-");
    out.result += "\n" + QObject::tr("data %1").arg(qt_text(quality_text(found.chosen().origin, r.flags)));
    out.result += data_sentences(r.flags, doubt(found.material, found.chosen()));
    out.body = qt_text(body_note(material, found, library));
    out.citation = qt_text(one_line(found.chosen().citation));
    MaterialReport report{found.material, {}};
    const F0Solver solver(f0_options(measured, library));
    for (const Dataset& each : found.material.datasets)
      report.results.push_back(solve(solver, found.material, each));
    const Spread all = spread(report);
    out.spread = all.count > 1 ? QObject::tr("%1 datasets: %2 to %3")
                                     .arg(all.count)
                                     .arg(qt_text(hex(all.least8)), qt_text(hex(all.most8)))
                               : QObject::tr("one dataset");
    report.material.preferred = static_cast<std::size_t>(&found.chosen() - found.material.datasets.data());
    const auto band = band_of(report).band;
    if (!band) return;
    out.spread += QStringLiteral("<br>") + QObject::tr("half of the publications lie in here") + ' ';
    for (const LinearRgb& each : half_band_colors(*band, r.srgb_linear))
      out.spread += QStringLiteral("<font color=\"%1\">\u2588\u2588</font>").arg(qt_text(hex(srgb_u8(each))));
    out.spread += QStringLiteral("<br>") + qt_text(words(*band)).toHtmlEscaped();
  });
  if (!failure.isEmpty()) out.result = failure;
  return out;
}

}  // namespace

QString let_go_text(const ProjectMaterial& m) {
  return QObject::
      tr("%1 is measured no longer: its colours are typed numbers now. Undo or the colour's reset goes back to the measurement of %2")
          .arg(qt_text(m.name), qt_text(m.measured->material));
}

SourceSection::SourceSection(Document& document, QWidget* parent)
    : Section(tr("Measured F0"), parent),
      document_(document),
      material_(new QuietComboBox(tr("Use measured F0 of"), this)),
      dataset_(new QuietComboBox(tr("Dataset"), this)),
      outside_(new QuietComboBox(tr("Outside medium"), this)),
      illuminant_(new QuietComboBox(tr("Illuminant"), this)),
      observer_(new QuietComboBox(tr("Observer"), this)),
      result_(quiet_label(tr("Measured F0, result"), this)),
      body_(quiet_label(tr("About the body and the roughness"), this)),
      spread_(quiet_label(tr("Spread of the datasets"), this)),
      citation_(quiet_label(tr("Citation"), this)) {
  const auto editable = [this](QuietComboBox* box, const QString& name, const QString& placeholder) {
    box->setEditable(true);
    box->setInsertPolicy(QComboBox::NoInsert);
    box->lineEdit()->setAccessibleName(name);
    box->lineEdit()->setPlaceholderText(placeholder);
    connect(box->lineEdit(), &QLineEdit::editingFinished, this, &SourceSection::take);
  };
  spread_->setTextFormat(Qt::RichText);  // it holds swatches
  editable(material_, tr("Use measured F0 of, text"), tr("typed numbers"));
  material_->completer()->setCompletionMode(QCompleter::PopupCompletion);
  material_->completer()->setFilterMode(Qt::MatchContains);
  editable(outside_, tr("Outside medium, text"), tr("vacuum"));
  for (const char* medium : {"", "air", "water", "1.5"}) outside_->addItem(qt_text(medium));
  for (const Illuminant each : {Illuminant::d65, Illuminant::d50, Illuminant::a, Illuminant::e})
    illuminant_->addItem(qt_text(name(each)));
  for (const Observer each : {Observer::cie1931_2deg, Observer::cie1964_10deg})
    observer_->addItem(qt_text(name(each)));
  make_rows();
  set_library();
  for (const QuietComboBox* each : {material_, dataset_, outside_, illuminant_, observer_})
    connect(each, &QComboBox::activated, this, &SourceSection::take);
}

void SourceSection::make_rows() {
  const auto beside = [this](const QString& name, std::initializer_list<QWidget*> fields) {
    auto* out = new QWidget(this);
    out->setAccessibleName(name);
    auto* line = new QHBoxLayout(out);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(4);
    for (QWidget* each : fields) line->addWidget(each, 1);
    return line;
  };
  QHBoxLayout* use = beside(tr("Record and dataset"), {material_, dataset_});
  unfold_ = add_button(*use, tr("i"), tr("Show or hide what is to be said of the measurement"));
  unfold_->setCheckable(true);
  unfold_->setChecked(true);
  connect(unfold_, &QToolButton::toggled, this, &SourceSection::show_rows);
  const QString tip = tr("The record whose spectra give the colours; empty: the colours are typed numbers");
  material_->setToolTip(tip);
  dataset_->setToolTip(tr("Which measurement of the record is used"));
  connect(dataset_, &QComboBox::currentTextChanged, dataset_,
          [this](const QString& text) { dataset_->setToolTip(text); });
  add(tr("Use"), use->parentWidget(), tip);
  add(spread_);
  add(tr("Outside"), outside_, tr("A transparent material of the library, or an index such as 1.33"));
  illuminant_->setToolTip(tr("The light under which the spectrum becomes a colour"));
  observer_->setToolTip(tr("The CIE colour matching functions that make the spectrum a colour"));
  viewing_ = beside(tr("Illuminant and observer"), {illuminant_, observer_})->parentWidget();
  add(tr("Viewing"), viewing_, tr("Illuminant and observer, for which the spectrum becomes a colour"));
  add(result_);
  add(body_);
  add(citation_);
}

void SourceSection::set_library() {
  showing_ = true;
  material_->clear();
  material_->addItem(QString());
  for (const std::string& id : document_.library()->ids()) material_->addItem(qt_text(id));
  showing_ = false;
  datasets_of_.clear();
}

void SourceSection::fill_datasets(const std::string& material) {
  if (material == datasets_of_) return;
  datasets_of_ = material;
  dataset_->clear();
  const auto found = material.empty() ? std::nullopt : record_named(*document_.library(), material);
  if (!found) return;
  dataset_->addItem(tr("%1, preferred").arg(qt_text(found->preferred_dataset().id)), QString());
  for (const Dataset& each : found->datasets) {
    const std::string quality = quality_text(each.origin, quality_flags(*found, each));
    dataset_->addItem(tr("%1 (%2)").arg(qt_text(each.id), qt_text(quality)), qt_text(each.id));
    dataset_->setItemData(dataset_->count() - 1, qt_text(one_line(each.citation)), Qt::ToolTipRole);
  }
}

void SourceSection::show_material(const ProjectMaterial* m, bool editable) {
  showing_ = true;
  const MeasuredF0 measured = m != nullptr && m->measured ? *m->measured : MeasuredF0{};
  const bool on = m != nullptr && m->measured.has_value();
  material_->setCurrentIndex(std::max(0, material_->findText(qt_text(measured.material))));
  material_->lineEdit()->setText(qt_text(measured.material));
  // A text of layers may be longer than the field.
  material_->lineEdit()->setToolTip(measured.material.empty() ? material_->toolTip()
                                                              : qt_text(measured.material));
  fill_datasets(measured.material);
  dataset_->setCurrentIndex(std::max(0, dataset_->findData(qt_text(measured.dataset))));
  outside_->setCurrentText(qt_text(measured.outside));
  illuminant_->setCurrentText(qt_text(name(measured.viewing.illuminant)));
  observer_->setCurrentText(qt_text(name(measured.viewing.observer)));
  material_->setEnabled(editable);
  for (QuietComboBox* each : {dataset_, outside_, illuminant_, observer_}) each->setEnabled(on && editable);
  showing_ = false;
  shown_ = m != nullptr ? m->measured : std::nullopt;
  show_rows();
  if (on) tell(*m);
}

void SourceSection::use(const QString& id) {
  material_->lineEdit()->setText(id);
  take();
}

void SourceSection::unfold(bool on) {
  unfold_->setChecked(on);
}

bool SourceSection::is_unfolded() const {
  return unfold_->isChecked();
}

// Rows without a measurement to tell of are not there.
void SourceSection::show_rows() {
  const bool on = shown_.has_value() && unfold_->isChecked();
  unfold_->setEnabled(shown_.has_value());
  for (QWidget* each : std::initializer_list<QWidget*>{spread_, outside_, viewing_, result_, citation_})
    rows().setRowVisible(each, on);
  rows().setRowVisible(body_, on && (!body_->text().isEmpty() || body_->minimumHeight() > 0));
}

void SourceSection::tell(const ProjectMaterial& material) {
  in_background(
      pool_, this, [material, library = document_.library()] { return source_text(material, *library); },
      [this, name = material.name, measured = material.measured](const SourceText& what) {
        if (shown_ != measured) return;  // the texts are about an older measurement
        const bool same = told_ == std::pair(name, *measured);
        told_ = {name, *measured};
        set_steady_text(*result_, what.result, same);
        set_steady_text(*body_, what.body, same);
        spread_->setText(what.spread);
        set_steady_text(*citation_, what.citation, same);
        show_rows();
      });
}

void SourceSection::take() {
  const ProjectMaterial* now = document_.material();
  if (showing_ || now == nullptr || !material_->isEnabled()) return;
  ProjectMaterial next = *now;
  const std::string wanted = material_->lineEdit()->text().trimmed().toStdString();
  if (wanted.empty()) {
    next.measured.reset();
    if (now->measured) emit told(let_go_text(*now));
  } else {
    MeasuredF0 measured;
    measured.material = wanted;
    if (now->measured && now->measured->material == wanted)
      measured.dataset = dataset_->currentData().toString().toStdString();
    measured.outside = outside_->currentText().trimmed().toStdString();
    if (measured.outside == "vacuum") measured.outside.clear();
    measured.viewing.illuminant =
        illuminant_named(illuminant_->currentText().toStdString()).value_or(Illuminant::d65);
    measured.viewing.observer =
        observer_named(observer_->currentText().toStdString()).value_or(Observer::cie1931_2deg);
    // A field that the user leaves unchanged must change nothing, not even the colours.
    if (now->measured == measured) return;
    next.measured = measured;
    // A record of total reflectance needs an assumed F0 of the surface: the default, not that of the record
    // before.
    if (!now->measured || now->measured->material != wanted) next.specular = ProjectMaterial{}.specular;
    const QString failure = failure_of([&] { next = with_measured(next, *document_.library()); });
    if (!failure.isEmpty()) {
      show_material(now, true);
      rows().setRowVisible(result_, true);
      return result_->setText(failure);
    }
  }
  document_.edit(document_.current(), next, tr("measured F0"), next_press_id());
}

}  // namespace etak::editor
