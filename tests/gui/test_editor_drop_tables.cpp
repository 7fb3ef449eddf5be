// SPDX-License-Identifier: Apache-2.0
// Dropped sets of pictures, and the table of what goes where.
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>

#include "app/document/dropped_pictures.h"
#include "app/editor/panels/drop_table.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/inspector/texture_section.h"
#include "app/editor/panels/texture_view.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

// The table of what goes where that is shown; null where none comes.
DropTable* open_table(TestWindow& window, int most_ms = 10000) {
  (void)QTest::qWaitFor(
      [&] {
        const auto* shown = window->findChild<DropTable*>();
        return shown != nullptr && shown->isVisible();
      },
      most_ms);
  return window->findChild<DropTable*>();
}

// What the table says, a line for each row: "wood_n.png | normal | skip | | remark".
QStringList lines_of(const DropTable& table) {
  QStringList out;
  for (const DroppedRow& row : table.dropped().rows) {
    const std::string_view word = row.channel ? name(*row.channel) : "skip";
    out << QFileInfo(QString::fromStdString(row.source.path)).fileName() + QStringLiteral(" | ") + row.holds +
               QStringLiteral(" | ") + QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size())) +
               (row.remark.isEmpty() ? QString() : QStringLiteral(" | ") + row.remark);
  }
  return out;
}

// Drops files, and takes what the table then proposes. Returns what it said.
QStringList drop_and_take(TestWindow& window, const QStringList& files) {
  QStringList out;
  if (!drop(window->viewport(), files)) return out;
  if (DropTable* table = open_table(window)) {
    out = lines_of(*table);
    QTest::keyClick(table, Qt::Key_Return);
  }
  (void)QTest::qWaitFor([&] { return window->findChild<DropTable*>() == nullptr; }, 5000);
  (void)window.settle();
  return out;
}

// The same of pictures that are made under these names.
QStringList drop_pictures(TestWindow& window, const QStringList& names) {
  QStringList files;
  for (const QString& each : names) files << grey_picture(window, each);
  return drop_and_take(window, files);
}

// The pictures of a material: "diffuse wood.png, roughness wood_orm.png:g".
QString slots_of(const ProjectMaterial& material) {
  QStringList out;
  for (const Channel channel : all_channels)
    if (const auto& texture = material.texture(channel)) {
      const std::string_view word = name(channel);
      out << QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size())) + QLatin1Char(' ') +
                 QFileInfo(QString::fromStdString(texture->path)).fileName() +
                 (texture->channels.empty() ? QString()
                                            : QLatin1Char(':') + QString::fromStdString(texture->channels));
    }
  return out.join(QLatin1String(", "));
}

