// SPDX-License-Identifier: Apache-2.0
#include <QAction>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <cmath>

#include "app/editor/document/files.h"
#include "app/editor/panels/inspector.h"
#include "app/editor/panels/pack_dialog.h"
#include "app/editor/panels/texture_section.h"
#include "app/editor/window.h"
#include "app/viewport/background.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/exchange/gltf_material.h"
#include "core/exchange/material_x.h"

namespace etak::editor {
namespace {

constexpr int most_recent = 10;
constexpr const char* recent_key = "recent";

QString project_filter() {
  return QObject::tr("Projects and materials (*.json);;All files (*)");
}

struct Written {
  QString error, remarks;
};

Written export_file(const ProjectMaterial& m, const MaterialLibrary& library, const QString& kind,
                    const QString& path) {
  Written out;
  try {
    const std::vector<ExportSurface> surfaces{export_surface(m, library)};
    std::vector<Changes> changes;
    const std::string bytes =
        kind == QLatin1String("mtlx")
            ? material_x(surfaces, Fit::clamp, changes)
            : gltf_document(surfaces, GltfMaterialForm::metal_rough,
                            kind == QLatin1String("glb") ? GltfContainer::glb : GltfContainer::gltf,
                            Fit::clamp, changes);
    write_file(path.toStdString(), bytes, true);
    for (const Changes& each : changes)
      for (const Change& change : each)
        out.remarks += QString::fromStdString(one_line(change)) + QLatin1Char('\n');
  } catch (const Error& error) {
    out.error = QString::fromUtf8(error.what());
  }
  return out;
}

}  // namespace

// ---- opening

void Window::choose_and_open() {
  if (!may_lose_changes()) return;
  const QString file = QFileDialog::getOpenFileName(this, tr("Open"), {}, project_filter());
  if (!file.isEmpty()) open(file);
}

void Window::open(const QString& path) {
  ++busy_;
  tell(tr("Opening %1").arg(path));
  in_background(
      io_, this,
      [path, library = std::make_shared<const MaterialLibrary>(MaterialLibrary::builtin())] {
        return open_project(path, *library);
      },
      [this, path](Opened opened_project) {
        --busy_;
        if (!opened_project.error.isEmpty()) {
          if (!QFileInfo::exists(path)) forget_recent(path);
          show_problems(tr("This could not be opened"), {opened_project.error});
          emit opened(false);
          return;
        }
        // What came from a pipe is in no file yet.
        const bool pipe = is_pipe(path);
        document_.replace(std::move(opened_project.project), pipe ? QString() : path, !pipe);
        if (!pipe) note_recent(path);
        tell(tr("%1 materials").arg(document_.project().materials.size()));
        if (!opened_project.problems.isEmpty())
          show_problems(tr("Some measured records were not found; their colours are kept as numbers"),
                        opened_project.problems);
        emit opened(true);
      });
}

void Window::choose_and_import() {
  const QStringList files = QFileDialog::getOpenFileNames(
      this, tr("Import spectra"), {},
      tr("Pages, tables, materials (%1);;All files (*)").arg(spectrum_patterns()));
  if (!files.isEmpty()) import(files);
}

void Window::import(const QStringList& paths) {
  ++busy_;
  in_background(
      io_, this, [paths, library = document_.library()] { return import_files(paths, *library); },
      [this](Opened imported) {
        --busy_;
        if (!imported.problems.isEmpty()) show_problems(tr("Not all could be imported"), imported.problems);
        if (!imported.project.materials.empty()) {
          const auto count = imported.project.materials.size();
          document_.add(std::move(imported.project.materials), imported.project.spectra, tr("import"));
          tell(tr("%1 imported").arg(count));
        }
        emit opened(imported.error.isEmpty());
      });
}

void Window::take_files(const QStringList& paths) {
  QStringList spectra, pictures, refused;
  for (const QString& path : paths) switch (kind_of_file(path)) {
      case FileKind::spectra:
        spectra << path;
        break;
      case FileKind::picture:
        pictures << path;
        break;
      case FileKind::environment:
        set_environment(path);
        break;
      case FileKind::other:
        refused << tr("%1: %2").arg(QFileInfo(path).fileName(), expected_files());
    }
  if (!spectra.isEmpty()) import(spectra);
  if (!pictures.isEmpty() && document_.material() == nullptr)
    refused << tr("%1: a texture needs a material; add one from the library first")
                   .arg(QFileInfo(pictures.front()).fileName());
  else if (!pictures.isEmpty())
    inspector_->textures().take_files(pictures, Channel::diffuse);
  if (!refused.isEmpty()) show_problems(tr("Some files cannot be taken"), refused);
}

// ---- saving

bool Window::save() {
  if (document_.path().isEmpty()) {
    save_as();
    return false;
  }
  save_to(document_.path());
  return true;
}

void Window::save_as() {
  QString file = QFileDialog::getSaveFileName(
      this, tr("Save the project"),
      document_.path().isEmpty() ? QStringLiteral("project.json") : document_.path(), project_filter());
  if (file.isEmpty()) return;
  if (QFileInfo(file).suffix().isEmpty()) file += QStringLiteral(".json");
  save_to(file);
}

void Window::save_to(const QString& path) {
  // Whatever happens while the file is written, the copy holds this state.
  autosave_->write_now();
  ++busy_;
  in_background(
      io_, this,
      [path, project = document_.project(), autosave = autosave_] {
        autosave->wait();
        return save_project(project, path);
      },
      [this, path, revision = document_.revision()](const QString& error) {
        --busy_;
        if (!error.isEmpty()) {
          close_after_save_ = false;
          show_problems(tr("The project was not saved; your changes are still here"), {error});
          emit saved(false);
          return;
        }
        // What was changed while it was written is not saved.
        if (revision == document_.revision()) document_.mark_saved(path);
        note_recent(path);
        tell(tr("Saved %1").arg(path));
        emit saved(true);
        if (close_after_save_) close();
      });
}

void Window::save_material_as() {
  if (document_.material() == nullptr) return;
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save the material"),
      QString::fromStdString(document_.material()->name) + QStringLiteral(".json"), project_filter());
  if (file.isEmpty()) return;
  in_background(
      io_, this,
      [file, project = single(document_.project(), *document_.material())] {
        return save_project(project, file);
      },
      [this, file](const QString& error) {
        if (error.isEmpty())
          tell(tr("Saved %1").arg(file));
        else
          show_problems(tr("The material was not saved"), {error});
      });
}

