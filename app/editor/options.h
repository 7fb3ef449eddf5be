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
  QStringList subjects;  // files to open; for a screenshot also a material of the library
  QString screenshot;    // picture file to write; empty: the editor runs as usual
  QString model, state;
  QSize size{1280, 800};
  std::optional<Theme> theme;
  bool cpu = false, time_start = false;
  std::optional<double> input_timeout;  // seconds
  bool help = false, version = false;
  QString error;  // the mistake in the command line; empty: none
};
/// The options of the command line. Mistakes are in Options::error.
Options parse_options(const QStringList& arguments);
QString help_text();

/// States that --state names: "default", "compare", "wedge", "textures", ...
const QStringList& screenshot_states();

}  // namespace etak::editor
