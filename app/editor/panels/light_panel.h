// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/document/document.h"
#include "app/editor/panels/inspector/fields_of.h"

class QButtonGroup;

namespace etak::editor {

/// Fields for lights, hemispheres and environment. Drags in the viewport change the same values.
class LightPanel : public PanelScroll {
  Q_OBJECT

 public:
  explicit LightPanel(Document& document, QWidget* parent = nullptr);
  /// Asks for the file of an environment.
  void open_environment();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void make_light();
  void make_which(Section& section);
  void make_hemispheres();
  void make_environment();
  void make_strip(Section& section);
  void set_environment(const QString& name);
  void show_view();
  void edit_light(const QString& step, int press_id, const std::function<void(Light&)>& change);
  void edit(const QString& step, int press_id, const std::function<void(ProjectView&)>& change);

  Document& document_;
  FieldsOf<ProjectView> view_;
  FieldsOf<Light> light_;
  FieldsOf<Hemispheres> hemispheres_;
  QuietComboBox* which_ = nullptr;
  QLabel* intensity_unit_ = nullptr;
  QButtonGroup* strip_ = nullptr;
  bool showing_ = false;
};

}  // namespace etak::editor
