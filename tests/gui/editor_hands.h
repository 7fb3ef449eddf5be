// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QFileDialog>
#include <QLabel>
#include <QListView>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QPushButton>
#include <QStatusBar>

#include "app/document/files.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/inspector/texture_section.h"
#include "app/editor/panels/library_model.h"
#include "app/editor/panels/library_panel.h"
#include "app/editor/panels/problem_strip.h"
#include "core/project/project.h"
#include "tests/gui/editor_support.h"

namespace etak::editor {

/// Calls `act` for the next modal dialog of a class, as soon as it is shown.
template <class Dialog>
void when_asked(const std::function<void(Dialog&)>& act) {
  auto* watch = new QTimer(qApp);
  QObject::connect(watch, &QTimer::timeout, watch, [watch, act] {
    auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    // A file dialog that still reads its folder does not accept a file yet: `act` is called again at the next
    // tick.
    const QPointer<Dialog> still(dialog);
    act(*dialog);
    if (still && still->isVisible()) return;
    watch->stop();
    watch->deleteLater();
  });
  watch->start(5);
}

inline void answer(QMessageBox::StandardButton button) {
  when_asked<QMessageBox>([button](QMessageBox& box) {
    if (auto* const chosen = box.button(button))
      chosen->click();  // a question without this button stays open
  });
}

inline void choose_file(const QString& path) {
  when_asked<QFileDialog>([path](QFileDialog& dialog) {
    dialog.selectFile(path);
    static_cast<QDialog&>(dialog).accept();
  });
}

/// A Radiance picture, width x height texels of RGBE without run lengths.
///   rgbe   called with the number of a texel, row by row; gives its four bytes
inline QByteArray radiance_picture(int width, int height, const std::function<QByteArray(int)>& rgbe) {
  QByteArray out = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + QByteArray::number(height) + " +X " +
                   QByteArray::number(width) + "\n";
  for (int i = 0; i < width * height; ++i) out += rgbe(i);
  return out;
}

/// A room with bright columns `apart` texels from each other.
inline QByteArray radiance_room(int width, int height, int apart) {
  return radiance_picture(width, height, [&](int i) {
    return i % apart < 40 ? QByteArray("\xff\xf0\xe0\x84", 4) : QByteArray("\x20\x40\x60\x7f", 4);
  });
}

inline QAction* action_named(const QObject& where, const QString& name) {
  for (QAction* each : where.findChildren<QAction*>())
    if (each->text().remove(QLatin1Char('&')).remove(QChar(0x2026)) == name) return each;
  return nullptr;
}

/// Shows the window and makes it the active one, so that its widgets can get the focus.
inline void show_active(TestWindow& window) {
  window->show();
  QApplication::setActiveWindow(window.window.get());
  QVERIFY(QTest::qWaitForWindowActive(window.window.get()));
}

/// The widget of a class that has an accessible name; null where there is none.
template <class Widget>
Widget* named(const QWidget& where, const QString& name) {
  for (Widget* each : where.findChildren<Widget*>())
    if (each->accessibleName() == name) return each;
  return nullptr;
}

/// The message in the status bar of the window.
inline QString told(TestWindow& window) {
  return window->statusBar()->currentMessage();
}

/// The row of a material in the list of the library; invalid where the list does not show it.
inline QModelIndex library_row(LibraryPanel& library, const QString& id) {
  const QAbstractItemModel* model = library.list().model();
  for (int row = 0; row < model->rowCount(); ++row)
    if (model->index(row, 0).data(LibraryModel::id_role).toString() == id) return model->index(row, 0);
  return {};
}

inline void click_row(QListView& list, const QModelIndex& row, Qt::KeyboardModifiers keys = Qt::NoModifier) {
  list.scrollTo(row);
  QTest::mouseClick(list.viewport(), Qt::LeftButton, keys, list.visualRect(row).center());
}

/// The bytes of a file; none where it cannot be read.
inline QByteArray bytes_of(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The button of a message box with this text; null where there is none.
inline QPushButton* button_of(QMessageBox& box, const QString& text) {
  for (QAbstractButton* each : box.buttons())
    if (each->text().remove(QLatin1Char('&')) == text) return qobject_cast<QPushButton*>(each);
  return nullptr;
}

/// The message box that is shown, which does not stop the event loop; null where none comes.
inline QMessageBox* open_message(TestWindow& window, int most_ms = 10000) {
  QMessageBox* out = nullptr;
  (void)QTest::qWaitFor(
      [&] {
        for (QMessageBox* each : window->findChildren<QMessageBox*>())
          if (each->isVisible()) out = each;
        return out != nullptr;
      },
      most_ms);
  return out;
}

/// The text of the window's strip of problems, which is closed; empty where none comes.
inline QString shown_message(TestWindow& window, int most_ms = 5000) {
  ProblemStrip& strip = window->problems();
  (void)QTest::qWaitFor([&] { return !strip.text().isEmpty(); }, most_ms);
  QString out = strip.text();
  strip.clear();
  return out;
}

/// Writes a grey picture of 8 x 8 texels beside the window's files, and returns its path.
inline QString grey_picture(TestWindow& window, const QString& name) {
  QImage out(8, 8, QImage::Format_RGB32);
  out.fill(QColor(120, 130, 140));
  const QString file = window.file(name);
  out.save(file);
  return file;
}

/// Gives the current material a picture, which is not looked at.
inline void put_texture(TestWindow& window, Channel channel, const QString& path) {
  window->document().change_material(QStringLiteral("texture"), 0, [&](ProjectMaterial& m) {
    set_texture(m, channel, ImageSource{path.toStdString(), {}, {}});
  });
}

/// A page of the database, as a user has it.
inline constexpr const char* glass_page =
    "REFERENCES: |\n    A. Tester. Test data. J. Tests 1, 2 (2001)\nDATA:\n  - type: tabulated nk\n"
    "    data: |\n        0.3 1.6 0\n        0.5 1.55 0\n        0.9 1.5 0\n";

/// The bytes of a project with one material of the library.
inline QByteArray project_bytes(const char* id) {
  const MaterialLibrary library = MaterialLibrary::builtin();
  Project project;
  project.materials.push_back(material_of(*library.find(id)));
  resolve(project, library);
  return QByteArray::fromStdString(format_project(project, ""));
}

/// The steps of undo that the document has taken.
inline int steps_of(TestWindow& window) {
  return window->document().undo_stack().index();
}

/// The row of a channel among the textures of the inspector; null where there is none.
inline QWidget* texture_row(TestWindow& window, Channel channel) {
  for (QWidget* each : window->inspector().textures().findChildren<QWidget*>())
    if (each->property("channel").isValid() && each->property("channel").toInt() == static_cast<int>(channel))
      return each;
  return nullptr;
}

/// Drops files on a widget as the window system does. Returns whether the widget accepted the drag.
inline bool drop(QWidget& widget, const QStringList& files) {
  QMimeData data;
  QList<QUrl> urls;
  for (const QString& each : files) urls << QUrl::fromLocalFile(each);
  data.setUrls(urls);
  const QPoint middle = widget.rect().center();
  QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&widget, &enter);
  if (!enter.isAccepted()) return false;
  QDropEvent event(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&widget, &event);
  return true;
}

}  // namespace etak::editor