void Window::save_picture() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Save the picture"),
                                                    QStringLiteral("picture.png"), tr("PNG (*.png)"));
  if (file.isEmpty()) return;
  in_background(
      io_, this, [file, picture = viewport_->grab_picture()] { return save_png(picture, file); },
      [this, file](const QString& error) {
        if (error.isEmpty())
          tell(tr("Saved %1").arg(file));
        else
          show_problems(tr("The picture was not saved"), {error});
      });
}

void Window::export_to(const QString& kind) {
  const ProjectMaterial* m = document_.material();
  if (m == nullptr) return;
  const QString file = QFileDialog::getSaveFileName(this, tr("Export the material"),
                                                    QString::fromStdString(m->name) + QLatin1Char('.') + kind,
                                                    QStringLiteral("*.") + kind);
  if (file.isEmpty()) return;
  in_background(
      io_, this,
      [m = *m, library = document_.library(), kind, file] { return export_file(m, *library, kind, file); },
      [this, file](const Written& written) {
        if (!written.error.isEmpty())
          show_problems(tr("The material was not exported"), {written.error});
        else if (!written.remarks.isEmpty())
          show_problems(tr("Exported %1; the target cannot hold everything").arg(file),
                        written.remarks.split(QLatin1Char('\n'), Qt::SkipEmptyParts));
        else
          tell(tr("Exported %1").arg(file));
      });
}

void Window::choose_and_pack() {
  if (document_.project().materials.empty()) return tell(tr("There is nothing to pack"));
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of the atlas"));
  if (!folder.isEmpty()) pack_to(folder);
}

