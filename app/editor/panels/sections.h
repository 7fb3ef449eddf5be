// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QScrollArea>
#include <QWheelEvent>

namespace etak::editor {

/// A combo box that leaves the wheel to the page around it, unless it has the focus.
class QuietComboBox : public QComboBox {
  Q_OBJECT

 public:
  explicit QuietComboBox(const QString& name, QWidget* parent = nullptr);

 protected:
  void wheelEvent(QWheelEvent* event) override;
};

/// A part of a panel with a title, and rows that have a name and a field.
class Section : public QGroupBox {
  Q_OBJECT

 public:
  explicit Section(const QString& title, QWidget* parent = nullptr);
  /// Adds a row. The name becomes the accessible name of the field where that has none.
  void add(const QString& name, QWidget* field);
  void add(QWidget* wide);
  /// Adds a wide field below its name.
  void add_below(const QString& name, QWidget* field);
  QFormLayout& rows() { return *rows_; }

 private:
  QFormLayout* rows_;
};

/// A page of sections that scrolls up and down, and is never narrower than its content.
class PanelScroll : public QScrollArea {
  Q_OBJECT

 public:
  PanelScroll(const QString& name, QWidget* parent);
  QSize minimumSizeHint() const override;

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;
};

/// A label for grey text that is wrapped and can be selected.
///   name   accessible name of the label
QLabel* quiet_label(const QString& name, QWidget* parent);

}  // namespace etak::editor
