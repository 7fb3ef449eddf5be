// SPDX-License-Identifier: Apache-2.0
// Packing in the window ends with the findings of the validator, which equal those of etak pack for the same
// project.
#include <QProcess>

#include "app/editor/panels/pack_dialog.h"
#include "core/base/files/file.h"
#include "core/image/files/png.h"
#include "tests/gui/editor_support.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

// A picture of F0 and gloss: a dielectric in the left half, and an F0 between dielectrics and metals in the
// right.
std::string specular_png() {
  Image8 image(64, 64, 4);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t code = x < 32 ? 56 : 150;
      const std::array<std::uint8_t, 4> texel{code, code, code, static_cast<std::uint8_t>(100 + x % 7)};
      std::copy(texel.begin(), texel.end(), image.at(x, y).begin());
    }
  return png_bytes({{image.width, image.height, 4, 8}, image.values.data(), std::size_t{64} * 4}, {});
}

Project project_in(const TestWindow& window) {
  const std::string path = window.file(QStringLiteral("spec.png")).toStdString();
  write_file(path, specular_png(), true);
  Project out;
  ProjectMaterial textured, numbers, clean;
  textured.name = "crate";
  textured.diffuse = {0.2, 0.1, 0.1};
  ImageSource specular;
  specular.path = path;
  textured.texture(Channel::specular) = specular;
  numbers.name = "impossible";
  numbers.specular = {0.3, 0.3, 0.3};
  clean.name = "plastic";
  clean.diffuse = {0.5, 0.1, 0.1};
  out.materials = {textured, numbers, clean};
  return out;
}

// The lines of a report that hold findings and the verdict.
QStringList findings_in(const QString& text) {
  QStringList out;
  for (const QString& line : text.split(QLatin1Char('\n')))
    if (line.contains(QLatin1String("ETK")) || line.startsWith(QLatin1String("FAILED")) ||
        line.startsWith(QLatin1String("PASSED")))
      out << line.trimmed();
  return out;
}

QStringList packed_in_window(TestWindow& window) {
  PackDialog* dialog = window->pack_to(window.file(QStringLiteral("atlas")));
  QSignalSpy packed(dialog, &PackDialog::finished_packing);
  if (!QTest::qWaitFor([&] { return packed.count() == 1; }, 60000)) return {};
  const QStringList out = findings_in(dialog->result_text());
  dialog->reject();
  return out;
}

QStringList packed_by_etak(TestWindow& window) {
  QDir(window.file(QStringLiteral("atlas"))).removeRecursively();
  QProcess etak;
  etak.setWorkingDirectory(window.folder.path());
  etak.start(QStringLiteral(ETAK_BUILD_FOLDER "/bin/etak"),
             {QStringLiteral("pack"), QStringLiteral("project.json"), QStringLiteral("-o"),
              QStringLiteral("atlas")});
  if (!etak.waitForFinished(60000)) return {};
  return findings_in(QString::fromUtf8(etak.readAllStandardOutput()));
}

}  // namespace

class EditorPack : public QObject {
  Q_OBJECT

 private slots:
  void packing_shows_the_findings_of_etak_pack() {
    TestWindow window(true);
    const Project project = project_in(window);
    const QString file = window.file(QStringLiteral("project.json"));
    write_file(file.toStdString(), format_project(project, file.toStdString()), true);
    QSignalSpy opened(window.window.get(), &Window::opened);
    window->open(file);
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, 20000));
    QCOMPARE(window->document().project().materials.size(), std::size_t{3});

    const QStringList shown = packed_in_window(window);
    QVERIFY2(shown.filter(QStringLiteral("ETK101")).size() == 2, qPrintable(shown.join(QLatin1Char('\n'))));
    QVERIFY2(shown.last().startsWith(QStringLiteral("FAILED: 2 errors")), qPrintable(shown.last()));
    QCOMPARE(shown, packed_by_etak(window));

    // Both use the configuration beside the atlas.
    write(window.file(QStringLiteral("etak.toml")), "[[allow]]\nrule = \"ETK1\"\nreason = \"made up\"\n");
    const QStringList allowed = packed_in_window(window);
    QVERIFY(allowed.filter(QStringLiteral("ETK101")).isEmpty());
    QCOMPARE(allowed, packed_by_etak(window));
    QVERIFY(window.settle());
  }

  void a_broken_configuration_is_told_and_nothing_is_written() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    write(window.file(QStringLiteral("etak.toml")), "[rules\n");
    PackDialog* dialog = window->pack_to(window.file(QStringLiteral("atlas")));
    QSignalSpy packed(dialog, &PackDialog::finished_packing);
    QVERIFY(QTest::qWaitFor([&] { return packed.count() == 1; }, 60000));
    QVERIFY(!packed.front().front().toBool());
    QVERIFY(dialog->result_text().contains(QStringLiteral("etak.toml")));
    QVERIFY(!QFile::exists(window.file(QStringLiteral("atlas"))));
    dialog->reject();
    QVERIFY(window.settle());
  }
};

ETAK_GUI_TEST(EditorPack, "editor_pack")
#include "test_editor_pack.moc"
