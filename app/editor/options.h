// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>
#include <optional>

#include "app/editor/theme.h"

namespace etak::editor {

/// The command line of etak-editor.
struct Options {
  QStringList subjects;  // files to open, or with a screenshot a library material
  QString screenshot;    // empty: an ordinary run
  QString model, state;
  QSize size{1280, 800};
  std::optional<Theme> theme;
  bool cpu = false, time_start = false;
  std::optional<double> input_timeout;  // seconds
  bool help = false, version = false;
  QString error;  // not empty: what is wrong with the command line
};
Options parse_options(const QStringList& arguments);
QString help_text();

/// States that --state names: "default", "compare", "wedge", "textures", ...
const QStringList& screenshot_states();

}  // namespace etak::editor
