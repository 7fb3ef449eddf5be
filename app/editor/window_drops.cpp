// SPDX-License-Identifier: Apache-2.0
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>

#include "app/document/dropped_pictures.h"
#include "app/document/files.h"
#include "app/document/press_id.h"
#include "app/editor/panels/drop_table.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/inspector/texture_section.h"
#include "app/editor/panels/texture_view.h"
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
                  if (!dropped.refused.isEmpty())
                    show_problems(tr("Some files cannot be taken"), dropped.refused);
                  if (dropped.rows.empty()) return;
                  const DroppedRow& first = dropped.rows.front();
                  if (dropped.needs_table())
                    ask_what_goes_where(std::move(dropped));
                  else if (first.channel)
                    take_sets(dropped, false);
                  else
                    show_problems(tr("Some files cannot be taken"),
                                  {tr("%1: %2: %3")
                                       .arg(QFileInfo(qt_text(first.source.path)).fileName(), first.holds,
                                            first.remark)});
                });
}

void Window::ask_what_goes_where(DroppedPictures dropped) {
  const ProjectMaterial* onto = document_.material();
  auto* table = new DropTable(std::move(dropped), onto != nullptr ? qt_text(onto->name) : QString(), this);
  table->setAttribute(Qt::WA_DeleteOnClose);
  connect(table, &QDialog::accepted, this,
          [this, table] { take_sets(table->dropped(), table->makes_new()); });
  table->open();
}

void Window::take_sets(const DroppedPictures& dropped, bool fresh) {
  texture_view_->take_known(dropped.decoded);
  if (!fresh && dropped.sets.size() == 1 && document_.material() != nullptr)
    document_.change_material(tr("textures"), next_press_id(),
                              [&](ProjectMaterial& m) { take_set(dropped, 0, m); });
  else
    document_.add(materials_of(dropped), {}, tr("materials of pictures"));
  texture_view_->take_known({});
  tell(taken_text(dropped));
}

void Window::take_picture(Channel channel, const QString& file) {
  struct Read {
    QString failure;
    GreenAxis green = GreenAxis::unsaid;
  };
  read_or_write(
      [file, normal = channel == Channel::normal] {
        Read out{picture_failure(file)};
        if (normal && out.failure.isEmpty()) out.green = green_of(file.toStdString());
        return out;
      },
      [this, channel, file, at = document_.current(), generation = document_.generation()](const Read& read) {
        if (!read.failure.isEmpty()) return show_problems(tr("This cannot be taken"), {read.failure});
        if (at == document_.current() && generation == document_.generation())
          take_sets({{document_.material()->name},
                     {{0, {}, channel, {file.toStdString(), {}, {}}, read.green}},
                     {}},
                    false);
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