// A set of one convention: what becomes of each of its files, and the lines of the table about what is skipped.
struct ConventionDrop {
  const char *convention, *files, *in_slots;
  QStringList skipped;
};
const std::vector<ConventionDrop>& convention_drops() {
  static const std::vector<ConventionDrop> drops{
      {"Unreal",
       "T_Worn_D.png T_Worn_ORM.png T_Worn_N.png",
       "occlusion T_Worn_ORM.png:r, base_color T_Worn_D.png, metallic T_Worn_ORM.png:b, "
       "roughness T_Worn_ORM.png:g, normal T_Worn_N.png",
       {}},
      {"Unity",
       "Worn_BaseMap.png Worn_MaskMap.png Worn_Normal.png",
       "occlusion Worn_MaskMap.png:g, base_color Worn_BaseMap.png, metallic Worn_MaskMap.png:r, "
       "smoothness Worn_MaskMap.png:a, normal Worn_Normal.png",
       {}},
      {"Substance",
       "Crate_Iron_BaseColor.png Crate_Iron_Roughness.png Crate_Iron_Metallic.png Crate_Iron_Normal.png "
       "Crate_Iron_Height.png Crate_Iron_AmbientOcclusion.png",
       "occlusion Crate_Iron_AmbientOcclusion.png, base_color Crate_Iron_BaseColor.png, "
       "metallic Crate_Iron_Metallic.png, roughness Crate_Iron_Roughness.png, normal Crate_Iron_Normal.png",
       {"Crate_Iron_Height.png | height | skip | not taken: no channel holds it"}},
      {"specular and gloss",
       "Chair_Diffuse.png Chair_Specular.png Chair_Glossiness.png Chair_Emissive.png",
       "diffuse Chair_Diffuse.png, specular Chair_Specular.png, emission Chair_Emissive.png, "
       "smoothness Chair_Glossiness.png",
       {}},
      {"Poly Haven",
       "planks_diff_4k.png planks_rough_4k.png planks_nor_gl_4k.png planks_arm_4k.png planks_ao_4k.png",
       "occlusion planks_ao_4k.png, base_color planks_diff_4k.png, metallic planks_arm_4k.png:b, "
       "roughness planks_arm_4k.png:g, normal planks_nor_gl_4k.png",
       {"planks_rough_4k.png | roughness | skip | planks_arm_4k.png is the roughness",
        "planks_arm_4k.png | occlusion, R | skip | planks_ao_4k.png is the occlusion"}},
      {"ambientCG",
       "Bark01_4K-PNG_Color.png Bark01_4K-PNG_NormalGL.png Bark01_4K-PNG_NormalDX.png "
       "Bark01_4K-PNG_Roughness.png Bark01_4K-PNG_AmbientOcclusion.png Bark01_4K-PNG_Displacement.png",
       "diffuse Bark01_4K-PNG_Color.png, occlusion Bark01_4K-PNG_AmbientOcclusion.png, "
       "roughness Bark01_4K-PNG_Roughness.png, normal Bark01_4K-PNG_NormalGL.png",
       {"Bark01_4K-PNG_NormalDX.png | normal | skip | Bark01_4K-PNG_NormalGL.png is the normal",
        "Bark01_4K-PNG_Displacement.png | height | skip | not taken: no channel holds it"}},
      {"Quixel",
       "Rust_4K_Albedo.png Rust_4K_MRAO.png",
       "occlusion Rust_4K_MRAO.png:b, base_color Rust_4K_Albedo.png, metallic Rust_4K_MRAO.png:r, "
       "roughness Rust_4K_MRAO.png:g",
       {}},
      {"Poliigon",
       "Steel05_COL_2K_METALNESS.png Steel05_NRM_2K_METALNESS.png Steel05_ROUGHNESS_2K_METALNESS.png "
       "Steel05_METALNESS_2K_METALNESS.png Steel05_AO_2K_METALNESS.png",
       "occlusion Steel05_AO_2K_METALNESS.png, base_color Steel05_COL_2K_METALNESS.png, "
       "metallic Steel05_METALNESS_2K_METALNESS.png, roughness Steel05_ROUGHNESS_2K_METALNESS.png, "
       "normal Steel05_NRM_2K_METALNESS.png",
       {}}};
  return drops;
}

}  // namespace

