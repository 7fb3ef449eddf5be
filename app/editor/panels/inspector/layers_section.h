// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/document/document.h"
#include "app/document/press_id.h"
#include "app/editor/panels/inspector/sections.h"
#include "app/viewport/background.h"
#include "core/material/stack_text.h"

class QLineEdit;

namespace etak::editor {

class LinePlotWidget;
class NumberField;

/// The colours of a stack over the range of a thickness slider, which stands below it.
class ThicknessStrip : public QWidget {
  Q_OBJECT

 public:
  ThicknessStrip(NumberField& field, QWidget* parent);
  void show_colors(std::vector<QColor> colors);  // at even steps over the slider's range
  const std::vector<QColor>& colors() const { return colors_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  NumberField& field_;
  std::vector<QColor> colors_;
};

/// The section "Layers": the layers on a measured record, the outermost first, each with its medium and its thickness
/// over the colours that it can have; and R of the whole over wavelength and over the angle. A record without layers can
/// be given one. Each edit makes a text of layers the record of the material, as one step of undo.
class LayersSection : public Section {
  Q_OBJECT

 public:
  explicit LayersSection(Document& document, QWidget* parent = nullptr);

  ///   material   the current material or a previewed one; null: none. Without a record of n and k or of layers the
  ///              section is not shown
  void show_material(const ProjectMaterial* material, bool editable);

 signals:
  void told(const QString& message);

 private:
  struct Row {
    QWidget* box;
    QLineEdit* medium;
    ThicknessStrip* strip;
    NumberField* thickness;
  };
  using Change = std::function<void(StackText&)>;

  void edit(const QString& what, const Change& change, int press_id = next_press_id());
  void rebuild();
  Row row_of(std::size_t layer);

  Document& document_;
  QVBoxLayout* list_;
  QLineEdit* base_;
  LinePlotWidget *reflectance_, *angles_;
  QWidget* plots_;
  Worker pool_;
  std::vector<Row> rows_;
  std::vector<double> most_nm_;  // ends of the sliders
  StackText stack_;
  std::optional<MeasuredF0> shown_;
};

}  // namespace etak::editor
