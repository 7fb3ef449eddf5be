// SPDX-License-Identifier: Apache-2.0
// What `etak validate --fix` writes, leaves and tells; how much of a defect it undoes is in test_repairs_recall.cpp.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "core/base/error.h"
#include "core/color/srgb.h"
#include "core/findings/output/formats.h"
#include "core/image/files/png.h"
#include "core/image/load.h"
#include "core/judge/rules.h"
#include "core/pages/repair_page.h"
#include "core/validate/files/project_check.h"
#include "core/validate/repairs/repair.h"
#include "core/validate/repairs/repair_files.h"
#include "core/validate/repairs/repair_material.h"
#include "tests/core/validate/checked.h"
#include "tests/core/validate/repaired.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace fs = std::filesystem;

TEST_CASE("texels beside a repair keep their codes, and files of the set come along") {
  Random random(3);
  const TempFolder folder;
  const Planted planted = doubled_patch(random);
  put_pictures(folder.file("in"), planted.wrong);
  const RepairedFolder repaired = repair_folder(folder.file("in"), folder.file("out"));
  CHECK(slurp(folder.file("out/crate_diff.png")) == slurp(folder.file("in/crate_diff.png")));
  const auto wrong = std::get<Image8>(planted.wrong.at("crate_spec.png")),
             copy = std::get<Image8>(loaded_codes(folder.file("out/crate_spec.png"))),
             right = std::get<Image8>(planted.right.at("crate_spec.png"));
  std::size_t changed = 0;
  for (std::size_t i = 0; i < wrong.values.size(); i += 4) {
    const bool in_patch = !std::equal(&wrong.values[i], &wrong.values[i] + 4, &right.values[i]);
    const bool is_changed = !std::equal(&wrong.values[i], &wrong.values[i] + 4, &copy.values[i]);
    changed += is_changed;
    if (is_changed) CHECK(in_patch);
    CHECK(copy.values[i + 3] == wrong.values[i + 3]);
  }
  REQUIRE(repaired.report.files.size() == 2);
  const auto file = std::ranges::find(repaired.report.files, "crate_spec.png", &RepairedFile::copy);
  REQUIRE(file != repaired.report.files.end());
  CHECK(file->texels == changed);
  REQUIRE(file->steps.size() == 1);
  CHECK(file->steps[0].texels == changed);
  CHECK(file->not_kept.empty());
}

TEST_CASE("what cannot be repaired is left with its reason, and nothing is written for it") {
  const TempFolder folder;
  Random random(5);
  Image8 b = varied_f0<std::uint8_t>(random, 0.045, 0.004);
  const Patch square;
  each_texel(b, [&](auto texel, int x, int y) {
    if (square.holds(x, y)) set_rgb(texel, {172, 130, 120});
  });
  put_pictures(folder.file("in"), {{"crate_diff.png", noisy_diffuse(random)}, {"crate_spec.png", b}});
  const RepairedFolder repaired = repair_folder(folder.file("in"), folder.file("out"));
  CHECK(repaired.report.files.empty());
  const auto left = std::ranges::find(repaired.report.left, "ETK101", &LeftFinding::rule);
  REQUIRE(left != repaired.report.left.end());
  CHECK(contains(left->why, "is not known"));
  const auto other = std::ranges::find(repaired.report.left, "ETK010", &LeftFinding::rule);
  REQUIRE(other != repaired.report.left.end());
  CHECK(contains(other->why, "no repair"));
  CHECK(fs::is_empty(folder.file("out")));
}

TEST_CASE("a repair that would bring another error is taken back") {
  // Metals that were stored right beside dielectrics encoded twice: undoing the whole picture makes them too
  // dark.
  const TempFolder folder;
  Random random(9);
  Image8 a = noisy_diffuse(random), b = varied_f0<std::uint8_t>(random, 0.045, 0.002);
  put_through(b, srgb_encode);
  each_texel(b, [&](auto texel, int x, int) {
    if (x < set_edge / 3) set_rgb(texel, {196, 199, 203});
  });
  each_texel(a, [&](auto texel, int x, int) {
    if (x < set_edge / 3) set_rgb(texel, {0, 0, 0});
  });
  put_pictures(folder.file("in"), {{"crate_diff.png", a}, {"crate_spec.png", b}});
  const RepairedFolder repaired = repair_folder(folder.file("in"), folder.file("out"));
  INFO(validation_text(repaired.before) << repairs_text(repaired.report, {}));
  REQUIRE(has_rule(repaired.before, "ETK402"));
  for (const RepairedFile& file : repaired.report.files)
    for (const RepairStep& step : file.steps) CHECK(step.rule != "ETK402");
  CHECK(has_rule(repaired.after, "ETK402") == has_rule(repaired.after, "ETK101"));
}