class EditorDropTables : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QApplication::setQuitOnLastWindowClosed(false); }

  void pictures_go_to_the_channel_they_are_dropped_on_or_named_for() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    window->show();
    const QString wood = grey_picture(window, QStringLiteral("wood.png"));
    const QString gloss = grey_picture(window, QStringLiteral("wood_gloss.png"));
    QWidget* row = texture_row(window, Channel::specular);
    QVERIFY(row != nullptr);
    QVERIFY(drop(*row, {wood}));
    QVERIFY(window.settle());
    QCOMPARE(window->document().material()->texture(Channel::specular)->path, wood.toStdString());
    QCOMPARE(drop_and_take(window, {wood, gloss}).size(), 2);
    QCOMPARE(window->document().material()->texture(Channel::diffuse)->path, wood.toStdString());
    QCOMPARE(window->document().material()->texture(Channel::smoothness)->path, gloss.toStdString());
    QVERIFY(QTest::qWaitFor([&] { return window->texture_view().textures() != nullptr; }, 20000));
    QVERIFY2(window->texture_view().summary().startsWith(QLatin1String("8 x 8")),
             qPrintable(window->texture_view().summary()));
    window->document().undo_stack().undo();
    window->document().undo_stack().undo();
    QVERIFY(!window->document().material()->texture(Channel::specular));
  }

  void a_set_of_each_convention_fills_its_slots_and_the_table_tells_the_rest() {
    for (const ConventionDrop& each : convention_drops()) {
      TestWindow window(true);
      QVERIFY(window->use_library_material(QStringLiteral("pmma")));
      window->show();
      const QStringList said = drop_pictures(window, QString::fromLatin1(each.files).split(QLatin1Char(' ')));
      QCOMPARE(slots_of(*window->document().material()), QString::fromLatin1(each.in_slots));
      QStringList skipped;
      for (const QString& line : said)
        if (line.contains(QLatin1String("| skip"))) skipped << line;
      QCOMPARE(skipped, each.skipped);
      QVERIFY(window->problems().text().isEmpty());
      // One step of undo takes all of the drop back.
      window->document().undo_stack().undo();
      QCOMPARE(slots_of(*window->document().material()), QString());
      QCOMPARE(window->document().project().materials.size(), std::size_t{1});
    }
  }

  void words_of_names_count_with_the_pictures_beside_them() {
    const TestWindow window(true);
    const auto sorted = [&](const QStringList& names) {
      QStringList files;
      for (const QString& each : names) {
        QImage grey(4, 4, QImage::Format_RGB32);
        grey.fill(Qt::gray);
        files << window.file(each);
        QDir().mkpath(QFileInfo(files.back()).path());
        grey.save(files.back());
      }
      QStringList out;
      const DroppedPictures dropped = sort_pictures(files);
      for (const ProjectMaterial& each : materials_of(dropped)) out << slots_of(each);
      for (const DroppedRow& row : dropped.rows)
        if (!row.channel)
          out << QFileInfo(QString::fromStdString(row.source.path)).fileName() + QStringLiteral(": ") +
                     row.holds + QStringLiteral(": ") + row.remark;
      return (out << dropped.refused).join(QLatin1String("; "));
    };
    // T_x_A is the opacity beside T_x_D, and the colour where it is alone.
    QCOMPARE(sorted({"T_Leaf_D.png", "T_Leaf_A.png"}),
             QStringLiteral("diffuse T_Leaf_D.png, alpha T_Leaf_A.png"));
    QCOMPARE(sorted({"T_Leaf_A.png"}), QStringLiteral("diffuse T_Leaf_A.png"));
    // A word in front, and the name of a folder, are proof with companions alone.
    QCOMPARE(sorted({"metal_plate.png"}), QStringLiteral("diffuse metal_plate.png"));
    QCOMPARE(sorted({"metal/plate.png"}), QStringLiteral("diffuse plate.png"));
    QCOMPARE(sorted({"crate_n.png"}), QStringLiteral("normal crate_n.png"));
    QCOMPARE(sorted({"Wall_Cavity.png"}),
             QStringLiteral("Wall_Cavity.png: cavity: not taken: no channel holds it"));
    QCOMPARE(sorted({"crate.png", "crate_albedo.png"}),
             QStringLiteral("diffuse crate_albedo.png; crate.png: its name tells nothing: its name tells no "
                            "channel, and crate_albedo.png is the diffuse"));
    QCOMPARE(sorted({"lamp_emissive.png", "lamp-ao.png", "lamp-Specular.png", "lamp_gloss.png"}),
             QStringLiteral("specular lamp-Specular.png, emission lamp_emissive.png, occlusion lamp-ao.png, "
                            "smoothness lamp_gloss.png"));
  }

  void two_files_for_one_channel_and_a_broken_one_are_told_and_not_taken() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    window->show();
    const Project before = window->document().project();
    QVERIFY(drop(window->viewport(), {grey_picture(window, QStringLiteral("wall_albedo.png")),
                                      grey_picture(window, QStringLiteral("wall_basecolor.png"))}));
    DropTable* table = open_table(window);
    QVERIFY(table != nullptr);
    for (const QString& line : lines_of(*table))
      QVERIFY2(line.endsWith(QLatin1String("skip | 2 files for diffuse: choose one")), qPrintable(line));
    const auto* take = named<QDialogButtonBox>(*table, QString())->button(QDialogButtonBox::Ok);
    QVERIFY(!take->isEnabled());
    // One of them is chosen by keys, then the other one too, which cannot be taken.
    const auto channel_of = [&](const char* file) -> QComboBox* {
      for (auto* each : table->findChildren<QComboBox*>())
        if (each->accessibleName().startsWith(QLatin1String(file)) &&
            each->accessibleName().endsWith(QLatin1String("goes to")))
          return each;
      return nullptr;
    };
    QComboBox *first = channel_of("wall_albedo.png"), *second = channel_of("wall_basecolor.png");
    QVERIFY(first != nullptr && second != nullptr);
    QTest::keyClick(first, Qt::Key_Down);
    QVERIFY(take->isEnabled());
    QTest::keyClick(second, Qt::Key_Down);
    QVERIFY(!take->isEnabled());
    QVERIFY(named<QLabel>(*table, QStringLiteral("What is wrong"))
                ->text()
                .contains(QLatin1String("two pictures")));
    QTest::keyClick(table, Qt::Key_Escape);
    QVERIFY(QTest::qWaitFor([&] { return window->findChild<DropTable*>() == nullptr; }, 5000));
    QVERIFY(window->document().project() == before);
    // Cut short, damaged inside, and no picture at all: on the window and on the row of a channel.
    const QByteArray whole = bytes_of(grey_picture(window, QStringLiteral("whole.png")));
    QByteArray damaged = whole;
    damaged[damaged.size() - 16] = static_cast<char>(damaged[damaged.size() - 16] ^ 1);
    for (const QByteArray& bytes : {whole.left(whole.size() / 2), damaged, QByteArray("no picture")}) {
      const QString file = window.file(QStringLiteral("bad_gloss.png"));
      write(file, bytes);
      for (QWidget* target :
           {static_cast<QWidget*>(&window->viewport()), texture_row(window, Channel::gloss)}) {
        QVERIFY(drop(*target, {file}));
        const QString told = shown_message(window);
        QVERIFY2(told.contains(QLatin1String("bad_gloss.png")), qPrintable(told));
        QVERIFY(window.settle());
        QVERIFY(window->document().project() == before);
      }
    }
  }

  void each_name_of_a_drop_becomes_a_material_of_its_own() {
    TestWindow window(true);
    show_active(window);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    const Project before = window->document().project();
    QStringList names;
    for (int i = 0; i < 20; ++i)
      names << QStringLiteral("Stone%1_albedo.png").arg(i, 2, 10, QLatin1Char('0'));
    QCOMPARE(drop_pictures(window, names).size(), 20);
    const auto& materials = window->document().project().materials;
    QCOMPARE(materials.size(), std::size_t{21});
    for (int i = 0; i < 20; ++i) {
      const ProjectMaterial& each = materials[static_cast<std::size_t>(i) + 1];
      QCOMPARE(each.name, QStringLiteral("Stone%1").arg(i, 2, 10, QLatin1Char('0')).toStdString());
      QCOMPARE(slots_of(each), QStringLiteral("diffuse ") + names[i]);
    }
    QVERIFY(materials[0] == before.materials[0]);
    show_active(window);
    QTest::keyClick(window.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window->document().project() == before);
    // A project without a material gets one of a single set too.
    window->document().remove({0});
    drop_pictures(window, {QStringLiteral("leaf.png"), QStringLiteral("leaf_opacity.png")});
    QCOMPARE(materials.size(), std::size_t{1});
    QCOMPARE(materials[0].name, std::string("leaf"));
    QVERIFY(materials[0].alpha_mode == AlphaMode::blend);
  }

  void a_folder_gives_its_pictures_and_one_of_five_hundred_is_refused_as_a_whole() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    window->show();
    const Project before = window->document().project();
    const QString folder = window.file(QStringLiteral("set"));
    QVERIFY(QDir().mkpath(folder));
    QVERIFY(drop(window->viewport(), {folder}));
    QVERIFY(shown_message(window).contains(QLatin1String("set: a folder without pictures")));
    for (const char* each : {"set/T_Worn_D.png", "set/T_Worn_AO.png"})
      grey_picture(window, QString::fromLatin1(each));
    write(folder + QStringLiteral("/letter.txt"), "x");
    QCOMPARE(drop_and_take(window, {folder}).size(), 2);
    QCOMPARE(slots_of(*window->document().material()),
             QStringLiteral("diffuse T_Worn_D.png, occlusion T_Worn_AO.png"));
    window->document().undo_stack().undo();
    for (int i = 0; i < 500; ++i) grey_picture(window, QStringLiteral("set/Rock%1_albedo.png").arg(i));
    QVERIFY(drop(window->viewport(), {folder}));
    const QString told = shown_message(window, 20000);
    QVERIFY2(told.contains(QLatin1String("501 names")) && told.contains(QLatin1String("none was made")),
             qPrintable(told));
    QVERIFY(window->document().project() == before);
  }

  void what_is_bad_in_a_set_is_told_in_the_table() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    window->show();
    QImage large(16, 8, QImage::Format_RGB32);
    large.fill(Qt::gray);
    QVERIFY(large.save(window.file(QStringLiteral("Wall_Roughness.png"))));
    write(window.file(QStringLiteral("Wall_Metallic.png")), "no picture");
    const QStringList said =
        drop_and_take(window, {grey_picture(window, QStringLiteral("Wall_BaseColor.png")),
                               window.file(QStringLiteral("Wall_Roughness.png")),
                               window.file(QStringLiteral("Wall_Metallic.png")),
                               grey_picture(window, QStringLiteral("Wall_ID.png"))});
    QCOMPARE(said.size(), 4);
    QVERIFY(said.contains(QLatin1String(
        "Wall_Roughness.png | roughness | skip | 16 x 8 texels, but Wall_BaseColor.png has 8 x 8")));
    const QString all = said.join(QLatin1Char('\n'));
    QVERIFY2(all.contains(
                 QLatin1String("Wall_Metallic.png | metallic | skip | Wall_Metallic.png: cannot be read")),
             qPrintable(all));
    QVERIFY2(all.contains(QLatin1String("Wall_ID.png | id | skip | not taken: no channel holds it")),
             qPrintable(all));
    // A picture whose name tells nothing stays in the set whose name it begins with.
    const QStringList more =
        drop_pictures(window, {QStringLiteral("Wall_BaseColor.png"), QStringLiteral("Wall_Paint3.png")});
    QVERIFY2(more.contains(
                 QLatin1String("Wall_Paint3.png | its name tells nothing | skip | its name tells no channel, "
                               "and Wall_BaseColor.png is the diffuse")),
             qPrintable(more.join(QLatin1Char('\n'))));
    QCOMPARE(window->document().project().materials.size(), std::size_t{1});
    QCOMPARE(slots_of(*window->document().material()), QStringLiteral("diffuse Wall_BaseColor.png"));
  }

  void colour_space_convention_and_new_material_are_chosen_in_the_table() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    show_active(window);
    QVERIFY(drop(window->viewport(), {grey_picture(window, QStringLiteral("Wall_BaseColor.png")),
                                      grey_picture(window, QStringLiteral("Wall_ORM.png")),
                                      grey_picture(window, QStringLiteral("Wall_Normal.png"))}));
    DropTable* table = open_table(window);
    QVERIFY(table != nullptr);
    QTest::keyClick(named<QComboBox>(*table, QStringLiteral("Wall_BaseColor.png, base-color, colour space")),
                    Qt::Key_Down);
    QTest::keyClick(named<QComboBox>(*table, QStringLiteral("Wall_Normal.png, normal, colour space")),
                    Qt::Key_Down);
    QTest::keyClick(named<QComboBox>(*table, QStringLiteral("Wall_ORM.png, occlusion, R, goes to")),
                    Qt::Key_Home);
    QTest::keyClick(named<QCheckBox>(*table, QStringLiteral("As a new material")), Qt::Key_Space);
    QTest::keyClick(table, Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return window->document().project().materials.size() == 2; }, 5000));
    const ProjectMaterial& wall = *window->document().material();
    QCOMPARE(wall.name, std::string("Wall"));
    QCOMPARE(wall.texture(Channel::base_color)->space, std::string("linear"));
    QVERIFY(wall.green_down && !wall.texture(Channel::occlusion));
    QCOMPARE(slots_of(wall), QStringLiteral("base_color Wall_BaseColor.png, metallic Wall_ORM.png:b, "
                                            "roughness Wall_ORM.png:g, normal Wall_Normal.png"));
    // The numbers that the set replaces say so and are off.
    for (QWidget* field : {static_cast<QWidget*>(&window->inspector().diffuse()),
                           static_cast<QWidget*>(&window->inspector().specular()),
                           static_cast<QWidget*>(&window->inspector().gloss())})
      QVERIFY(!field->isEnabled());
    // The rows of the set are there, those that it does not need are not.
    QVERIFY(texture_row(window, Channel::base_color)->isVisibleTo(&window->inspector()));
    QVERIFY(!texture_row(window, Channel::smoothness)->isVisibleTo(&window->inspector()));
  }
};

ETAK_GUI_TEST(EditorDropTables, "editor_drop_tables")
#include "test_editor_drop_tables.moc"
