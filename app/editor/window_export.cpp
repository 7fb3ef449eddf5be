// SPDX-License-Identifier: Apache-2.0
#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

#include "app/editor/fields/path_edit.h"
#include "app/editor/panels/project_panel.h"
#include "app/editor/window.h"
#include "app/viewport/background.h"
#include "app/viewport/qt_text.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/exchange/engine_values.h"
#include "core/exchange/gltf_material.h"
#include "core/exchange/material_x.h"

namespace etak::editor {
namespace {

// Throws Error for a material with textures: the targets take numbers only, and a texture would be lost
// without a message.
void refuse_textures(const ProjectMaterial& m) {
  QStringList channels;
  for (const Channel each : all_channels)
    if (m.texture(each)) channels << qt_text(name(each));
  if (channels.isEmpty()) return;
  throw Error(
      QObject::tr("%1 has textures (%2), which this export cannot hold: it writes numbers alone. Pack the "
                  "atlas for the textures, or take them off a copy of the material")
          .arg(qt_text(m.name), channels.join(QStringLiteral(", ")))
          .toStdString());
}

struct Written {
  QString error, remarks;
};

Written export_file(const std::vector<ProjectMaterial>& materials, const MaterialLibrary& library,
                    const QString& kind, const QString& path) {
  Written out;
  try {
    std::vector<ExportSurface> surfaces;
    for (const ProjectMaterial& each : materials) {
      refuse_textures(each);
      surfaces.push_back(export_surface(each, library));
    }
    std::vector<Changes> changes;
    const std::string bytes =
        kind == QLatin1String("mtlx")
            ? material_x(surfaces, Fit::clamp, changes)
            : gltf_document(surfaces, GltfMaterialForm::metal_rough,
                            kind == QLatin1String("glb") ? GltfContainer::glb : GltfContainer::gltf,
                            Fit::clamp, changes);
    write_file(path.toStdString(), bytes, true);
    for (std::size_t i = 0; i < changes.size(); ++i)
      for (const Change& change : changes[i])
        out.remarks += (changes.size() > 1 ? qt_text(materials[i].name) + QStringLiteral(": ") : QString()) +
                       qt_text(one_line(change)) + QLatin1Char('\n');
  } catch (const Error& error) {
    out.error = QString::fromUtf8(error.what());
  }
  return out;
}

}  // namespace

void Window::fill_export_menu(QMenu* menu, ExportOf which) {
  const bool one = which == ExportOf::one;
  action(menu, tr("&MaterialX\u2026"), one ? QKeySequence(Qt::CTRL | Qt::Key_E) : QKeySequence(),
         [this, which] { export_to(QStringLiteral("mtlx"), which); });
  action(menu, tr("&glTF\u2026"), {}, [this, which] { export_to(QStringLiteral("gltf"), which); });
  action(menu, tr("g&lTF, binary\u2026"), {}, [this, which] { export_to(QStringLiteral("glb"), which); });
}

void Window::export_to(const QString& kind, ExportOf which) {
  const std::vector<ProjectMaterial>& all = document_.project().materials;
  std::vector<ProjectMaterial> materials;
  if (which == ExportOf::all) materials = all;
  if (which == ExportOf::one && document_.material() != nullptr) materials = {*document_.material()};
  if (which == ExportOf::selected)
    for (const int row : project_panel_->selected()) materials.push_back(all[static_cast<std::size_t>(row)]);
  if (materials.empty()) return tell(tr("There is nothing to export"));
  // A '/' in a name must not become a folder.
  const QString whose = materials.size() == 1 ? qt_text(materials.front().name).replace(u'/', u'_')
                                              : QFileInfo(document_.title()).completeBaseName();
  const QString file = QFileDialog::getSaveFileName(
      this,
      materials.size() == 1 ? tr("Export the material") : tr("Export %1 materials").arg(materials.size()),
      beside_project(whose + QLatin1Char('.') + kind), QStringLiteral("*.") + kind);
  if (file.isEmpty()) return;
  in_background(
      io_, this,
      [materials, library = document_.library(), kind, file] {
        return export_file(materials, *library, kind, file);
      },
      [this, file](const Written& written) {
        if (!written.error.isEmpty())
          show_problems(tr("Nothing was exported"), {written.error});
        else if (!written.remarks.isEmpty())
          show_problems(tr("Exported %1; the target cannot hold everything").arg(file),
                        written.remarks.split(QLatin1Char('\n'), Qt::SkipEmptyParts));
        else
          tell(tr("Exported %1").arg(short_path(file)));
      });
}

void Window::copy_value(const EngineTarget& target) {
  const ProjectMaterial* m = look_.preview ? &*look_.preview : document_.material();
  if (m == nullptr) return;
  try {
    refuse_textures(*m);
    const EngineValues values = engine_values(target, export_surface(*m, *document_.library()));
    const QString copied = QString::fromStdString(copy_text(values));
    QApplication::clipboard()->setText(copied);
    QString message =
        tr("Copied for %1: %2").arg(qt_text(target.title), copied.section(QLatin1Char('\n'), 0, 0));
    for (const Change& change : values.changes) message += QStringLiteral("; ") + qt_text(one_line(change));
    tell(message);
  } catch (const Error& error) {
    tell(QString::fromUtf8(error.what()));
  }
}

void Window::fill_copy_menu(QMenu* menu) {
  for (const EngineTarget& target : engine_targets())
    action(menu, qt_text(target.title),
           target.id == "hex" ? QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C) : QKeySequence(),
           [this, &target] { copy_value(target); });
}

}  // namespace etak::editor
