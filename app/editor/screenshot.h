// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPixmap>

#include "app/editor/options.h"

namespace etak::editor {

class Window;

/// Brings a window into the state that the options name and writes its picture. Returns the exit status.
int take_screenshot(Window& window, const Options& options);

/// Takes up a library material and one of screenshot_states(), and waits until everything is drawn; empty
/// text: well.
QString bring_into_state(Window& window, const QString& material, const QString& model, const QString& state);

/// The window as it is, its dialogs over its middle.
QPixmap picture_of(Window& window);

}  // namespace etak::editor
