// SPDX-License-Identifier: Apache-2.0
#include <QApplication>
#include <QClipboard>
#include <QFileInfo>
#include <QMenu>

#include "app/document/pictures.h"
#include "app/editor/panels/project_panel.h"
#include "app/editor/window.h"
#include "app/fields/path_edit.h"
#include "app/viewport/background.h"
#include "app/viewport/qt_text.h"
#include "core/base/error.h"
#include "core/base/text/text.h"
#include "core/exchange/engine_values.h"
#include "core/exchange/export_values.h"
#include "core/project/command_line.h"
#include "core/project/project_export.h"

namespace etak::editor {
namespace {

// Throws Error for a material with textures, which numbers to be copied cannot hold.
void refuse_textures(const ProjectMaterial& m) {
  QStringList channels;
  for (const Channel each : all_channels)
    if (m.texture(each)) channels << qt_text(name(each));
  if (channels.isEmpty()) return;
  throw Error(
      QObject::tr(
          "%1 has textures (%2), which numbers to be copied cannot hold: export it as MaterialX or glTF, or pack the atlas")
          .arg(qt_text(m.name), channels.join(", "))
          .toStdString());
}

struct Written {
  QString error, remarks;
};

Written export_file(const std::vector<ProjectMaterial>& materials, const MaterialLibrary& library,
                    ExportForm form, const QString& path) {
  Written out;
  const auto work = [&] {
    const std::vector<Changes> changes =
        export_materials(materials, library, form, Fit::clamp, picture_door(), path.toStdString());
    for (std::size_t i = 0; i < changes.size(); ++i)
      for (const Change& change : changes[i])
        out.remarks += (changes.size() > 1 ? qt_text(materials[i].name) + ": " : QString()) +
                       qt_text(one_line(change)) + '\n';
  };
  out.error = failure_of(work, QObject::tr("There is not enough memory for the textures"));
  return out;
}

QString ending_of(ExportForm form) {
  return form == ExportForm::material_x ? "mtlx" : form == ExportForm::gltf ? "gltf" : "glb";
}

}  // namespace

void Window::fill_export_menu(QMenu* menu, ExportOf which) {
  const bool one = which == ExportOf::one;
  action(menu, tr("&MaterialX\u2026"), one ? QKeySequence(Qt::CTRL | Qt::Key_E) : QKeySequence(),
         [this, which] { export_to(ExportForm::material_x, which); });
  action(menu, tr("&glTF\u2026"), {}, [this, which] { export_to(ExportForm::gltf, which); });
  action(menu, tr("g&lTF, binary\u2026"), {}, [this, which] { export_to(ExportForm::glb, which); });
}

void Window::export_to(ExportForm form, ExportOf which) {
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
  const QString ending = ending_of(form);
  const QString file = name_to_save(
      materials.size() == 1 ? tr("Export the material") : tr("Export %1 materials").arg(materials.size()),
      beside_project(whose + '.' + ending), "*." + ending, ending);
  if (file.isEmpty()) return;
  tell(tr("Exporting %1").arg(short_path(file)));
  read_or_write([materials, library = document_.library(), form,
                 file] { return export_file(materials, *library, form, file); },
                [this, file](const Written& written) {
                  if (!written.error.isEmpty())
                    show_problems(tr("Nothing was exported"), {written.error});
                  else if (!written.remarks.isEmpty())
                    show_problems(tr("Exported %1; the target cannot hold everything").arg(file),
                                  written.remarks.split('\n', Qt::SkipEmptyParts));
                  else
                    tell(tr("Exported %1").arg(short_path(file)));
                });
}

void Window::copy_value(const EngineTarget& target) {
  const ProjectMaterial* m = look_.preview ? &*look_.preview : document_.material();
  if (m == nullptr) return;
  QString message;
  const QString failure = failure_of([&] {
    refuse_textures(*m);
    const EngineValues values = engine_values(target, export_surface(*m, *document_.library()));
    const QString copied = QString::fromStdString(copy_text(values));
    QApplication::clipboard()->setText(copied);
    message = tr("Copied for %1: %2").arg(qt_text(target.title), copied.section('\n', 0, 0));
    if (const std::string error = error_line(values); !error.empty()) message += "; " + qt_text(error);
    for (const Change& change : values.changes) message += "; " + qt_text(one_line(change));
  });
  tell(failure.isEmpty() ? message : failure);
}

void Window::copy_command() {
  const ProjectMaterial* m = look_.preview ? &*look_.preview : document_.material();
  if (m == nullptr) return;
  const CommandLine line = render_command(document_.project(), *m, look_.camera, look_.engine);
  const QString text = qt_text(line.text) + (look_.perspective ? " --perspective" : "");
  QApplication::clipboard()->setText(text);
  QString message = tr("Copied: %1").arg(text);
  if (!line.left_out.empty()) message += tr(". It does not say: %1").arg(qt_text(joined(line.left_out)));
  tell(message);
}

void Window::fill_copy_menu(QMenu* menu) {
  for (const EngineTarget& target : engine_targets())
    action(menu, qt_text(target.title),
           target.id == "hex" ? QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C) : QKeySequence(),
           [this, &target] { copy_value(target); });
}

}  // namespace etak::editor
