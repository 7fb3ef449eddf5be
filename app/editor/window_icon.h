// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QIcon>

namespace etak::editor {

/// The icon of resources/desktop/etak-editor.svg, painted: Qt reads SVG only with a module of its own.
QIcon window_icon();

}  // namespace etak::editor
