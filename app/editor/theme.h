// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QApplication;
class QPalette;

namespace etak::editor {

enum class Theme { dark, light };

/// Sets Qt's Fusion style with a palette of the editor's own. The palette is grey, because the user judges
/// colours, which must not stand on a coloured ground.
void apply_theme(QApplication& application, Theme theme);
bool is_dark(const QPalette& palette);

/// "dark" or "light", as options and settings name the themes; any other text means that of the desktop.
QString name(Theme theme);
Theme theme_named(const QString& name);
/// The theme of the desktop, by the palette that the application has without one of its own: Qt 6.4 has no other sign of it.
Theme desktop_theme();

}  // namespace etak::editor
