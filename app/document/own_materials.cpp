// SPDX-License-Identifier: Apache-2.0
#include "app/document/own_materials.h"

#include <QDir>
#include <QFile>
#include <QUrl>
#include <algorithm>

#include "core/base/error.h"
#include "core/base/files/file.h"

namespace etak::editor {
namespace {

constexpr const char* ending = ".json";

QString materials_folder(const QString& folder) {
  return folder + QStringLiteral("/materials");
}

QString favourites_file(const QString& folder) {
  return folder + QStringLiteral("/favourites.txt");
}

void make_folder(const QString& folder) {
  if (!QDir().mkpath(folder))
    throw Error::at(folder.toStdString(), "cannot be made", "a folder of the user's own");
}

}  // namespace

std::string text_of_materials(const Project& project, const std::vector<int>& rows) {
  Project out;
  for (const int row : rows) {
    const ProjectMaterial& m = project.materials[static_cast<std::size_t>(row)];
    const Project one = single(project, m);
    out.materials.push_back(m);
    for (const Material& each : one.spectra)
      if (std::ranges::none_of(out.spectra, [&](const Material& other) { return other.id == each.id; }))
        out.spectra.push_back(each);
  }
  return format_project(out, "");
}

QStringList own_materials(const QString& folder) {
  QStringList out;
  for (const QString& each :
       QDir(materials_folder(folder))
           .entryList({QStringLiteral("*") + ending}, QDir::Files, QDir::Name | QDir::IgnoreCase))
    out << QUrl::fromPercentEncoding(each.chopped(static_cast<qsizetype>(qstrlen(ending))).toUtf8());
  return out;
}

QString own_material_file(const QString& folder, const QString& name) {
  // A name may hold what a file's name must not.
  return materials_folder(folder) + '/' + QString::fromLatin1(QUrl::toPercentEncoding(name, " ,()")) + ending;
}

void keep_materials(const QString& folder, const Project& project, const std::vector<int>& rows) {
  make_folder(materials_folder(folder));
  for (const int row : rows) {
    const std::string& name = project.materials[static_cast<std::size_t>(row)].name;
    write_file(own_material_file(folder, QString::fromStdString(name)).toStdString(),
               text_of_materials(project, {row}), true);
  }
}

QSet<QString> read_favourites(const QString& folder) {
  QSet<QString> out;
  QFile file(favourites_file(folder));
  if (!file.open(QIODevice::ReadOnly)) return out;
  constexpr qint64 most = qint64{1} << 20;
  for (const QByteArray& line : file.read(most).split('\n'))
    if (!line.trimmed().isEmpty()) out.insert(QString::fromUtf8(line.trimmed()));
  return out;
}

void write_favourites(const QString& folder, const QSet<QString>& favourites) {
  make_folder(folder);
  QStringList sorted(favourites.begin(), favourites.end());
  sorted.sort();
  write_file(favourites_file(folder).toStdString(), (sorted.join('\n') + '\n').toStdString(), true);
}

}  // namespace etak::editor
