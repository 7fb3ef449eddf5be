// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QApplication;
class QPalette;

namespace etak::editor {

enum class Theme { dark, light };

/// Sets Qt's Fusion style with a palette of the editor's own. The palette is grey, because the user judges
/// colours, which must not stand on a coloured ground. Qt 6.4 cannot tell which theme the desktop has.
void apply_theme(QApplication& application, Theme theme);
bool is_dark(const QPalette& palette);

/// "dark" or "light", as options and settings name the themes; any other text means dark.
QString name(Theme theme);
Theme theme_named(const QString& name);

}  // namespace etak::editor
