// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>

#include "core/project/project.h"

namespace etak::editor {

// Reading and writing of files. No function here uses objects of the user interface, so all may run on
// threads of workers.

/// The kind of a file by its name.
///   spectra      pages, tables, materials, projects, material documents
///   environment  .hdr; an .exr may be one too, and counts as a picture
enum class FileKind { spectra, picture, environment, other };
FileKind kind_of_file(const QString& path);
/// Patterns of spectra and of pictures for file dialogs: "*.yml *.yaml ...", "*.png *.tif ...".
QString spectrum_patterns();
QString picture_patterns();
/// The files that are accepted, for messages about refused files.
QString expected_files();

/// The result of reading files.
struct Opened {
  Project project;
  QStringList problems;  // materials that lost their measured record, files that could not be read
  QString error;         // why nothing was read; empty where something was
};

/// Accepts the file that the command line names, which may be a pipe or standard input ("-", /dev/stdin,
/// /dev/fd/63, a named pipe) as for `etak`; see accept_input() of core/base/files/input.h. A pipe is read to
/// its end, so that no window waits for it. Returns the path to open the file by. Throws Error for a pipe
/// that cannot be read.
QString accept_named(const QString& typed);

/// Whether `path` is a pipe that accept_named() has accepted. A project of a pipe cannot be saved to it.
bool is_pipe(const QString& path);

/// Whether the file can be read and holds a project, not a material, a page or a table.
bool holds_project(const QString& path);

/// Reads a project, or a material file as a project of one material (.json). Errors are in the result.
Opened open_project(const QString& path, const MaterialLibrary& library);

/// Reads files with spectra: pages (.yml) and tables (.csv, .txt) of n, k or reflectance, material files
/// (.json), projects (.json), and material documents (.mtlx, .gltf, .glb, .usda), which give their materials. Each spectrum becomes a material with measured
/// F0. A table that contradicts itself is refused. A page or table whose id belongs to another record gets a
/// free one.
Opened import_files(const QStringList& paths, const MaterialLibrary& library);

/// Writes the project. Returns the message of an error, empty where there was none. The file is replaced as a
/// whole or not at all.
QString save_project(const Project& project, const QString& path);

/// Writes a picture as PNG. Returns the message of an error, empty where there was none.
QString save_png(const QImage& picture, const QString& path);

/// A material for a project, measured by a record of the library.
ProjectMaterial material_of(const Material& record);

/// The folder of the user's data, which is made where it is missing.
QString data_folder();
/// The folder of the user's caches, which may be missing.
QString cache_folder();

}  // namespace etak::editor
