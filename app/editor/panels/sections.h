// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QScrollArea>
#include <QWheelEvent>

namespace etak::editor {

/// A combo box that lets the wheel scroll the page around it, unless it has the focus.
class QuietComboBox : public QComboBox {
  Q_OBJECT

 public:
  explicit QuietComboBox(const QString& name, QWidget* parent = nullptr);

 protected:
  void wheelEvent(QWheelEvent* event) override;
};

/// A titled part of a panel, with rows of a name and a field.
class Section : public QGroupBox {
  Q_OBJECT

 public:
  explicit Section(const QString& title, QWidget* parent = nullptr);
  /// The name becomes the field's accessible name where it has none.
  void add(const QString& name, QWidget* field);
  void add(QWidget* wide);
  /// The field below its name: for wide ones.
  void add_below(const QString& name, QWidget* field);
  QFormLayout& rows() { return *rows_; }

 private:
  QFormLayout* rows_;
};

/// A page of sections that scrolls up and down, and is never narrower than what is in it.
class PanelScroll : public QScrollArea {
  Q_OBJECT

 public:
  PanelScroll(const QString& name, QWidget* parent);
  QSize minimumSizeHint() const override;

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;
};

/// Small grey text of several lines.
QLabel* quiet_label(const QString& name, QWidget* parent);

}  // namespace etak::editor