TEST_CASE("what is something else than its name says is not repaired into what passes") {
  Random random(4);
  Image8 base(set_edge, set_edge, 3), roughness(set_edge, set_edge, 1);
  each_texel(base, [&](auto texel, int, int) { set_rgb(texel, {210 + random.below(20), 205, 200}); });
  each_texel(roughness,
             [&](auto texel, int, int) { texel[0] = static_cast<std::uint8_t>(100 + random.below(60)); });
  const auto left_of = [&](const PictureCodes& metallic, const Image8& of) {
    const TempFolder folder;
    put_pictures(
        folder.file("in"),
        {{"crate_basecolor.png", of}, {"crate_roughness.png", roughness}, {"crate_metallic.png", metallic}});
    const RepairedFolder repaired = repair_folder(folder.file("in"), folder.file("out"));
    REQUIRE(has_rule(repaired.before, "ETK113"));
    const auto left = std::ranges::find(repaired.report.left, "ETK113", &LeftFinding::rule);
    if (left == repaired.report.left.end()) return std::string();
    CHECK(repaired.report.files.empty());
    return left->why;
  };
  // Colours in the place of metallic, some of which lie between metal and none.
  Image8 colours(set_edge, set_edge, 3);
  each_texel(colours, [&](auto texel, int x, int) { set_rgb(texel, {90 + x / 4, 120, 180}); });
  CHECK(contains(left_of(colours, base), "ETK004 (channel-layout) says that crate_metallic.png"));
  // Half metal all over: only a base colour that no metal has tells what it is.
  const Image8 half(set_edge, set_edge, 1, 140);
  CHECK(contains(left_of(half, base), "which are metal is not known"));
  Image8 dark = base;
  for (auto& code : dark.values) code = static_cast<std::uint8_t>(code / 3);
  CHECK(left_of(half, dark).empty());
}

TEST_CASE("copies lie as their originals do, and never in a folder that is checked") {
  const TempFolder folder;
  Random random(2);
  for (const char* name : {"oak", "props/crate"}) {
    const Planted planted = curve_of_normals<std::uint8_t>(random, srgb_encode);
    put_pictures(folder.file("in/" + std::string(name)), planted.wrong);
  }
  const RepairedFolder repaired = repair_folder(folder.file("in"), folder.file("out"));
  CHECK(fs::exists(folder.file("out/oak/crate_normal.png")));
  CHECK(fs::exists(folder.file("out/props/crate/crate_normal.png")));
  const std::vector<std::string> inputs = checked_paths(repaired.before);
  for (const char* place : {"in", "in/props", "in/oak/", "."})
    CHECK(contains(error_of([&] { refuse_inputs_below(folder.file(place), inputs); }), "which is checked"));
  CHECK(error_of([&] { refuse_inputs_below(folder.file("out"), inputs); }).empty());
  CHECK(error_of([&] { refuse_inputs_below(folder.file("in/copies"), inputs); }).empty());
}

TEST_CASE("findings that are allowed, and floats, are left as they are") {
  const TempFolder folder;
  Random random(4);
  const Planted planted = curve_of_normals<std::uint8_t>(random, srgb_encode);
  put_pictures(folder.file("in"), planted.wrong);
  ValidationRequest request;
  request.inputs.paths = {folder.file("in")};
  request.config.root = folder.file("in");
  request.config.settings.allow.push_back({"ETK704", "*_normal.png", "", "", "stylised", ""});
  const ValidationReport report = validate(std::move(request));
  OutputTree copies(folder.file("out"), true);
  const RepairReport repaired = repair_files(report, {}, copies);
  CHECK(repaired.files.empty());
  REQUIRE(!repaired.left.empty());
  CHECK(std::ranges::any_of(repaired.left,
                            [](const LeftFinding& left) { return left.why == "allowed: stylised"; }));
}

