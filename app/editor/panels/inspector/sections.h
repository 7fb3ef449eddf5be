// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <QWheelEvent>

namespace etak::editor {

/// A combo box that leaves the wheel to the page around it, unless it has the focus. A text that is longer than the
/// box ends in three dots.
class QuietComboBox : public QComboBox {
  Q_OBJECT

 public:
  explicit QuietComboBox(const QString& name, QWidget* parent = nullptr);
  /// Has these items. An open list and the chosen item stay where they are the same already.
  void show_items(const QStringList& items);

 protected:
  void wheelEvent(QWheelEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

/// A part of a panel with a title, and rows that have a name and a field.
class Section : public QGroupBox {
  Q_OBJECT

 public:
  explicit Section(const QString& title, QWidget* parent = nullptr);
  /// Adds a row. The name becomes the accessible name of the field where that has none.
  ///   tip   tooltip of field and name; empty: that of the field
  void add(const QString& name, QWidget* field, const QString& tip = {});
  void add(QWidget* wide);
  /// Adds a wide row of widgets beside each other.
  QHBoxLayout& add_line(const QString& name);
  /// Adds a wide field below its name.
  void add_below(const QString& name, QWidget* field, const QString& tip);
  /// An empty place for a sign beside a field, or beside the name of a wide one, so that nothing moves where it comes.
  QLabel* add_badge(QWidget& field);
  QFormLayout& rows() { return *rows_; }
  /// The label of a field that was added with a name; null: there is none.
  QLabel* label_of(const QWidget& field) const;

 private:
  QLabel* label_for(const QString& name, QWidget* field, const QString& tip);
  QFormLayout* rows_;
};

/// A page of sections that scrolls up and down, and is never narrower than its content.
///   page   accessible name of the page
class PanelScroll : public QScrollArea {
  Q_OBJECT

 public:
  PanelScroll(const QString& name, const QString& page, QWidget* parent);
  QSize minimumSizeHint() const override;

 protected:
  QVBoxLayout& column() { return *column_; }
  Section& add_section(const QString& title);
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  QVBoxLayout* column_;
};

/// The layout of a panel: widgets below each other, with a small margin around them.
QVBoxLayout* panel_column(QWidget* panel, int spacing);

/// A label for grey text that is wrapped and can be selected.
///   name   accessible name of the label
QLabel* quiet_label(const QString& name, QWidget* parent);

/// Sets a text of several lines.
///   same   it is of the same material as the one before: where it is shorter, the place of that stays empty, so that
///          no field below it moves under the hand
void set_steady_text(QLabel& label, const QString& text, bool same);

}  // namespace etak::editor
