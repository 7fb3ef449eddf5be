// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <string>

namespace etak::editor {

class QuietComboBox;

/// What new things begin with. Projects that are there keep what they say.
struct Preferences {
  std::string
      model;  // specular model of materials that come from the library or are new; empty: the usual one
  bool measure = false;  // new projects are looked at as by take_measure(), else as by take_look()

  static Preferences remembered();
  void remember() const;
};

class PreferencesDialog : public QDialog {
  Q_OBJECT

 public:
  PreferencesDialog(const Preferences& now, QWidget* parent);
  Preferences chosen() const;

 private:
  QuietComboBox *model_, *look_;
};

}  // namespace etak::editor
