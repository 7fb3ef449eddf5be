// SPDX-License-Identifier: Apache-2.0
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>

#include "app/editor/document/dropped_pictures.h"
#include "app/editor/document/files.h"
#include "app/editor/fields/press_id.h"
#include "app/editor/panels/inspector.h"
#include "app/editor/panels/texture_section.h"
#include "app/editor/window.h"
#include "app/viewport/background.h"
#include "app/viewport/qt_text.h"

namespace etak::editor {

bool Window::can_take(const QStringList& files) {
  const auto known = [](const QString& file) {
    return kind_of_file(file) != FileKind::other || QFileInfo(file).isDir();
  };
  if (std::any_of(files.begin(), files.end(), known)) return true;
  if (!files.isEmpty()) tell(tr("%1: %2").arg(QFileInfo(files.front()).fileName(), expected_files()));
  return false;
}

void Window::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasFormat(QString::fromLatin1(Viewport::material_mime)) ||
      can_take(dragged_files(*event->mimeData())))
    event->acceptProposedAction();
  else
    event->ignore();
}

void Window::dropEvent(QDropEvent* event) {
  const QMimeData& dropped = *event->mimeData();
  if (dropped.hasFormat(QString::fromLatin1(Viewport::material_mime)))
    use_library_material(QString::fromUtf8(dropped.data(QString::fromLatin1(Viewport::material_mime))));
  else
    take_files(dragged_files(dropped));
  event->acceptProposedAction();
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
        if (QFileInfo(path).isDir())
          pictures << path;
        else
          refused << tr("%1: %2").arg(QFileInfo(path).fileName(), expected_files());
    }
  if (!spectra.isEmpty()) take_spectra(spectra);
  if (!pictures.isEmpty())
    take_pictures(pictures, refused);
  else if (!refused.isEmpty())
    show_problems(tr("Some files cannot be taken"), refused);
}

void Window::take_pictures(const QStringList& files, const QStringList& refused) {
  read_or_write([files] { return sort_pictures(files); },
                [this, refused, at = document_.current(),
                 generation = document_.generation()](DroppedPictures dropped) {
                  dropped.refused = refused + dropped.refused;
                  if (at != document_.current() || generation != document_.generation())
                    return tell(tr("The pictures were not taken: another material is in hand now"));
                  take_sets(dropped.sets);
                  if (!dropped.refused.isEmpty())
                    show_problems(tr("Some files cannot be taken"), dropped.refused);
                });
}

void Window::take_sets(const std::vector<DroppedSet>& sets) {
  if (sets.empty()) return;
  QStringList names;
  for (const DroppedSet& set : sets) {
    QStringList channels;
    for (const auto& [channel, path] : set.files) channels << qt_text(name(channel));
    names << tr("%1: %2").arg(qt_text(set.name), channels.join(QLatin1String(", ")));
  }
  if (sets.size() == 1 && document_.material() != nullptr) {
    document_.change_material(tr("textures"), next_press_id(),
                              [&](ProjectMaterial& m) { take_set(sets.front(), m); });
  } else {
    std::vector<ProjectMaterial> materials;
    for (const DroppedSet& set : sets) materials.push_back(material_of(set));
    document_.add(std::move(materials), {}, tr("materials of pictures"));
  }
  tell(names.join(QLatin1String("; ")));
}

void Window::take_picture(Channel channel, const QString& file) {
  read_or_write([file] { return picture_failure(file); },
                [this, channel, file, at = document_.current(),
                 generation = document_.generation()](const QString& failure) {
                  if (!failure.isEmpty()) return show_problems(tr("This cannot be taken"), {failure});
                  if (at == document_.current() && generation == document_.generation())
                    take_sets({DroppedSet{document_.material()->name, {{channel, file}}}});
                });
}

void Window::take_spectra(const QStringList& files) {
  if (files.size() > 1) return import(files);
  read_or_write([file = files.front()] { return holds_project(file); },
                [this, files](bool project) {
                  if (project)
                    ask_open_or_add(files.front());
                  else
                    import(files);
                });
}

void Window::ask_open_or_add(const QString& project) {
  auto* box =
      new QMessageBox(QMessageBox::Question, tr("A project was dropped"),
                      tr("%1 is a project.").arg(QFileInfo(project).fileName()), QMessageBox::Cancel, this);
  box->setInformativeText(tr("Open it in place of the one under work, or add its materials to that?"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* open_it = box->addButton(tr("Open"), QMessageBox::AcceptRole);
  QPushButton* add_it = box->addButton(tr("Add"), QMessageBox::AcceptRole);
  connect(box, &QMessageBox::buttonClicked, this,
          [this, project, open_it, add_it](const QAbstractButton* chosen) {
            if (chosen == add_it) import({project});
            if (chosen == open_it && may_lose_changes()) open(project);
          });
  box->open();
}

}  // namespace etak::editor
