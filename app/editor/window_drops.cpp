// SPDX-License-Identifier: Apache-2.0
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>

#include "app/editor/document/files.h"
#include "app/editor/panels/inspector.h"
#include "app/editor/panels/texture_section.h"
#include "app/editor/window.h"
#include "app/viewport/background.h"

namespace etak::editor {

bool Window::can_take(const QStringList& files) {
  const auto known = [](const QString& file) { return kind_of_file(file) != FileKind::other; };
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
        refused << tr("%1: %2").arg(QFileInfo(path).fileName(), expected_files());
    }
  if (!spectra.isEmpty()) take_spectra(spectra);
  if (!pictures.isEmpty() && document_.material() == nullptr)
    refused << tr("%1: a texture needs a material; add one from the library first")
                   .arg(QFileInfo(pictures.front()).fileName());
  else if (!pictures.isEmpty())
    inspector_->textures().take_files(pictures, Channel::diffuse);
  if (!refused.isEmpty()) show_problems(tr("Some files cannot be taken"), refused);
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
