// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSet>
#include <QString>
#include <QStringList>

#include "core/project/project.h"

namespace etak::editor {

// Materials and choices of the user's own, in a folder that all projects share.

/// The text of a project of these materials with the spectra that they use, for the clipboard and for files: pictures are
/// named by absolute paths.
std::string text_of_materials(const Project& project, const std::vector<int>& rows);

/// The names of the user's own materials, sorted, and the file of one of them.
QStringList own_materials(const QString& folder);
QString own_material_file(const QString& folder, const QString& name);

/// Keeps each material under its name, in place of one of that name. Throws Error.
void keep_materials(const QString& folder, const Project& project, const std::vector<int>& rows);

/// Ids of the library's materials that the user has marked, one a line of a file; empty where there is none.
QSet<QString> read_favourites(const QString& folder);
/// Throws Error.
void write_favourites(const QString& folder, const QSet<QString>& favourites);

}  // namespace etak::editor
