// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QThreadPool>

#include "app/editor/document/look.h"
#include "app/editor/fields/press_id.h"
#include "app/editor/panels/sections.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace etak::editor {

class ColorField;
class NumberField;
class QuietSpinBox;

/// Fields for exposure, display, backdrop, shape, comparison and overlays.
class ViewPanel : public PanelScroll {
  Q_OBJECT

 public:
  ///   look   belongs to the window; the panel changes it and emits look_changed()
  ViewPanel(Document& document, Look& look, QWidget* parent = nullptr);
  ~ViewPanel() override;
  void show_look();
  /// Shows the viewport's text about the patch under the cursor.
  void show_patch(const QString& text);

 signals:
  void look_changed();
  void pin_asked();

 private:
  Section* make_display();
  Section* make_backdrop();
  Section* make_shape();
  Section* make_compare();
  struct ReadDisplays;
  static ReadDisplays read_displays(const std::string& config);
  void fill_displays();
  void show_displays(const ReadDisplays& read);
  void take_display();

  Document& document_;
  Look& look_;
  NumberField *exposure_ = nullptr, *blur_ = nullptr;
  ColorField* background_ = nullptr;
  QuietComboBox *display_ = nullptr, *view_ = nullptr, *shape_ = nullptr, *parameter_ = nullptr,
                *model_ = nullptr, *behind_ = nullptr;
  QuietSpinBox* steps_ = nullptr;
  QCheckBox *zone_ = nullptr, *energy_ = nullptr, *angles_ = nullptr, *textured_ = nullptr, *split_ = nullptr,
            *ground_ = nullptr;
  QLabel *pinned_ = nullptr, *patch_ = nullptr, *config_ = nullptr;
  QPushButton* unpin_ = nullptr;
  RepeatedPress step_press_;
  QThreadPool pool_;
  std::string filled_config_ = "?";
  bool showing_ = false;
};

}  // namespace etak::editor