TEST_CASE("a picture that is no PNG becomes one, and the report says so") {
  const TempFolder folder;
  Random random(6);
  const Planted planted = curve_of_normals<std::uint8_t>(random, srgb_encode);
  fs::create_directories(folder.file("in"));
  // Targa: no identification, no palette, uncompressed BGR from the top.
  const auto& map = std::get<Image8>(planted.wrong.at("crate_normal.png"));
  std::string tga("\0\0\2\0\0\0\0\0\0\0\0\0\x80\0\x80\0\x18\x20", 18);
  for (std::size_t i = 0; i < map.values.size(); i += 3)
    for (const std::size_t c : {2, 1, 0}) tga += static_cast<char>(map.values[i + c]);
  spit(folder.file("in/crate_normal.tga"), tga);
  const RepairedFolder repaired = repair_folder(folder.file("in"), folder.file("out"));
  INFO(repairs_text(repaired.report, {}));
  REQUIRE(repaired.report.files.size() == 1);
  CHECK(repaired.report.files[0].copy == "crate_normal.png");
  REQUIRE(repaired.report.files[0].not_kept.size() == 1);
  CHECK(contains(repaired.report.files[0].not_kept[0], "targa"));
  CHECK_FALSE(has_rule(repaired.after, "ETK704"));
}

TEST_CASE("every repair belongs to a rule, and the page shows before and after") {
  for (const Repair* repair : repairs()) {
    INFO(repair->rule);
    CHECK(find_rule(repair->rule) != nullptr);
    CHECK(find_repair(repair->rule) == repair);
  }
  RepairReport report;
  report.files.push_back(
      {"a<b>.png", "a<b>.png", {{"ETK402", "x", "undid <it>", 3, {"ETK101"}}}, 3, 16, {"the chunk tIME"}});
  report.left.push_back({"ETK101", "f0-forbidden-zone", "c.png", "not <known>"});
  RepairPage page;
  page.add(report.files[0], Image8(4, 4, 3, 10), Image8(4, 4, 3, 200));
  const std::string html = page.html(report, "1");
  for (const char* part : {"a&lt;b&gt;.png", "and ETK101", "undid &lt;it&gt;", "the chunk tIME",
                           "not &lt;known&gt;", "before", "after", "13 of 16 texels are as they were"})
    CHECK(contains(html, part));
  CHECK_FALSE(contains(html, "<b>.png"));
}

TEST_CASE("a material of a project is repaired as its pictures are, by numbers and by copies") {
  const TempFolder folder;
  const MaterialLibrary library = MaterialLibrary::builtin();
  ProjectMaterial metal;
  metal.name = "Painted metal";
  metal.specular = {0.9, 0.88, 0.85};
  metal.diffuse = {0.3, 0.3, 0.3};
  metal.alpha_mode = AlphaMode::opaque;
  const auto repaired = [&](const ProjectMaterial& material, const std::string& work) {
    std::filesystem::create_directory(folder.file(work));
    return repair_material(material, library, {}, {}, folder.file(work), folder.path());
  };
  const RepairedMaterial numbers = repaired(metal, "a");
  CHECK(numbers.material.diffuse == LinearRgb{0, 0, 0});
  CHECK(numbers.material.specular == metal.specular);  // not read back from codes
  REQUIRE(numbers.done.size() == 1);
  CHECK(numbers.done[0] == "ETK108: made diffuse black under metal");

  spit(folder.file("grey.png"), png_bytes(Image8(32, 32, 3, 150), {}));
  set_texture(metal, Channel::diffuse, ImageSource{folder.file("grey.png"), {}, {}});
  const RepairedMaterial pictures = repaired(metal, "b");
  const auto& texture = pictures.material.texture(Channel::diffuse);
  REQUIRE(texture);
  CHECK(texture->path == folder.file("painted_metal_diffuse_fixed.png"));
  CHECK(codes_of(load_picture(texture->path, {}), false) == Image8(32, 32, 3, 0));
  CHECK(repaired(metal, "c").material.texture(Channel::diffuse)->path ==
        folder.file("painted_metal_diffuse_fixed_2.png"));

  // What is right stays as it is, and what is no mistake of a known cause is told.
  ProjectMaterial plastic;
  plastic.name = "plastic";
  plastic.diffuse = {0.4, 0.1, 0.1};
  const RepairedMaterial right = repaired(plastic, "d");
  CHECK(right.material == plastic);
  CHECK((right.done.empty() && right.left.empty()));
  plastic.specular = {0.3, 0.33, 0.36};
  const RepairedMaterial left = repaired(plastic, "e");
  CHECK(left.material == plastic);
  REQUIRE(left.left.size() == 1);
  CHECK(left.left[0].starts_with("ETK101: "));
}

