// SPDX-License-Identifier: Apache-2.0
#include "app/document/files.h"

#include <QBuffer>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include "app/document/look.h"
#include "app/viewport/background.h"
#include "app/viewport/qt_text.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/text/free_names.h"
#include "core/exchange/material_file.h"
#include "core/image/picture_endings.h"
#include "core/material/appearance.h"
#include "core/material/json.h"
#include "core/project/project_import.h"

namespace etak::editor {
namespace {

const QStringList surface_endings{"mtlx", "gltf", "glb", "usda"};

QString patterns(const QStringList& endings) {
  return "*." + endings.join(" *.");
}

QString listed_endings(const QStringList& endings) {
  return "." + endings.join(", .");
}

QStringList texts(std::span<const std::string_view> endings) {
  QStringList out;
  for (const std::string_view each : endings) out << qt_text(each);
  return out;
}

MaterialFileKind kind_of_spectra(const QString& path) {
  return material_file_kind(path.toStdString());
}

// Gives unique ids to records of pages and tables, whose ids are derived from their files, so that two files
// may have the same one. A record whose id belongs to another record gets a new id, because the materials of
// that record must keep its data. A file that is imported again unchanged keeps its id.
class MadeIds {
 public:
  explicit MadeIds(const MaterialLibrary& library) : library_(library) {
    for (const std::string& id : library.ids()) ids_.take(id);
  }

  void give(Material& record) {
    const std::string wanted = record.id;
    if (library_.find(wanted) == record) return;
    record.id = ids_.free(wanted, [&](int i) { return wanted + '_' + std::to_string(i); });
  }

 private:
  const MaterialLibrary& library_;
  FreeNames ids_;
};

// The kind of a text that is no project and no material, by its first bytes; null where it may be one.
const char* told_by_content(std::string_view text) {
  switch (content_kind(text)) {
    case ContentKind::gltf:
      return "holds a glTF scene";
    case ContentKind::page:
    case ContentKind::table:
      return "holds a page or a table, which is imported and not opened";
    case ContentKind::binary:
      return "holds no text";
    case ContentKind::json:
    case ContentKind::prose:
      break;
  }
  return nullptr;
}

Material material_in(const std::string& text, const std::string& file) {
  try {
    return parse_material(text, file);
  } catch (const Error&) {
    const char* other = told_by_content(text);
    if (other != nullptr) throw Error::at(file, other, "a project or a material (.json)");
    throw;
  }
}

QString file_failure(const QString& path, const std::function<void()>& work) {
  return failure_of(work, path + ": not enough memory");
}

void note(Opened& out, const std::vector<std::string>& problems) {
  for (const std::string& each : problems) out.problems << QString::fromStdString(each);
}

}  // namespace

FileKind kind_of_file(const QString& path) {
  const QString ending = QFileInfo(path).suffix().toLower();
  if (kind_of_spectra(path) != MaterialFileKind::none || holds_surfaces(path.toStdString()))
    return FileKind::spectra;
  if (texts(picture_endings).contains(ending)) return FileKind::picture;
  return ending == qt_text(radiance_ending) ? FileKind::environment : FileKind::other;
}

QString spectrum_patterns() {
  return patterns(texts(material_file_endings()) + surface_endings);
}

QString picture_patterns() {
  return patterns(texts(picture_endings));
}

QString expected_files() {
  return QObject::
      tr("expected spectra, materials or projects (%1), material documents (%3), pictures (%2) or an environment (.hdr, .exr)")
          .arg(listed_endings(texts(material_file_endings())), listed_endings(texts(picture_endings)),
               listed_endings(surface_endings));
}

ProjectMaterial material_of(const Material& record) {
  ProjectMaterial out;
  out.name = record.name;
  out.measured = MeasuredF0{record.id, {}, {}, {}};
  // Materials are opaque, except for clear bodies. The mode is written, because files without one mean blend.
  out.alpha_mode = AlphaMode::opaque;
  const bool clear = clarity(record, record.preferred_dataset()).clear;
  if (optical_kind(record.material_class) == "dielectric" && !clear) out.diffuse = {0.25, 0.25, 0.25};
  // Alpha is the opacity of the body; a clear body shows the background.
  if (clear) {
    out.alpha = 0;
    out.alpha_mode = AlphaMode::blend;
  }
  out.gloss = default_gloss(record, clear).gloss;
  return out;
}

QString accept_named(const QString& typed) {
  const std::string path = accept_input(typed.toStdString());
  if (is_pipe_input(path)) (void)read_file(path);
  return QString::fromStdString(path);
}

bool is_pipe(const QString& path) {
  return is_pipe_input(path.toStdString());
}

bool holds_project(const QString& path) {
  bool out = false;
  // The function that opens the file reports why it cannot be read.
  if (path.endsWith(".json", Qt::CaseInsensitive))
    (void)failure_of([&] { out = is_project(read_file(path.toStdString())); });
  return out;
}

Opened open_project(const QString& path, const MaterialLibrary& library) {
  Opened out;
  out.error = file_failure(path, [&] {
    const std::string file = path.toStdString();
    const std::string text = read_file(file);
    if (!is_project(text)) {
      // A material file as the library has them: the project gets its record.
      const Material record = material_in(text, file);
      out.project = new_project();
      out.project.spectra.push_back(record);
      out.project.materials.push_back(material_of(record));
    } else {
      out.project = parse_project(text, file);
    }
    note(out, resolve(out.project, library));
  });
  return out;
}

Opened import_files(const QStringList& paths, const MaterialLibrary& library) {
  Opened out;
  MadeIds ids(library);
  const auto take = [&](Project& one) {
    for (Material& each : one.spectra) out.project.spectra.push_back(std::move(each));
    for (ProjectMaterial& each : one.materials) out.project.materials.push_back(std::move(each));
  };
  const auto import = [&](const QString& path) {
    if (holds_surfaces(path.toStdString())) {
      Project one;
      std::vector<std::string> remarks;
      one.materials = imported_materials(path.toStdString(), remarks);
      note(out, remarks);
      return take(one);
    }
    const MaterialFileKind kind = kind_of_spectra(path);
    if (kind == MaterialFileKind::none) throw Error((path + ": " + expected_files()).toStdString());
    if (kind == MaterialFileKind::material) {
      Opened one = open_project(path, library);
      if (!one.error.isEmpty()) throw Error(one.error.toStdString());
      out.problems << one.problems;
      return take(one.project);
    }
    Project one;
    one.spectra.push_back(read_material_file(path.toStdString(), kind));
    ids.give(one.spectra.front());
    one.materials.push_back(material_of(one.spectra.front()));
    note(out, resolve(one, library));
    if (one.materials.front().measured) take(one);
  };
  for (const QString& path : paths)
    if (const QString failure = file_failure(path, [&] { import(path); }); !failure.isEmpty())
      out.problems << failure;
  if (out.project.materials.empty()) out.error = out.problems.join('\n');
  return out;
}

QString save_project(const Project& project, const QString& path) {
  return file_failure(
      path, [&] { write_file(path.toStdString(), format_project(project, path.toStdString()), true); });
}

QString save_png(const QImage& picture, const QString& path) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  if (!buffer.open(QIODevice::WriteOnly) || !picture.save(&buffer, "PNG"))
    return QObject::tr("%1: the picture could not be encoded").arg(path);
  return file_failure(path, [&] { write_file(path.toStdString(), bytes.toStdString(), true); });
}

QString data_folder() {
  const QString out = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  QDir().mkpath(out);
  return out;
}

QString cache_folder() {
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation);
}

}  // namespace etak::editor
