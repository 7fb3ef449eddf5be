// SPDX-License-Identifier: Apache-2.0
#include "app/editor/screenshot.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QImage>
#include <QPainter>
#include <QPixmap>
#include <QPlainTextEdit>
#include <QSaveFile>
#include <QTabWidget>
#include <QThread>
#include <cstdio>

#include "app/editor/inspector.h"
#include "app/editor/library_panel.h"
#include "app/editor/press_id.h"
#include "app/editor/shortcuts.h"
#include "app/editor/texture_section.h"
#include "app/editor/texture_view.h"
#include "app/editor/view_panel.h"
#include "app/editor/window.h"

namespace etak::editor {
namespace {

// Until workers have nothing left to do and what they told has been drawn.
void settle(Window& window) {
  constexpr int most_ms = 20000, quiet_ms = 250;
  QElapsedTimer all, quiet;
  all.start();
  quiet.start();
  while (all.elapsed() < most_ms) {
    QApplication::processEvents(QEventLoop::AllEvents, 20);
    if (window.is_busy() || !window.thumbnails().is_idle() || !window.validator().is_idle()) quiet.restart();
    if (quiet.elapsed() > quiet_ms) return;
    QThread::msleep(5);
  }
}

void edit_material(Window& window, const std::function<void(ProjectMaterial&)>& change) {
  if (window.document().material() == nullptr) return;
  ProjectMaterial m = *window.document().material();
  change(m);
  window.document().edit(window.document().current(), m, QObject::tr("edit"), next_press_id());
}

}  // namespace

QString bring_into_state(Window& window, const QString& material, const QString& model,
                         const QString& state) {
  settle(window);
  Document& document = window.document();
  if (!material.isEmpty()) {
    if (QFileInfo::exists(material)) {
      window.open(material);
      settle(window);
      if (document.path().isEmpty()) return QObject::tr("%1 could not be opened").arg(material);
    } else if (!window.use_library_material(material)) {
      return QObject::tr("%1 is no file, and no material of the library").arg(material);
    }
  }
  if (!model.isEmpty())
    edit_material(window, [&](ProjectMaterial& m) { m.specular_model = model.toStdString(); });
  Look& look = window.look();
  if (state == QLatin1String("light")) window.inspector_tabs().setCurrentIndex(1);
  if (state == QLatin1String("view")) window.inspector_tabs().setCurrentIndex(2);
  if (state == QLatin1String("compare")) {
    look.pinned = document.material() != nullptr ? *document.material() : ProjectMaterial{};
    look.split = true;
    window.use_library_material(QStringLiteral("copper"));
    window.inspector_tabs().setCurrentIndex(2);
  }
  if (state == QLatin1String("wedge")) look.wedge = true;
  if (state == QLatin1String("zone")) {
    look.zone_overlay = true;
    window.use_library_material(QStringLiteral("silicon"));
  }
  if (state == QLatin1String("shader"))
    window.tabs().setCurrentWidget(window.tabs().findChild<QPlainTextEdit*>());
  if (state == QLatin1String("textures")) window.tabs().setCurrentWidget(&window.texture_view());
  if (state == QLatin1String("findings"))
    edit_material(window, [](ProjectMaterial& m) {
      m.measured.reset();
      m.specular = {0.3, 0.3, 0.3};
      m.diffuse = {0.98, 0.98, 0.98};
    });
  window.look_changed();
  settle(window);
  return {};
}

int take_screenshot(Window& window, const Options& options) {
  window.resize(options.size);
  window.show();
  const QString problem = bring_into_state(window, options.subjects.value(0), options.model, options.state);
  if (!problem.isEmpty()) {
    std::fprintf(stderr, "etak-editor: %s\n", qPrintable(problem));
    return 2;
  }
  QPixmap picture = window.grab();
  if (options.state == QLatin1String("keys")) {
    ShortcutsDialog keys(window, &window);
    keys.show();
    settle(window);
    QPainter painter(&picture);
    painter.drawPixmap((window.width() - keys.width()) / 2, (window.height() - keys.height()) / 2,
                       keys.grab());
  }
  QSaveFile file(options.screenshot);
  if (!file.open(QIODevice::WriteOnly) || !picture.toImage().save(&file, "PNG") || !file.commit()) {
    std::fprintf(stderr, "etak-editor: %s: %s\n", qPrintable(options.screenshot),
                 qPrintable(file.errorString()));
    return 2;
  }
  return 0;
}

}  // namespace etak::editor
