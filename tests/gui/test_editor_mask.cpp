// SPDX-License-Identifier: Apache-2.0
// Materials by mask: worn painted steel by keys, the files those of etak pack, and bad masks told in one line.
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QProcess>

#include "app/editor/panels/mask_dialog.h"
#include "app/editor/panels/project_panel.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

// A worn patch with an edge of two texels, in three channels.
QString mask_file(TestWindow& window, const QString& name, QColor paint, QColor edge, QColor metal) {
  QImage out(64, 64, QImage::Format_RGB32);
  out.fill(paint);
  for (int y = 16; y < 48; ++y)
    for (int x = 16; x < 48; ++x)
      out.setPixelColor(x, y, x == 16 || y == 16 || x == 47 || y == 47 ? edge : metal);
  const QString file = window.file(name);
  out.save(file);
  return file;
}

// Paint and iron, both marked in the project.
void mark_paint_and_iron(TestWindow& window) {
  ProjectMaterial paint;
  paint.name = "Red paint";
  paint.diffuse = {0.3, 0.02, 0.015};
  paint.alpha_mode = AlphaMode::opaque;
  window->document().add({paint}, {}, QStringLiteral("paint"));
  QVERIFY(window->use_library_material(QStringLiteral("iron")));
  window->project_panel().list().selectAll();
}

MaskDialog* open_mask(TestWindow& window) {
  QTest::keyClick(window.window.get(), Qt::Key_M, Qt::ControlModifier);
  auto* out = window->findChild<MaskDialog*>();
  (void)QTest::qWaitFor([&] { return out == nullptr || out->isVisible(); }, 5000);
  QApplication::setActiveWindow(out);
  (void)QTest::qWaitForWindowActive(out);
  return out;
}

void type_into(MaskDialog& dialog, const QString& field, const QString& text) {
  auto* line = named<QLineEdit>(dialog, field);
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, text);
  QTest::keyClick(line, Qt::Key_Tab);
  (void)QTest::qWaitFor([&] { return !dialog.is_busy(); }, 10000);
}

QString note_of(const MaskDialog& dialog) {
  return named<QLabel>(dialog, QStringLiteral("What comes out"))->text();
}

}  // namespace

class EditorMask : public QObject {
  Q_OBJECT

 private slots:
  void worn_painted_steel_is_made_by_keys_and_is_what_etak_pack_writes() {
    TestWindow window(true);
    show_active(window);
    mark_paint_and_iron(window);
    MaskDialog* dialog = open_mask(window);
    QVERIFY(dialog != nullptr);
    QPointer<MaskDialog> still(dialog);
    const QString mask =
        mask_file(window, QStringLiteral("wear.png"), Qt::black, QColor(140, 140, 140), Qt::white);
    type_into(*dialog, QStringLiteral("Mask"), mask);
    QCOMPARE(named<QLineEdit>(*dialog, QStringLiteral("Code of material 1"))->text(), QStringLiteral("0"));
    QCOMPARE(named<QLineEdit>(*dialog, QStringLiteral("Code of material 2"))->text(), QStringLiteral("255"));
    QVERIFY2(note_of(*dialog).startsWith(QStringLiteral("Each texel")), qPrintable(note_of(*dialog)));
    QVERIFY(!named<QLabel>(*dialog, QStringLiteral("Ball of the new material"))->pixmap().isNull());
    type_into(*dialog, QStringLiteral("Name of the new material"), QStringLiteral("Worn steel"));
    QTest::keyClick(dialog, Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return still.isNull(); }, 10000));

    QCOMPARE(window->document().material()->name, std::string("Worn steel"));
    const ProjectMaterial made = *window->document().material();
    for (const Channel each : {Channel::diffuse, Channel::specular, Channel::gloss})
      QVERIFY(made.texture(each));
    QVERIFY(window.settle());
    const auto& found = window->validator().findings();
    const auto own = found.find("Worn steel");
    if (own != found.end())
      for (const Finding& each : own->second)
        QVERIFY2(each.severity == Severity::info && each.rule != "ETK102", each.message.c_str());

    QProcess etak;
    etak.setWorkingDirectory(window.folder.path());
    etak.start(QStringLiteral(ETAK_BUILD_FOLDER "/bin/etak"),
               {QStringLiteral("pack"), QStringLiteral("worn_steel.mask.json"), QStringLiteral("-o"),
                QStringLiteral("atlas"), QStringLiteral("--no-config")});
    QVERIFY(etak.waitForFinished(60000));
    for (const std::string_view ending : mask_file_endings) {
      const QString name = QStringLiteral("worn_steel") +
                           QString::fromUtf8(ending.data(), static_cast<qsizetype>(ending.size()));
      QVERIFY2(!bytes_of(window.file(name)).isEmpty(), qPrintable(name));
      QCOMPARE(bytes_of(window.file(name)), bytes_of(window.file(QStringLiteral("atlas/") + name)));
    }
    // One step of undo takes the material away; the files stay.
    window->document().undo_stack().undo();
    QCOMPARE(window->document().project().materials.size(), std::size_t{2});
  }

  void what_cannot_be_made_is_told_and_nothing_is_written() {
    TestWindow window(true);
    show_active(window);
    mark_paint_and_iron(window);
    MaskDialog* dialog = open_mask(window);
    QVERIFY(dialog != nullptr);
    QCOMPARE(
        note_of(*dialog),
        QStringLiteral(
            "Code of material 1: no code; expected a grey of 0 to 255, or an ID colour such as #ff0000"));
    auto* make = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    QVERIFY(!make->isEnabled());
    // An ID colour without a material.
    const QString ids = mask_file(window, QStringLiteral("ids.png"), Qt::red, Qt::green, Qt::blue);
    type_into(*dialog, QStringLiteral("Mask"), ids);
    type_into(*dialog, QStringLiteral("Code of material 2"), QStringLiteral("#00ff00"));
    QVERIFY2(note_of(*dialog).contains(QStringLiteral("is #0000ff, which no material has")),
             qPrintable(note_of(*dialog)));
    // A broken picture.
    write(window.file(QStringLiteral("broken.png")), bytes_of(ids).left(60));
    type_into(*dialog, QStringLiteral("Mask"), window.file(QStringLiteral("broken.png")));
    QVERIFY2(note_of(*dialog).contains(QStringLiteral("broken.png")), qPrintable(note_of(*dialog)));
    QVERIFY(!make->isEnabled());
    // Files that are there are replaced only where that is wanted.
    type_into(*dialog, QStringLiteral("Mask"),
              mask_file(window, QStringLiteral("wear.png"), Qt::black, Qt::gray, Qt::white));
    type_into(*dialog, QStringLiteral("Name of the new material"), QStringLiteral("mine"));
    QVERIFY(make->isEnabled());
    write(window.file(QStringLiteral("mine_gloss.png")), "mine");
    type_into(*dialog, QStringLiteral("Name of the new material"), QStringLiteral("Mine"));
    QVERIFY(!make->isEnabled());
    QVERIFY(named<QCheckBox>(*dialog, QStringLiteral("Replace files"))->isVisible());
    QTest::keyClick(dialog, Qt::Key_Escape);
    QCOMPARE(bytes_of(window.file(QStringLiteral("mine_gloss.png"))), QByteArray("mine"));
    QVERIFY(!QFile::exists(window.file(QStringLiteral("mine_specular.png"))));
    QCOMPARE(window->document().project().materials.size(), std::size_t{2});
    QVERIFY(window.settle());
  }
};

ETAK_GUI_TEST(EditorMask, "editor_mask")
#include "test_editor_mask.moc"
