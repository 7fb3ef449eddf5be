// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/editor/document/look.h"
#include "app/editor/panels/sections.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace etak::editor {

class NumberField;

/// Exposure, display, shape, comparison, overlays.
class ViewPanel : public PanelScroll {
  Q_OBJECT

 public:
  /// `look` is the window's: it is changed here, and look_changed() told.
  ViewPanel(Document& document, Look& look, QWidget* parent = nullptr);
  void show_look();
  /// What the viewport says of the patch under the cursor.
  void show_patch(const QString& text);

 signals:
  void look_changed();
  void pin_asked();

 private:
  Section* make_display();
  Section* make_shape();
  Section* make_compare();
  void fill_displays();
  void take_display();

  Document& document_;
  Look& look_;
  NumberField* exposure_ = nullptr;
  QuietComboBox *display_ = nullptr, *view_ = nullptr, *shape_ = nullptr, *parameter_ = nullptr,
                *model_ = nullptr;
  QSpinBox* steps_ = nullptr;
  QCheckBox *zone_ = nullptr, *energy_ = nullptr, *textured_ = nullptr, *split_ = nullptr;
  QLabel *pinned_ = nullptr, *patch_ = nullptr, *config_ = nullptr;
  QPushButton* unpin_ = nullptr;
  std::string filled_config_ = "?";
  bool showing_ = false;
};

}  // namespace etak::editor
