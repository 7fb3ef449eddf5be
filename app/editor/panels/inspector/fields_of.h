// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCheckBox>
#include <QHBoxLayout>
#include <algorithm>
#include <functional>
#include <vector>

#include "app/document/press_id.h"
#include "app/editor/panels/inspector/sections.h"
#include "app/fields/color_field.h"
#include "app/fields/number_field.h"

namespace etak::editor {

/// The texts of a field.
struct FieldText {
  QString name;   // accessible name
  QString label;  // beside the field; empty: the name
  QString tip;
  QString step = {};  // of undo; empty: the name in lower case
};

/// A part of a value that is computed from it.
template <class Get, class Set>
struct Computed {
  Get get;
  Set set;
};
template <class Get, class Set>
Computed(Get, Set) -> Computed<Get, Set>;

/// The fields of a value, such as a light: one description makes a row of a section, shows the part of the
/// value that it is of, and makes the step of undo where the user edits it. A part is a member, a function that
/// returns a reference, or Computed.
template <class Value>
class FieldsOf {
 public:
  using Change = std::function<void(Value&)>;
  ///   step       what the step of undo is called
  ///   press_id   edits of the same press are one step
  using Edit = std::function<void(const QString& step, int press_id, const Change& change)>;
  /// Whether a field can be edited.
  using When = std::function<bool(const Value&)>;

  explicit FieldsOf(Edit edit) : edit_(std::move(edit)) {}

  /// The next rows are added to this section.
  FieldsOf& in(Section& section) {
    section_ = &section;
    return *this;
  }

  ///   on   false: no field can be edited
  void show(const Value& value, bool on = true) const {
    for (const auto& each : shown_) each(value, on);
  }

  template <class Part>
  NumberField* number(FieldText text, const FieldRange& range, const Part& part, const When& when = {}) {
    auto* field = new NumberField(text.name, range, section_);
    section_->add(label(text), field, text.tip);
    connect(field, &NumberField::edited, text, part);
    shows({field}, when, [=](const Value& v) { field->show_value(got(part, v)); });
    return field;
  }

  template <class Part>
  ColorField* color(FieldText text, const LinearRgb& standard, const Part& part, const When& when = {}) {
    auto* field = new ColorField(text.name, standard, section_);
    section_->add_below(label(text), field, text.tip);
    connect(field, &ColorField::edited, text, part);
    shows({field}, when, [=](const Value& v) { field->show_color(rgb(got(part, v))); });
    return field;
  }

  /// A box of items, whose rows are the values of the part.
  template <class Part>
  QuietComboBox* choice(FieldText text, const QStringList& items, const Part& part, const When& when = {}) {
    auto* field = new QuietComboBox(text.name, section_);
    field->addItems(items);
    section_->add(label(text), field, text.tip);
    connect(field, &QComboBox::activated, text, part);
    shows({field}, when, [=](const Value& v) { field->setCurrentIndex(static_cast<int>(got(part, v))); });
    return field;
  }

  ///   column   to which it is added in place of the section
  template <class Part>
  QCheckBox* check(FieldText text, const Part& part, QBoxLayout* column = nullptr) {
    auto* field = new QCheckBox(column != nullptr ? column->parentWidget() : section_);
    field->setText(label(text));
    field->setToolTip(text.tip);
    field->setAccessibleName(text.name);
    if (column != nullptr)
      column->addWidget(field);
    else
      section_->add(field);
    connect(field, &QCheckBox::clicked, text, part);
    shows({}, {}, [=](const Value& v) { field->setChecked(got(part, v)); });
    return field;
  }

  /// Three boxes for x, y and z.
  ///   mended   makes a valid part of an edited one; null: each is valid
  template <class Part>
  void vector(FieldText text, const Part& part, Vec3 (*mended)(const Vec3&), const When& when = {}) {
    auto* row = new QWidget(section_);
    row->setAccessibleName(text.name);
    section_->add(label(text), row, text.tip);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(3);
    std::vector<QWidget*> boxes;
    for (std::size_t i = 0; i < 3; ++i) {
      auto* box = new FineSpinBox(row);
      box->setButtonSymbols(QAbstractSpinBox::NoButtons);
      box->setRange(-1000, 1000);
      box->setSingleStep(0.05);
      box->setAccessibleName(text.name + QLatin1Char(' ') + QLatin1Char("xyz"[i]));
      line->addWidget(box);
      boxes.push_back(box);
      const auto set = [=](Value& v, double number) {
        Vec3& to = std::invoke(part, v);
        to[i] = number;
        if (mended != nullptr) to = mended(to);
      };
      connect(box, &FineSpinBox::edited, text, Computed{nullptr, set});
      shows({}, {}, [=](const Value& v) { box->show_value(got(part, v)[i]); });
    }
    shows(boxes, when, {});
  }

  /// Shows a part by a function, as number() and others do.
  ///   fields   those that can be edited where `when` says so
  void shows(const std::vector<QWidget*>& fields, const When& when,
             const std::function<void(const Value&)>& show) {
    shown_.push_back([=](const Value& value, bool on) {
      if (show) show(value);
      for (QWidget* each : fields) each->setEnabled(on && (!when || when(value)));
    });
  }

 private:
  static QString label(FieldText& text) {
    if (text.step.isEmpty()) text.step = text.name.toLower();
    return text.label.isEmpty() ? text.name : text.label;
  }

  static LinearRgb rgb(const LinearRgb& color) { return color; }
  static LinearRgb rgb(const Vec3& color) { return to_rgb(color); }

  template <class Part>
  static decltype(auto) got(const Part& part, const Value& value) {
    if constexpr (requires { part.get; })
      return part.get(value);
    else
      return std::invoke(part, value);
  }

  template <class Part, class Shown>
  static void put(const Part& part, Value& value, const Shown& shown) {
    if constexpr (requires { part.set; })
      part.set(value, shown);
    else
      assign(std::invoke(part, value), shown);
  }
  template <class To, class Shown>
  static void assign(To& to, const Shown& shown) {
    if constexpr (std::is_same_v<Shown, LinearRgb>)  // of light, which is never below 0
      to = To{std::max(0.0, shown.r), std::max(0.0, shown.g), std::max(0.0, shown.b)};
    else
      to = static_cast<To>(shown);
  }

  // Makes steps of undo of a signal that gives what is shown now, and maybe the id of the press.
  template <class Field, class Signal, class Part>
  void connect(Field* field, Signal edited, const FieldText& text, const Part& part) {
    QObject::connect(field, edited, field, [edit = edit_, step = text.step, part](auto shown, auto... press) {
      edit(step, sizeof...(press) == 0 ? next_press_id() : (press + ... + 0),
           [&](Value& value) { put(part, value, shown); });
    });
  }

  Section* section_ = nullptr;
  Edit edit_;
  std::vector<std::function<void(const Value&, bool)>> shown_;
};

}  // namespace etak::editor
