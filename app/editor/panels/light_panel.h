// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/editor/document/document.h"
#include "app/editor/panels/sections.h"

class QButtonGroup;
class QCheckBox;

namespace etak::editor {

class ColorField;
class FineSpinBox;
class NumberField;

/// Fields for lights, hemispheres and environment. Drags in the viewport change the same values.
class LightPanel : public PanelScroll {
  Q_OBJECT

 public:
  explicit LightPanel(Document& document, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  Section* make_light();
  void connect_light();
  Section* make_hemispheres();
  Section* make_environment();
  QWidget* make_strip();
  void show_view();
  void edit_light(const QString& what, int press_id, const std::function<void(Light&)>& change);
  void edit_lights(const QString& what, int press_id, const std::function<void(LightSetup&)>& change);

  Document& document_;
  QuietComboBox *which_ = nullptr, *kind_ = nullptr, *form_ = nullptr, *environment_ = nullptr;
  ColorField *color_ = nullptr, *upper_ = nullptr, *lower_ = nullptr;
  NumberField *intensity_ = nullptr, *inner_ = nullptr, *outer_ = nullptr, *scale_ = nullptr,
              *width_ = nullptr, *height_ = nullptr, *turn_ = nullptr;
  std::array<FineSpinBox*, 3> position_{}, direction_{}, axis_{};
  QCheckBox *hemispheres_ = nullptr, *pi_scaled_ = nullptr;
  QLabel* intensity_unit_ = nullptr;
  QButtonGroup* strip_ = nullptr;
  bool showing_ = false;
};

}  // namespace etak::editor
