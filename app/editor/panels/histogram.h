// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QWidget>
#include <array>

namespace etak::editor {

/// How many texels of a picture have which code, a curve for each channel; of F0 the codes of the forbidden zone are
/// shaded.
class Histogram : public QWidget {
  Q_OBJECT

 public:
  explicit Histogram(QWidget* parent = nullptr);
  ///   f0   the picture holds F0, sRGB-encoded
  void show_picture(const QImage& picture, bool f0);
  /// Least, mean and largest code, and of F0 the share of texels in the zone: "codes 12 to 240, mean 98". Empty: no picture.
  QString summary() const { return summary_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::array<std::array<int, 256>, 3> counts_{};
  bool grey_ = true, f0_ = false;
  QString summary_;
};

}  // namespace etak::editor
