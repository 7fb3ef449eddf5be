// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>

#include "core/project/project.h"

namespace etak::editor {

// What is read from and written to disk. No function here touches the UI: all run on workers' threads.

/// What a file is by its name.
///   spectra      pages, tables, materials, projects
///   environment  .hdr; an .exr may be one too, and counts as a picture
enum class FileKind { spectra, picture, environment, other };
FileKind kind_of_file(const QString& path);
/// "*.yml *.yaml ..." and "*.png *.tif ..." for dialogs.
QString spectrum_patterns();
QString picture_patterns();
/// Why files were refused.
QString expected_files();

/// What came of reading.
struct Opened {
  Project project;
  QStringList problems;  // materials that lost their measured record, files that could not be read
  QString error;         // not empty: nothing was read
};

/// Takes the file of the command line, which may be a pipe or standard input ("-", /dev/stdin, /dev/fd/63, a
/// named pipe) as for `etak`: accept_input() of core/base/files/input.h. A pipe is read to its end, so that
/// no window waits for it. Returns the path to open it by. Throws Error for a pipe that cannot be read.
QString accept_named(const QString& typed);

/// Whether `path` is of accept_named() and lies in no folder: what it holds cannot be saved to it.
bool is_pipe(const QString& path);

/// Whether the file can be read and is a project: not a material, a page or a table.
bool holds_project(const QString& path);

/// A project or a single material of one (.json).
Opened open_project(const QString& path, const MaterialLibrary& library);

/// Anything that holds spectra: pages (.yml) and tables (.csv, .txt) of n, k or reflectance, material files
/// (.json); projects (.json) give their materials. Each becomes a material with measured F0. A table that
/// contradicts itself is refused; a page or table whose id would be that of another record gets a free one.
Opened import_files(const QStringList& paths, const MaterialLibrary& library);

/// Writes the project; the message of what went wrong, empty for none. The file is replaced at once or not at
/// all.
QString save_project(const Project& project, const QString& path);

/// The same of a picture, as PNG.
QString save_png(const QImage& picture, const QString& path);

/// A material of the library as one of a project.
ProjectMaterial material_of(const Material& record);

/// A folder of the user's for data or caches, made where it is missing.
QString data_folder();
QString cache_folder();

}  // namespace etak::editor
