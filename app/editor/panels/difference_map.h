// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

#include "core/render/sheet.h"

namespace etak::editor {

/// Shows the map of a difference above the scale of its colours.
class DifferenceMap : public QLabel {
 public:
  explicit DifferenceMap(const QString& name, QWidget* parent = nullptr);
  void show_map(const DifferencePicture& difference);
};

}  // namespace etak::editor
