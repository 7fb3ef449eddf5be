// SPDX-License-Identifier: Apache-2.0
#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>
#include <cmath>

#include "app/document/files.h"
#include "app/editor/panels/pack_dialog.h"
#include "app/editor/panels/picture_dialog.h"
#include "app/editor/panels/problem_strip.h"
#include "app/editor/window.h"
#include "app/fields/path_edit.h"
#include "app/viewport/background.h"

namespace etak::editor {
namespace {

constexpr int most_recent = 10;
constexpr const char* recent_key = "recent";

QString project_filter() {
  return QObject::tr("Projects and materials (*.json);;All files (*)");
}

}  // namespace

// ---- opening

void Window::choose_and_open() {
  if (!may_lose_changes()) return;
  const QString file = QFileDialog::getOpenFileName(this, tr("Open"), beside_project(), project_filter());
  if (!file.isEmpty()) open(file);
}

void Window::open(const QString& path) {
  tell(tr("Opening %1").arg(short_path(path)));
  struct Read {
    Opened project;
    bool is_there = false;  // found out by the worker, because a network share may be slow to answer
  };
  read_or_write(
      [path] {
        Opened project = open_project(path, MaterialLibrary::builtin());
        return Read{std::move(project), QFileInfo::exists(path)};
      },
      [this, path, revision = document_.revision()](Read read) {
        Opened& opened_project = read.project;
        if (!opened_project.error.isEmpty()) {
          if (!read.is_there) change_recent(path, false);
          show_problems(tr("This could not be opened"), {opened_project.error});
          emit opened(false);
          return;
        }
        // The user may have changed the document while the file was read.
        if (!may_replace(revision)) {
          tell(tr("%1 was not opened").arg(short_path(path)));
          emit opened(false);
          return;
        }
        // A project that was read from a pipe has no file yet.
        const bool pipe = is_pipe(path);
        document_.replace(std::move(opened_project.project), pipe ? QString() : path, !pipe);
        if (!pipe) change_recent(path, true);
        tell(tr("%1 materials").arg(document_.project().materials.size()));
        if (!opened_project.problems.isEmpty())
          show_problems(tr("Some measured records were not found; their colours are kept as numbers"),
                        opened_project.problems);
        emit opened(true);
      });
}

void Window::choose_and_import() {
  const QStringList files = QFileDialog::getOpenFileNames(
      this, tr("Import spectra"), beside_project(),
      tr("Pages, tables, materials (%1);;All files (*)").arg(spectrum_patterns()));
  if (!files.isEmpty()) import(files);
}

void Window::import(const QStringList& paths) {
  read_or_write([paths, library = document_.library()] { return import_files(paths, *library); },
                [this](Opened imported) {
                  if (!imported.problems.isEmpty())
                    show_problems(tr("Not all could be imported"), imported.problems);
                  if (!imported.project.materials.empty()) {
                    const auto count = imported.project.materials.size();
                    document_.add(std::move(imported.project.materials), imported.project.spectra,
                                  tr("import"));
                    tell(tr("%1 imported").arg(count));
                  }
                  emit opened(imported.error.isEmpty());
                });
}

// ---- saving

QString Window::beside_project(const QString& file) const {
  return document_.path().isEmpty() ? file : document_.folder() + '/' + file;
}

void Window::save() {
  if (document_.path().isEmpty())
    save_as();
  else
    save_to(document_.path());
}

QString Window::name_to_save(const QString& title, const QString& proposed, const QString& filter,
                             const QString& ending) {
  const QFileInfo first(proposed);
  QFileDialog dialog(this, title, first.absolutePath(), filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(ending);
  dialog.selectFile(first.fileName());
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

bool Window::save_as() {
  const QString file =
      name_to_save(tr("Save the project"), document_.path().isEmpty() ? "project.json" : document_.path(),
                   project_filter(), "json");
  if (file.isEmpty()) return false;
  save_to(file);
  return true;
}

void Window::save_to(const QString& path) {
  take_typed();
  // The copy of the autosave holds this state if the writing of the file fails.
  autosave_->write_now();
  read_or_write(
      [path, project = document_.project(), autosave = autosave_] {
        autosave->wait();
        return save_project(project, path);
      },
      [this, path, revision = document_.revision(),
       generation = document_.generation()](const QString& error) {
        if (!error.isEmpty()) {
          show_problems(tr("The project was not saved; your changes are still here"), {error});
          emit saved(false);
          return;
        }
        // Changes that were made during the writing are not saved, but the project now has this file. Another
        // project that was opened meanwhile does not get it.
        if (revision == document_.revision())
          document_.mark_saved(path);
        else if (generation == document_.generation())
          document_.set_path(path);
        change_recent(path, true);
        tell(tr("Saved %1").arg(short_path(path)));
        emit saved(true);
      });
}

void Window::save_material_as() {
  if (document_.material() == nullptr) return;
  const QString file = name_to_save(
      tr("Save the material"),
      beside_project(QString::fromStdString(document_.material()->name).replace(u'/', u'_') + ".json"),
      project_filter(), "json");
  if (file.isEmpty()) return;
  write_in_background(file, tr("The material was not saved"),
                      [file, project = single(document_.project(), *document_.material())] {
                        return save_project(project, file);
                      });
}

void Window::save_picture() {
  const auto ask = [this] {
    return name_to_save(tr("Save the picture"), beside_project("picture.png"), tr("PNG (*.png)"), "png");
  };
  auto* dialog = new PictureDialog(viewport_->saved_view(), ask, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PictureDialog::written, this, [this](const QStringList& files) {
    tell(files.size() == 1
             ? tr("Saved %1").arg(short_path(files.front()))
             : tr("Saved %1 pictures, the first is %2").arg(files.size()).arg(short_path(files.front())));
  });
  dialog->open();
}

void Window::write_in_background(const QString& file, const QString& failed,
                                 const std::function<QString()>& write) {
  read_or_write(write, [this, file, failed](const QString& error) {
    if (error.isEmpty())
      tell(tr("Saved %1").arg(short_path(file)));
    else
      show_problems(failed, {error});
  });
}

void Window::choose_and_pack() {
  if (document_.project().materials.empty()) return tell(tr("There is nothing to pack"));
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of the atlas"), beside_project());
  if (!folder.isEmpty()) pack_to(folder);
}

PackDialog* Window::pack_to(const QString& folder) {
  auto* dialog = new PackDialog(document_.project(), document_.library(), document_.title(), folder, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
  dialog->start();
  return dialog;
}

void Window::change_recent(const QString& path, bool keep) {
  if (!options_.remember) return;
  QSettings settings;
  QStringList list = settings.value(QLatin1String(recent_key)).toStringList();
  const QString whole = QFileInfo(path).absoluteFilePath();
  list.removeAll(whole);
  if (keep) list.prepend(whole);
  settings.setValue(QLatin1String(recent_key), list.mid(0, most_recent));
}

void Window::fill_recent(QMenu* menu) {
  menu->clear();
  const QStringList list = QSettings().value(QLatin1String(recent_key)).toStringList();
  menu->setToolTipsVisible(true);
  for (const QString& each : list) {
    // In the text of a menu, '&' marks a key and "&&" is the character.
    QAction* out = menu->addAction(short_path(each).replace(u'&', "&&"), this, [this, each] {
      if (may_lose_changes()) open(each);
    });
    out->setToolTip(each);
  }
  if (list.isEmpty()) menu->addAction(tr("none"))->setEnabled(false);
}

void Window::show_problems(const QString& title, const QStringList& problems) {
  problems_->add(title, problems);
}

}  // namespace etak::editor
