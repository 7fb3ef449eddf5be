// SPDX-License-Identifier: Apache-2.0
#include <QApplication>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTimer>
#include <cstdio>

#include "app/document/files.h"
#include "app/editor/options.h"
#include "app/editor/panels/library_panel.h"
#include "app/editor/screenshot.h"
#include "app/editor/start_time.h"
#include "app/editor/theme.h"
#include "app/editor/window.h"
#include "core/base/error.h"
#include "core/base/files/input.h"
#include "core/base/files/links.h"
#include "core/base/signals.h"
#include "core/base/text/text.h"

namespace {

// Sets the format of the contexts that QOpenGLWidget makes. Qt wants it set before QApplication is made.
void choose_gl() {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  QSurfaceFormat::setDefaultFormat(format);
}

// Ends the program once the first picture is on the screen.
void time_start(etak::editor::Window& window) {
  const auto tell = [] {
    const etak::editor::SinceStart spent = etak::editor::since_start();
    std::printf("first picture after %.0f ms, %.0f ms of processors\n", spent.clock_ms, spent.work_ms);
    std::fflush(stdout);
    QCoreApplication::exit();
  };
  // first_frame() is emitted while the window is painted; the picture is on the screen after that event.
  QObject::connect(&window, &etak::editor::Window::first_frame, &window,
                   [&window, tell] { QTimer::singleShot(0, &window, tell); });
}

}  // namespace

int main(int argc, char** argv) {
  using namespace etak::editor;
  etak::end_by_signals();
  QStringList arguments;
  for (int i = 0; i < argc; ++i) arguments << QString::fromLocal8Bit(argv[i]);
  Options options = parse_options(arguments);
  // Errors and help are written before QApplication is made, which needs a display.
  if (!options.error.isEmpty()) {
    std::fprintf(stderr, "etak-editor: %s\n", qPrintable(options.error));
    return 2;
  }
  if (options.help) return std::fputs(qPrintable(help_text()), stdout) < 0 ? 2 : 0;
  if (options.version) return std::puts("etak-editor " ETAK_VERSION) < 0 ? 2 : 0;

  if (options.input_timeout) etak::set_input_timeout(*options.input_timeout);
  try {
    for (QString& subject : options.subjects) subject = accept_named(subject);
  } catch (const etak::Error& error) {
    std::fprintf(stderr, "etak-editor: %s\n", etak::line_text(error.what()).c_str());
    return 2;
  }

  choose_gl();
  QApplication application(argc, argv);
  QApplication::setOrganizationName("etak");
  QApplication::setApplicationName("etak-editor");
  QApplication::setApplicationVersion(QStringLiteral(ETAK_VERSION));
  QApplication::setDesktopFileName("etak-editor");
  const bool picture = !options.screenshot.isEmpty();
  const Theme remembered = picture ? Theme::dark : theme_named(QSettings().value("theme").toString());
  apply_theme(application, options.theme.value_or(remembered));

  // The user chose the pictures of a project in this editor, so links to other folders are followed.
  etak::set_follow_links(true);

  // A screenshot reads and writes no settings, caches or copies of the user.
  QTemporaryDir own;
  WindowOptions window_options;
  window_options.cpu_viewport = options.cpu;
  window_options.theme_given = options.theme.has_value();
  if (picture) {
    window_options.data_folder = own.path();
    window_options.cache_folder = own.path();
    window_options.remember = false;
  }
  Window window(window_options);
  if (picture) return take_screenshot(window, options);
  if (options.time_start) time_start(window);
  window.show();
  if (options.time_start) return QApplication::exec();
  QTimer::singleShot(0, &window, [&] {
    // A recovered project is not saved yet: the file of the command line must not replace it unasked.
    if (window.offer_recovery()) return;
    if (!options.subjects.isEmpty()) return window.open(options.subjects.front());
    // A metal to begin with, in place of a black ball.
    emit window.library_panel().looked_at(QStringLiteral("gold"));
  });
  return QApplication::exec();
}