namespace {

// Normals of a relief whose slopes are twisted; green points up.
template <class Value>
Pixels<Value> twisted_normals() {
  Pixels<Value> out(set_edge, set_edge, 3);
  for (int y = 0; y < set_edge; ++y)
    for (int x = 0; x < set_edge; ++x) {
      const double u = 0.7 * std::cos(x / 9.0) * std::cos(y / 11.0),
                   v = 0.6 * std::sin(x / 9.0) * std::sin(y / 11.0);
      const double length = std::sqrt(u * u + v * v + 1);
      const std::array<double, 3> n{-u / length, -v / length, 1 / length};
      for (std::size_t c = 0; c < 3; ++c) out.at(x, y)[c] = coded<Value>((n[c] + 1) / 2);
    }
  return out;
}

template <class Value>
void turn_green_around(Pixels<Value>& map) {
  const int full = sizeof(Value) == 1 ? 255 : 65535;
  for (std::size_t i = 1; i < map.values.size(); i += 3)
    map.values[i] = static_cast<Value>(full - map.values[i]);
}

template <class Act>
void each_of(Image16& image, Act act) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) act(image.at(x, y), x, y);
}

RepairedMaterial repaired_in(const TempFolder& folder, const ProjectMaterial& material) {
  static int run = 0;
  const std::string work = folder.file("work" + std::to_string(++run));
  fs::create_directory(work);
  return repair_material(material, MaterialLibrary::builtin(), {}, {}, work, folder.path());
}

bool finds(const ProjectMaterial& material, std::string_view rule) {
  const MaterialLibrary library = MaterialLibrary::builtin();
  const PictureDoor door;
  const Settings settings;
  const CheckedFile checked = check_material(material, {library, door, settings, 0, 1, nullptr});
  return std::ranges::find(checked.findings, rule, &Finding::rule) != checked.findings.end();
}

// A map against its name, repaired in files and in a material: it comes back to the code.
template <class Value>
void check_turned_green() {
  const auto right = twisted_normals<Value>();
  auto wrong = right;
  turn_green_around(wrong);
  const TempFolder folder;
  put_pictures(folder.file("in"), {{"crate_normal_gl.png", wrong}});
  const RepairedFolder repaired = repair_folder(folder.file("in"), folder.file("out"));
  INFO(validation_text(repaired.before) << repairs_text(repaired.report, {}));
  REQUIRE(has_rule(repaired.before, "ETK703"));
  CHECK_FALSE(has_rule(repaired.after, "ETK703"));
  CHECK(std::get<Pixels<Value>>(loaded_codes(folder.file("out/crate_normal_gl.png"))) == right);

  ProjectMaterial m;
  m.name = "crate";
  m.texture(Channel::normal) = ImageSource{folder.file("in/crate_normal_gl.png"), "", ""};
  REQUIRE(finds(m, "ETK703"));
  const RepairedMaterial fixed = repaired_in(folder, m);
  REQUIRE(fixed.done.size() == 1);
  CHECK(fixed.done[0] == "ETK703: turned green around");
  CHECK(fixed.material.texture(Channel::normal)->path == folder.file("crate_normal_fixed.png"));
  CHECK(std::get<Pixels<Value>>(loaded_codes(folder.file("crate_normal_fixed.png"))) == right);
  CHECK_FALSE(finds(fixed.material, "ETK703"));
  m.green_down = true;
  CHECK_FALSE(finds(m, "ETK703"));
}

}  // namespace

TEST_CASE("a normal map against its convention gets its green turned around, in 8 and in 16 bits") {
  check_turned_green<std::uint8_t>();
  check_turned_green<std::uint16_t>();
}

TEST_CASE("normals of a material that are not unit become so, and the others keep their codes") {
  const TempFolder folder;
  const auto right = twisted_normals<std::uint16_t>();
  auto wrong = right;
  for (int y = 20; y < 90; ++y)
    for (int x = 10; x < 80; ++x)
      for (std::uint16_t& code : wrong.at(x, y))
        code = coded<std::uint16_t>(0.5 + 0.8 * (code / 65535.0 - 0.5));
  put_pictures(folder.file("in"), {{"n.png", wrong}});
  ProjectMaterial m;
  m.name = "crate";
  m.texture(Channel::normal) = ImageSource{folder.file("in/n.png"), "", ""};
  REQUIRE(finds(m, "ETK701"));
  const RepairedMaterial fixed = repaired_in(folder, m);
  CHECK_FALSE(finds(fixed.material, "ETK701"));
  const auto copy = std::get<Image16>(loaded_codes(fixed.material.texture(Channel::normal)->path));
  for (int y = 0; y < set_edge; ++y)
    for (int x = 0; x < set_edge; ++x) {
      const bool inside = x >= 10 && x < 80 && y >= 20 && y < 90;
      for (std::size_t c = 0; c < 3; ++c)
        REQUIRE(std::abs(copy.at(x, y)[c] - right.at(x, y)[c]) <= (inside ? 257 : 0));
    }
}

