// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPixmap>

#include "app/editor/options.h"

namespace etak::editor {

class Window;

/// Brings a window into the state that the options name and writes a picture of it. Returns the exit status.
int take_screenshot(Window& window, const Options& options);

/// Opens a file or adds a material of the library, sets a model, brings the window into one of
/// screenshot_states(), and waits until everything is drawn. Returns the message of an error, empty where
/// there was none.
QString bring_into_state(Window& window, const QString& material, const QString& model, const QString& state);

/// A picture of the window, with its visible dialogs over its middle.
QPixmap picture_of(Window& window);

}  // namespace etak::editor