PackDialog* Window::pack_to(const QString& folder) {
  auto* dialog = new PackDialog(document_.project(), document_.library(), document_.title(), folder, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
  dialog->start();
  return dialog;
}

// ---- what might be lost

bool Window::may_lose_changes() {
  if (document_.is_saved() || close_after_save_) return true;
  QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                  tr("%1 has changes that are not saved.").arg(document_.title()),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setDefaultButton(QMessageBox::Save);
  const int answer = box.exec();
  if (answer != QMessageBox::Save) return answer == QMessageBox::Discard;
  if (document_.path().isEmpty()) {
    save_as();
    if (busy_ == 0) return false;  // no name was chosen
  } else {
    save_to(document_.path());
  }
  // The caller goes on when the file is written; a failure is told and stops it.
  QEventLoop wait;
  bool well = false;
  connect(this, &Window::saved, &wait, [&](bool ok) {
    well = ok;
    wait.quit();
  });
  wait.exec(QEventLoop::ExcludeUserInputEvents);
  return well;
}

void Window::offer_recovery(const std::function<bool(const Recovery&)>& ask) {
  for (const Recovery& each : autosave_->left_behind()) {
    const QString whose = each.path.isEmpty() ? tr("a project that was never saved") : each.path;
    const bool wanted =
        ask ? ask(each)
            : QMessageBox::question(
                  this, tr("Unsaved work was found"),
                  tr("The editor ended without saving %1. Take up the last state?").arg(whose)) ==
                  QMessageBox::Yes;
    if (wanted) return recover(each);
    Autosave::discard(each);
  }
}

void Window::recover(const Recovery& recovery) {
  ++busy_;
  in_background(
      io_, this,
      [file = recovery.file, library = document_.library()] { return open_project(file, *library); },
      [this, recovery](Opened recovered) {
        if (!recovered.error.isEmpty()) {
          --busy_;
          // The copy is kept, so that somebody can look at it.
          show_problems(tr("The last state could not be read"), {recovered.error});
          emit opened(false);
          return;
        }
        document_.replace(std::move(recovered.project), recovery.path, false);
        autosave_->write_now();
        in_background(
            io_, this,
            [recovery, autosave = autosave_] {
              autosave->wait();
              Autosave::discard(recovery);
              return true;
            },
            [this](bool) {
              --busy_;
              emit opened(true);
            });
      });
}

void Window::note_recent(const QString& path) {
  if (!options_.remember) return;
  QSettings settings;
  QStringList list = settings.value(QLatin1String(recent_key)).toStringList();
  const QString whole = QFileInfo(path).absoluteFilePath();
  list.removeAll(whole);
  list.prepend(whole);
  settings.setValue(QLatin1String(recent_key), list.mid(0, most_recent));
}

void Window::forget_recent(const QString& path) {
  if (!options_.remember) return;
  QSettings settings;
  QStringList list = settings.value(QLatin1String(recent_key)).toStringList();
  list.removeAll(QFileInfo(path).absoluteFilePath());
  settings.setValue(QLatin1String(recent_key), list);
}

void Window::fill_recent(QMenu* menu) {
  menu->clear();
  const QStringList list = QSettings().value(QLatin1String(recent_key)).toStringList();
  for (const QString& each : list)
    menu->addAction(each, this, [this, each] {
      if (may_lose_changes()) open(each);
    });
  if (list.isEmpty()) menu->addAction(tr("none"))->setEnabled(false);
}

void Window::show_problems(const QString& title, const QStringList& problems) {
  constexpr int most_shown = 6;
  QString text = QStringList(problems.mid(0, most_shown)).join(QLatin1Char('\n'));
  if (problems.size() > most_shown) text += tr("\nand %1 more").arg(problems.size() - most_shown);
  auto* box = new QMessageBox(QMessageBox::Warning, windowTitle().remove(QStringLiteral("[*]")), title,
                              QMessageBox::Ok, this);
  box->setInformativeText(text);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

}  // namespace etak::editor
