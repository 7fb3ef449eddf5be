// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QIcon>

namespace etak::editor {

/// The icon of resources/desktop/etak-editor.svg, drawn by QPainter, because Qt reads SVG only with an extra
/// module.
QIcon window_icon();

}  // namespace etak::editor
