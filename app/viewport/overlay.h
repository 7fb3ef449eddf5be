// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

namespace etak {

/// The drawing over the picture: the separator with the names of both sides, marks of lights, the numbers of
/// the patch under the cursor, messages.
class Overlay : public QWidget {
 public:
  struct Mark {
    QPointF at;
    QString name;
    bool held = false;
    bool operator==(const Mark&) const = default;
  };
  struct Content {
    QImage photograph;                // right of the separator
    std::optional<double> separator;  // in widget pixels from the left
    QString left_name, right_name;
    std::vector<Mark> marks;
    QString readout, message;
    bool angle_zones = false;  // the legend of their tints
    bool operator==(const Content&) const = default;
  };
  explicit Overlay(QWidget* parent);
  void show_content(Content content);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Content content_;
};

}  // namespace etak
