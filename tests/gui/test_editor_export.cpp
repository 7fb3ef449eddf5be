// SPDX-License-Identifier: Apache-2.0
// Exports to other programs: each form, one material or several, textures, and values for the clipboard.
#include <QClipboard>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QMenu>
#include <QSpinBox>
#include <QStatusBar>
#include <QXmlStreamReader>

#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/inspector/texture_section.h"
#include "app/editor/panels/picture_dialog.h"
#include "app/editor/panels/project_panel.h"
#include "core/exchange/engine_values.h"
#include "core/scene/gltf.h"
#include "tests/gltf_judge.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

void export_as(TestWindow& window, const char* form, const QString& file) {
  choose_file(file);
  action_named(*window, QLatin1String(form))->trigger();
}

}  // namespace

class EditorExport : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QApplication::setAttribute(Qt::AA_DontUseNativeDialogs); }

  void every_export_writes_its_file() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    const auto exported = [&](const QString& name, const QString& file) {
      choose_file(window.file(file));
      action_named(*window, name)->trigger();
      if (!QTest::qWaitFor([&] { return QFile::exists(window.file(file)); }, 20000)) return QByteArray();
      return bytes_of(window.file(file));
    };
    const QByteArray mtlx = exported(QStringLiteral("MaterialX"), QStringLiteral("gold.mtlx"));
    // Gold's red is above 1, which the format cannot hold: a message tells that it was clamped.
    QVERIFY(shown_message(window).contains(QLatin1String("clamp")));
    QXmlStreamReader xml(mtlx);
    bool surface = false;
    while (!xml.atEnd())
      if (xml.readNext() == QXmlStreamReader::StartElement)
        surface = surface || xml.name() == QLatin1String("open_pbr_surface");
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QVERIFY(surface);
    const QByteArray gltf = exported(QStringLiteral("glTF"), QStringLiteral("gold.gltf"));
    QVERIFY(QJsonDocument::fromJson(gltf).object().contains(QLatin1String("materials")));
    (void)shown_message(window);
    QVERIFY(exported(QStringLiteral("glTF, binary"), QStringLiteral("gold.glb")).startsWith("glTF"));
    (void)shown_message(window);
    QVERIFY(exported(QStringLiteral("Save material as"), QStringLiteral("one.json")).contains("\"Gold\""));
  }

  void every_form_of_a_value_is_copied() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    const ExportSurface surface =
        export_surface(*window->document().material(), *window->document().library());
    QVERIFY(engine_targets().size() >= 10);
    for (const EngineTarget& target : engine_targets()) {
      QApplication::clipboard()->setText(QStringLiteral("nothing"));
      const auto title = QString::fromUtf8(target.title.data(), static_cast<qsizetype>(target.title.size()));
      QAction* copy = action_named(*window, title);
      QVERIFY2(copy != nullptr, qPrintable(title));
      copy->trigger();
      QCOMPARE(QApplication::clipboard()->text(),
               QString::fromStdString(copy_text(engine_values(target, surface))));
    }
    const EngineTarget* hexadecimal = engine_target("hex");
    QVERIFY(QString::fromStdString(copy_text(engine_values(*hexadecimal, surface)))
                .contains(QLatin1String("#ffe49c"), Qt::CaseInsensitive));
  }

  void the_film_of_layers_is_copied_with_its_error() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("anodised_titanium_40nm")));
    action_named(*window, QStringLiteral("glTF 2.0 metal-rough"))->trigger();
    QVERIFY(QApplication::clipboard()->text().contains(
        QLatin1String("KHR_materials_iridescence.iridescenceThicknessMaximum: ")));
    const QString message = window->statusBar()->currentMessage();
    QVERIFY2(message.contains(QLatin1String("error: dE2000 ")), qPrintable(message));
  }

  // The wood of this test has a texture of its colour and one of its gloss.
  void a_textured_material_is_exported_with_its_textures() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    put_texture(window, Channel::diffuse, grey_picture(window, QStringLiteral("wood.png")));
    put_texture(window, Channel::gloss, grey_picture(window, QStringLiteral("wood_gloss.png")));
    put_texture(window, Channel::normal, grey_picture(window, QStringLiteral("wood_normal.png")));
    window->document().change_material(QStringLiteral("scale"), 0, [](ProjectMaterial& m) {
      m.uv_scale = {3, 1.5};
    });
    std::vector<std::string> files;
    for (const char* ending : {"gltf", "glb"}) {
      const QString file = window.file(QStringLiteral("wood.") + QLatin1String(ending));
      export_as(window, ending == std::string("glb") ? "glTF, binary" : "glTF", file);
      QVERIFY(QTest::qWaitFor([&] { return QFile::exists(file); }, 20000));
      (void)shown_message(window, 300);
      files.push_back(file.toStdString());
      const GltfScene scene = read_gltf(files.back(), {});
      QCOMPARE(scene.images.size(), std::size_t{3});
      QVERIFY(scene.materials[0].normal_texture.has_value());
      for (const auto& texture : {scene.materials[0].base_color_texture, scene.materials[0].normal_texture}) {
        QCOMPARE(texture->transform.scale[0], 3.0);
        QCOMPARE(texture->transform.scale[1], 1.5);
      }
      QVERIFY(scene.materials[0].base_color_texture && scene.materials[0].metallic_roughness_texture);
      for (const PictureFile& each : scene.images) {
        const QImage image = QImage::fromData(QByteArray::fromStdString(each.bytes), "png");
        QCOMPARE(image.size(), QSize(8, 8));
      }
    }
    const auto messages = test::gltf_messages(window.folder.path().toStdString(), files);
    if (!messages) qWarning("no node with gltf-validator (NODE_PATH): what is written is not validated");
    QCOMPARE(messages.value_or(""), std::string());

    const QString mtlx = window.file(QStringLiteral("wood.mtlx"));
    export_as(window, "MaterialX", mtlx);
    QVERIFY(QTest::qWaitFor([&] { return QFile::exists(mtlx); }, 20000));
    (void)shown_message(window, 300);
    QXmlStreamReader xml(bytes_of(mtlx));
    QVERIFY(bytes_of(mtlx).contains("<normalmap"));
    QCOMPARE(bytes_of(mtlx).count("name=\"uvtiling\" type=\"vector2\" value=\"3, 1.5\""), 3);
    QStringList images;
    while (!xml.atEnd())
      if (xml.readNext() == QXmlStreamReader::StartElement &&
          xml.attributes().value(QLatin1String("name")) == QLatin1String("file"))
        images << xml.attributes().value(QLatin1String("value")).toString();
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QCOMPARE(images, (QStringList{QStringLiteral("wood_base_color.png"),
                                  QStringLiteral("wood_specular_roughness.png"),
                                  QStringLiteral("wood_geometry_normal.png")}));
    const QImage color(window.file(images[0]));
    QCOMPARE(color.pixelColor(3, 3), QColor(120, 130, 140));
  }

  void a_texture_that_cannot_be_read_stops_the_export_with_a_message() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    put_texture(window, Channel::gloss, window.file(QStringLiteral("wood_gloss.png")));
    for (const char* kind : {"MaterialX", "glTF", "glTF, binary"}) {
      const QString file = window.file(QStringLiteral("out.x"));
      export_as(window, kind, file);
      const QString told = shown_message(window, 10000);
      QVERIFY2(told.contains(QLatin1String("Nothing was exported")) &&
                   told.contains(QLatin1String("wood_gloss.png")),
               qPrintable(told));
      QVERIFY(!QFile::exists(file));
    }
  }

  // The clipboard gets numbers alone.
  void values_of_a_textured_material_are_not_copied() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    put_texture(window, Channel::gloss, grey_picture(window, QStringLiteral("wood_gloss.png")));
    QApplication::clipboard()->setText(QStringLiteral("nothing"));
    for (const EngineTarget& target : engine_targets()) {
      action_named(*window,
                   QString::fromUtf8(target.title.data(), static_cast<qsizetype>(target.title.size())))
          ->trigger();
      QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("nothing"));
      QVERIFY2(told(window).contains(QLatin1String("Gold has textures (gloss)")), qPrintable(told(window)));
    }
  }

  void a_name_without_an_ending_is_asked_for_as_the_file_that_it_becomes() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    write(window.file(QStringLiteral("gold.glb")), "an older file");
    int questions = 0;
    when_asked<QFileDialog>([&](QFileDialog& dialog) {
      dialog.setDirectory(window.folder.path());
      dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(QStringLiteral("gold"));
      // The question whether the file is to be replaced.
      QTimer::singleShot(50, &dialog, [&questions] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (box == nullptr) return;
        ++questions;
        box->button(QMessageBox::No)->click();
      });
      static_cast<QDialog&>(dialog).accept();
      dialog.reject();
    });
    action_named(*window, QStringLiteral("glTF, binary"))->trigger();
    QCOMPARE(questions, 1);
    QVERIFY(window.settle());
    QCOMPARE(bytes_of(window.file(QStringLiteral("gold.glb"))), QByteArray("an older file"));
  }

  // Types as a user does: each field takes the keys when it has the focus.
  static void type_picture(PictureDialog& dialog, const char* width, const char* height, bool transparent,
                           const char* count) {
    const auto type = [](QWidget* field, const char* text) {
      field->setFocus(Qt::TabFocusReason);
      QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
      QTest::keyClicks(field, QLatin1String(text));
    };
    type(named<QSpinBox>(dialog, QStringLiteral("Width of the picture")), width);
    type(named<QSpinBox>(dialog, QStringLiteral("Height of the picture")), height);
    if (transparent)
      QTest::keyClick(named<QComboBox>(dialog, QStringLiteral("Background of the picture")), Qt::Key_Down);
    type(named<QSpinBox>(dialog, QStringLiteral("Pictures of the turntable")), count);
    QTest::keyClick(&dialog, Qt::Key_Return);
  }

  static PictureDialog* picture_dialog(TestWindow& window) {
    show_active(window);
    QTest::keyClick(window.window.get(), Qt::Key_S, Qt::ControlModifier | Qt::AltModifier);
    (void)QTest::qWaitFor([&] { return window->findChild<PictureDialog*>() != nullptr; });
    return window->findChild<PictureDialog*>();
  }

  void a_picture_of_any_size_is_saved_with_and_without_its_background() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    show_active(window);
    QVERIFY(window.settle());
    for (const bool transparent : {false, true}) {
      const QString file = window.file(transparent ? QStringLiteral("cut.png") : QStringLiteral("whole.png"));
      PictureDialog* dialog = picture_dialog(window);
      QVERIFY(dialog != nullptr);
      choose_file(file);
      type_picture(*dialog, "300", "200", transparent, "1");
      QVERIFY(QTest::qWaitFor([&] { return window->findChild<PictureDialog*>() == nullptr; }, 60000));
      QVERIFY2(told(window).contains(QLatin1String("Saved")), qPrintable(told(window)));
      const QImage picture(file);
      QCOMPARE(picture.size(), QSize(300, 200));
      QCOMPARE(picture.hasAlphaChannel(), transparent);
      QCOMPARE(qAlpha(picture.pixel(2, 2)), transparent ? 0 : 255);
      QCOMPARE(qAlpha(picture.pixel(150, 100)), 255);
    }
    // The gold itself is the same with and without what is behind it.
    const QColor a = QImage(window.file(QStringLiteral("whole.png"))).pixelColor(150, 100),
                 b = QImage(window.file(QStringLiteral("cut.png"))).pixelColor(150, 100);
    QCOMPARE(a.rgb(), b.rgb());
  }

  void a_turntable_is_saved_whole_or_not_at_all() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("copper")));
    show_active(window);
    QVERIFY(window.settle());
    PictureDialog* dialog = picture_dialog(window);
    QVERIFY(dialog != nullptr);
    choose_file(window.file(QStringLiteral("turn.png")));
    type_picture(*dialog, "64", "64", false, "12");
    QVERIFY(QTest::qWaitFor([&] { return window->findChild<PictureDialog*>() == nullptr; }, 60000));
    const QStringList made = QDir(window.file(QString())).entryList({QStringLiteral("turn*")});
    QCOMPARE(made.size(), 12);
    QCOMPARE(made.front(), QStringLiteral("turn_01.png"));
    QVERIFY(bytes_of(window.file(made[0])) != bytes_of(window.file(made[6])));
    // A second one of that name takes no file's place.
    dialog = picture_dialog(window);
    QVERIFY(dialog != nullptr);
    choose_file(window.file(QStringLiteral("turn.png")));
    type_picture(*dialog, "64", "64", false, "12");
    const auto* note = named<QLabel>(*dialog, QStringLiteral("What saving is at"));
    QVERIFY(QTest::qWaitFor([&] { return note->text().contains(QLatin1String("is there already")); }, 10000));
    // One that is cancelled leaves nothing.
    choose_file(window.file(QStringLiteral("other.png")));
    type_picture(*dialog, "1500", "1500", false, "40");
    QVERIFY(QTest::qWaitFor([&] { return dialog->is_running(); }, 10000));
    QTest::keyClick(dialog, Qt::Key_Escape);
    QVERIFY(QTest::qWaitFor([&] { return !dialog->is_running(); }, 60000));
    QVERIFY2(note->text().contains(QLatin1String("Cancelled")), qPrintable(note->text()));
    QVERIFY(QDir(window.file(QString())).entryList({QStringLiteral("other*")}).isEmpty());
    QTest::keyClick(dialog, Qt::Key_Escape);
  }

  void one_the_selected_or_all_materials_are_exported() {
    TestWindow window(true);
    for (const char* id : {"gold", "copper", "iron"})
      QVERIFY(window->use_library_material(QLatin1String(id)));
    show_active(window);
    QListView& list = window->project_panel().list();
    click_row(list, list.model()->index(0, 0));
    click_row(list, list.model()->index(2, 0), Qt::ControlModifier);
    QCOMPARE(window->project_panel().selected(), (std::vector<int>{0, 2}));
    const auto exported = [&](const char* which) {
      const QString file = window.file(QLatin1String(which) + QStringLiteral(".mtlx"));
      choose_file(file);
      for (QMenu* menu : window->findChildren<QMenu*>())
        if (menu->accessibleName() == QLatin1String(which)) menu->actions().front()->trigger();
      (void)QTest::qWaitFor([&] { return QFile::exists(file); }, 20000);
      (void)shown_message(window, 300);
      return bytes_of(file).count("<open_pbr_surface");
    };
    QCOMPARE(exported("Export material"), 1);
    QCOMPARE(exported("Export selected materials"), 2);
    QCOMPARE(exported("Export all materials"), 3);
  }
};

ETAK_GUI_TEST(EditorExport, "editor_export")
#include "test_editor_export.moc"
