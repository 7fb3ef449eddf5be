// SPDX-License-Identifier: Apache-2.0
#include "app/editor/document/files.h"

#include <QBuffer>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include "app/viewport/qt_text.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/text/free_names.h"
#include "core/exchange/material_file.h"
#include "core/image/picture_endings.h"
#include "core/material/appearance.h"
#include "core/material/json.h"

namespace etak::editor {
namespace {

QString patterns(const QStringList& endings) {
  return QStringLiteral("*.") + endings.join(QStringLiteral(" *."));
}

QString listed_endings(const QStringList& endings) {
  return QStringLiteral(".") + endings.join(QStringLiteral(", ."));
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

// What a text holds that is no project and no material, told by its first bytes; null where it may be one.
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

void note(Opened& out, const std::vector<std::string>& problems) {
  for (const std::string& each : problems) out.problems << QString::fromStdString(each);
}

}  // namespace

FileKind kind_of_file(const QString& path) {
  const QString ending = QFileInfo(path).suffix().toLower();
  if (kind_of_spectra(path) != MaterialFileKind::none) return FileKind::spectra;
  if (texts(picture_endings).contains(ending)) return FileKind::picture;
  return ending == qt_text(radiance_ending) ? FileKind::environment : FileKind::other;
}

QString spectrum_patterns() {
  return patterns(texts(material_file_endings()));
}

QString picture_patterns() {
  return patterns(texts(picture_endings));
}

QString expected_files() {
  return QObject::tr(
             "expected spectra, materials or projects (%1), pictures (%2) or an environment (.hdr, .exr)")
      .arg(listed_endings(texts(material_file_endings())), listed_endings(texts(picture_endings)));
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
  if (!path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive)) return false;
  try {
    return is_project(read_file(path.toStdString()));
  } catch (const Error&) {
    return false;  // the function that opens the file reports the reason
  } catch (const std::bad_alloc&) {
    return false;
  }
}

Opened open_project(const QString& path, const MaterialLibrary& library) {
  Opened out;
  try {
    const std::string file = path.toStdString();
    const std::string text = read_file(file);
    if (!is_project(text)) {
      // A material file as the library has them: the project gets its record.
      const Material record = material_in(text, file);
      out.project.spectra.push_back(record);
      out.project.materials.push_back(material_of(record));
    } else {
      out.project = parse_project(text, file);
    }
    note(out, resolve(out.project, library));
  } catch (const Error& error) {
    out.error = QString::fromUtf8(error.what());
  } catch (const std::bad_alloc&) {
    out.error = path + QStringLiteral(": not enough memory");
  }
  return out;
}

Opened import_files(const QStringList& paths, const MaterialLibrary& library) {
  Opened out;
  MadeIds ids(library);
  for (const QString& path : paths) {
    try {
      const MaterialFileKind kind = kind_of_spectra(path);
      if (kind == MaterialFileKind::none) {
        out.problems << path + QStringLiteral(": ") + expected_files();
        continue;
      }
      if (kind == MaterialFileKind::material) {
        Opened one = open_project(path, library);
        if (!one.error.isEmpty()) {
          out.problems << one.error;
          continue;
        }
        out.problems << one.problems;
        for (Material& each : one.project.spectra) out.project.spectra.push_back(std::move(each));
        for (ProjectMaterial& each : one.project.materials) out.project.materials.push_back(std::move(each));
        continue;
      }
      Project one;
      one.spectra.push_back(read_material_file(path.toStdString(), kind));
      ids.give(one.spectra.front());
      one.materials.push_back(material_of(one.spectra.front()));
      note(out, resolve(one, library));
      if (!one.materials.front().measured) continue;
      out.project.spectra.push_back(std::move(one.spectra.front()));
      out.project.materials.push_back(std::move(one.materials.front()));
    } catch (const Error& error) {
      out.problems << QString::fromUtf8(error.what());
    }
  }
  if (out.project.materials.empty() && !out.problems.isEmpty())
    out.error = out.problems.join(QLatin1Char('\n'));
  return out;
}

QString save_project(const Project& project, const QString& path) {
  try {
    write_file(path.toStdString(), format_project(project, path.toStdString()), true);
    return {};
  } catch (const Error& error) {
    return QString::fromUtf8(error.what());
  } catch (const std::bad_alloc&) {
    return path + QStringLiteral(": not enough memory");
  }
}

QString save_png(const QImage& picture, const QString& path) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  if (!buffer.open(QIODevice::WriteOnly) || !picture.save(&buffer, "PNG"))
    return QObject::tr("%1: the picture could not be encoded").arg(path);
  try {
    write_file(path.toStdString(), bytes.toStdString(), true);
    return {};
  } catch (const Error& error) {
    return QString::fromUtf8(error.what());
  }
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
