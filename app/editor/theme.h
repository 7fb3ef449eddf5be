// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QApplication;
class QPalette;

namespace etak::editor {

enum class Theme { dark, light };

/// Fusion with a palette of its own and a focus frame that can be seen. Qt 6.4 cannot tell which theme the
/// desktop has.
void apply_theme(QApplication& application, Theme theme);
bool is_dark(const QPalette& palette);

/// Grey around colours: judged colours must not stand on a coloured ground.
QString name(Theme theme);
Theme theme_named(const QString& name);

}  // namespace etak::editor