TEST_CASE("metalness of a material is separated in its own file, whose other channels and bits stay") {
  const TempFolder folder;
  Random random(8);
  Image16 orm(set_edge, set_edge, 3), base(set_edge, set_edge, 3);
  each_of(base, [&](auto texel, int, int) {
    for (auto& code : texel) code = static_cast<std::uint16_t>(56000 + random.below(3000));
  });
  each_of(orm, [&](auto texel, int x, int y) {
    texel[0] = static_cast<std::uint16_t>(60000 + random.below(5000));
    texel[1] = static_cast<std::uint16_t>(30000 + random.below(9000));
    texel[2] = Patch().holds(x, y) ? 39000 : 0;
  });
  put_pictures(folder.file("in"), {{"base.png", base}, {"orm.png", orm}});
  ProjectMaterial m;
  m.name = "crate";
  m.alpha_mode = AlphaMode::opaque;
  set_texture(m, Channel::base_color, ImageSource{folder.file("in/base.png"), "", ""});
  set_texture(m, Channel::metallic, ImageSource{folder.file("in/orm.png"), "b", ""});
  set_texture(m, Channel::roughness, ImageSource{folder.file("in/orm.png"), "g", ""});
  set_texture(m, Channel::occlusion, ImageSource{folder.file("in/orm.png"), "r", ""});
  const RepairedMaterial fixed = repaired_in(folder, m);
  REQUIRE(!fixed.done.empty());
  CHECK(fixed.done[0] == "ETK113: separated metal from what is none");
  for (const Channel channel : {Channel::metallic, Channel::roughness, Channel::occlusion})
    CHECK(fixed.material.texture(channel)->path == folder.file("crate_metallic_fixed.png"));
  CHECK(fixed.material.texture(Channel::base_color) == m.texture(Channel::base_color));
  const auto copy = std::get<Image16>(loaded_codes(folder.file("crate_metallic_fixed.png")));
  each_of(orm, [&](auto texel, int x, int y) {
    CHECK((copy.at(x, y)[0] == texel[0] && copy.at(x, y)[1] == texel[1]));
    CHECK(copy.at(x, y)[2] == (Patch().holds(x, y) ? 65535 : 0));
  });
}

TEST_CASE("metal that is nowhere a full metal becomes one") {
  Random random(8);
  Image8 base(set_edge, set_edge, 3), metal(set_edge, set_edge, 1), roughness(set_edge, set_edge, 1);
  each_texel(base, [&](auto texel, int, int) { set_rgb(texel, {215 + random.below(20), 212, 208}); });
  each_texel(roughness,
             [&](auto texel, int, int) { texel[0] = static_cast<std::uint8_t>(100 + random.below(60)); });
  each_texel(metal, [&](auto texel, int x, int) {
    texel[0] = static_cast<std::uint8_t>(x < 60 ? 240 + random.below(4) : random.below(3));
  });
  const TempFolder folder;
  put_pictures(
      folder.file("in"),
      {{"crate_basecolor.png", base}, {"crate_roughness.png", roughness}, {"crate_metallic.png", metal}});
  const RepairedFolder repaired = repair_folder(folder.file("in"), folder.file("out"));
  INFO(validation_text(repaired.before) << repairs_text(repaired.report, {}));
  REQUIRE(has_rule(repaired.before, "ETK113"));
  CHECK_FALSE(has_rule(repaired.after, "ETK113"));
  const auto copy = std::get<Image8>(loaded_codes(folder.file("out/crate_metallic.png")));
  each_texel(metal, [&](auto texel, int x, int y) {
    CHECK(int{copy.at(x, y)[0]} == (x < 60 ? 255 : int{texel[0]}));
  });
}

TEST_CASE("a diffuse colour of 16 bits is repaired in 16 bits") {
  const TempFolder folder;
  Image16 wrong(64, 64, 3);
  each_of(wrong, [&](auto texel, int x, int y) {
    for (auto& code : texel) code = static_cast<std::uint16_t>(20000 + 37 * x + 11 * y);
  });
  put_pictures(folder.file("in"), {{"diffuse.png", wrong}});
  ProjectMaterial m;
  m.name = "painted";
  m.specular = {0.9, 0.88, 0.85};
  m.alpha_mode = AlphaMode::opaque;
  set_texture(m, Channel::diffuse, ImageSource{folder.file("in/diffuse.png"), "", ""});
  const RepairedMaterial fixed = repaired_in(folder, m);
  REQUIRE(fixed.done.size() == 1);
  CHECK(std::get<Image16>(loaded_codes(folder.file("painted_diffuse_fixed.png"))) == Image16(64, 64, 3, 0));
}
