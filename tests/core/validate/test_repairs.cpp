// SPDX-License-Identifier: Apache-2.0
// RepairedFolder copies: defects are drawn into right sets, the sets are repaired, and the copies are held
// against the sets as they were before the defect.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <variant>

#include "core/base/error.h"
#include "core/color/srgb.h"
#include "core/image/files/png.h"
#include "core/image/image_io.h"
#include "core/image/load.h"
#include "core/pages/repair_page.h"
#include "core/validate/nearest.h"
#include "core/validate/output/formats.h"
#include "core/validate/repairs/repair.h"
#include "core/validate/repairs/repair_files.h"
#include "core/validate/rules.h"
#include "tests/core/validate/checked.h"
#include "tests/core/validate/corpus.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace fs = std::filesystem;

namespace {

constexpr int set_edge = 128;

using Codes = std::variant<Image8, Image16>;
using NamedCodes = std::map<std::string, Codes>;  // by file name

// A linear or plain value as a code of the picture's depth.
template <class Value>
Value coded(double value) {
  const double full = sizeof(Value) == 1 ? 255 : 65535;
  return static_cast<Value>(std::lround(full * std::clamp(value, 0.0, 1.0)));
}

// A square with another F0 inside of a picture.
struct Patch {
  int x = 40, y = 50, size = 30;
  bool holds(int column, int row) const {
    return column >= x && column < x + size && row >= y && row < y + size;
  }
};

// F0 of a dielectric with a gentle variation, so that plateaus hold more than one code; gloss is noise.
template <class Value>
Pixels<Value> varied_f0(Random& random, double f0, double spread) {
  Pixels<Value> out(set_edge, set_edge, 4);
  for (int y = 0; y < set_edge; ++y)
    for (int x = 0; x < set_edge; ++x) {
      const double wave = spread * std::sin(x / 23.0) * std::cos(y / 31.0);
      for (std::size_t c = 0; c < 3; ++c) out.at(x, y)[c] = coded<Value>(srgb_encode(f0 + wave));
      out.at(x, y)[3] = coded<Value>(random.between(0.3, 0.7));
    }
  return out;
}

Image8 noisy_diffuse(Random& random) {
  Image8 out(set_edge, set_edge, 4, 255);
  for (int y = 0; y < set_edge; ++y)
    for (int x = 0; x < set_edge; ++x) {
      const int value = 90 + random.below(60);
      set_rgb(out.at(x, y), {value, value - 20, value - 40});
    }
  return out;
}

// Unit normals of a wavy surface, whose slopes reach 0.8 times `steep`.
template <class Value>
Pixels<Value> wavy_normals(Random& random, double steep = 1) {
  const double p = random.between(0, 6), q = random.between(0, 6);
  Pixels<Value> out(set_edge, set_edge, 3);
  for (int y = 0; y < set_edge; ++y)
    for (int x = 0; x < set_edge; ++x) {
      const double u = steep * (0.6 * std::sin(x / 9.0 + p) + 0.2 * std::sin(y / 5.0)),
                   v = steep * 0.6 * std::cos(y / 11.0 + q);
      const double length = std::sqrt(u * u + v * v + 1);
      const std::array<double, 3> n{u / length, v / length, 1 / length};
      for (std::size_t c = 0; c < 3; ++c) out.at(x, y)[c] = coded<Value>((n[c] + 1) / 2);
    }
  return out;
}

template <class Value, class Curve>
void put_through(Pixels<Value>& image, const Curve& curve) {
  const auto channels = static_cast<std::size_t>(image.channels);
  const double full = sizeof(Value) == 1 ? 255 : 65535;
  for (std::size_t i = 0; i < image.values.size(); ++i)
    if (i % channels < 3) image.values[i] = coded<Value>(curve(image.values[i] / full));
}

struct Planted {
  NamedCodes right, wrong;
  std::string repaired;       // the file that the defect is in
  std::string material = {};  // that the set is said to be of
  std::string rule;
};

template <class Value>
Planted curve_of_specular(Random& random, double (*curve)(double), const char* rule, double least = 0.03,
                          double most = 0.06) {
  auto b = varied_f0<Value>(random, random.between(least, most), 0.1 * least);
  Planted out;
  out.rule = rule;
  out.repaired = "crate_spec.png";
  out.right = out.wrong = {{"crate_diff.png", noisy_diffuse(random)}, {"crate_spec.png", b}};
  put_through(b, curve);
  out.wrong["crate_spec.png"] = b;
  return out;
}

template <class Value>
Planted curve_of_normals(Random& random, double (*curve)(double), double steep = 1) {
  auto map = wavy_normals<Value>(random, steep);
  Planted out;
  out.rule = "ETK704";
  out.repaired = "crate_normal.png";
  out.right = {{"crate_normal.png", map}};
  put_through(map, curve);
  out.wrong = {{"crate_normal.png", map}};
  return out;
}

Planted short_normals(Random& random) {
  auto map = wavy_normals<std::uint8_t>(random);
  Planted out;
  out.rule = "ETK701";
  out.repaired = "crate_normal.png";
  out.right = {{"crate_normal.png", map}};
  for (std::size_t i = 0; i < map.values.size(); i += 3)
    if (random.below(20) == 0)
      for (std::size_t c = 0; c < 3; ++c)
        map.values[i + c] = to_byte(127.5 + (map.values[i + c] - 127.5) * (1 - 4 / 127.5));
  out.wrong = {{"crate_normal.png", map}};
  return out;
}

// A patch of a right set that went through the curve once more.
Planted doubled_patch(Random& random) {
  auto b = varied_f0<std::uint8_t>(random, 0.045, 0.004);
  Planted out;
  out.rule = "ETK101";
  out.repaired = "crate_spec.png";
  out.right = out.wrong = {{"crate_diff.png", noisy_diffuse(random)}, {"crate_spec.png", b}};
  const Patch square{10 + random.below(60), 10 + random.below(60), 24 + random.below(20)};
  each_texel(b, [&](auto texel, int x, int y) {
    for (std::size_t c = 0; c < 3 && square.holds(x, y); ++c) texel[c] = srgb_u8(texel[c] / 255.0);
  });
  out.wrong["crate_spec.png"] = b;
  return out;
}

// Gold with a patch that is half of it, in a set that is said to be gold.
Planted half_gold(Random& random) {
  const KnownF0* gold = nullptr;
  for (const KnownF0* entry : KnownMaterials::builtin().f0_of("gold"))
    if (entry->preferred) gold = entry;
  REQUIRE(gold != nullptr);
  Image8 a(set_edge, set_edge, 4, 0), b(set_edge, set_edge, 4);
  each_texel(a, [](auto texel, int, int) { texel[3] = 255; });
  Planted out;
  out.rule = "ETK101";
  out.repaired = "crate_spec.png";
  out.material = "gold";
  const Patch square{10 + random.below(60), 10 + random.below(60), 24 + random.below(20)};
  each_texel(b, [&](auto texel, int, int) {
    for (std::size_t c = 0; c < 3; ++c) texel[c] = srgb_u8(std::clamp(gold->linear[c], 0.0, 1.0));
    texel[3] = static_cast<std::uint8_t>(100 + random.below(60));
  });
  out.right = {{"crate_diff.png", a}, {"crate_spec.png", b}};
  each_texel(b, [&](auto texel, int x, int y) {
    for (std::size_t c = 0; c < 3 && square.holds(x, y); ++c)
      texel[c] = srgb_u8(0.45 * std::clamp(gold->linear[c], 0.0, 1.0));
  });
  out.wrong = {{"crate_diff.png", a}, {"crate_spec.png", b}};
  return out;
}

// Patches of metallic between 0 and 1 on a sharp mask.
Planted half_metal(Random& random) {
  Image8 base(set_edge, set_edge, 3), roughness(set_edge, set_edge, 1), metallic(set_edge, set_edge, 1, 0);
  each_texel(base, [&](auto texel, int x, int) {
    const int value = x < set_edge / 2 ? 200 + random.below(20) : 60 + random.below(40);
    set_rgb(texel, {value, value, value});
  });
  each_texel(roughness,
             [&](auto texel, int, int) { texel[0] = static_cast<std::uint8_t>(100 + random.below(60)); });
  each_texel(metallic, [&](auto texel, int x, int) { texel[0] = x < set_edge / 2 ? 255 : 0; });
  Planted out;
  out.rule = "ETK113";
  out.repaired = "crate_metallic.png";
  out.right = out.wrong = {
      {"crate_basecolor.png", base}, {"crate_roughness.png", roughness}, {"crate_metallic.png", metallic}};
  const Patch in_metal{10, 20 + random.below(40), 24}, beside{set_edge / 2 + 20, 20 + random.below(40), 24};
  const auto high = static_cast<std::uint8_t>(150 + random.below(60)),
             low = static_cast<std::uint8_t>(40 + random.below(130));
  each_texel(metallic, [&](auto texel, int x, int y) {
    if (in_metal.holds(x, y)) texel[0] = high;
    if (beside.holds(x, y)) texel[0] = low;
  });
  out.wrong["crate_metallic.png"] = metallic;
  return out;
}

// A square of metal whose diffuse should be black.
Planted diffuse_under_metal(Random& random) {
  Image8 a = noisy_diffuse(random), b(set_edge, set_edge, 4, 56);
  const Patch square{10 + random.below(60), 10 + random.below(60), 24 + random.below(20)};
  each_texel(b, [&](auto texel, int x, int y) {
    if (square.holds(x, y)) set_rgb(texel, {250, 229, 158});
    texel[3] = static_cast<std::uint8_t>(100 + random.below(60));
  });
  Planted out;
  out.rule = "ETK108";
  out.repaired = "crate_diff.png";
  out.wrong = {{"crate_diff.png", a}, {"crate_spec.png", b}};
  each_texel(a, [&](auto texel, int x, int y) {
    if (square.holds(x, y)) set_rgb(texel, {0, 0, 0});
  });
  out.right = {{"crate_diff.png", a}, {"crate_spec.png", b}};
  return out;
}

// A cut-out of one colour whose hidden texels have another.
Planted hidden_black(Random& random) {
  const int shade = 120 + random.below(80), radius = 20 + random.below(30);
  Image8 a(set_edge, set_edge, 4), b = varied_f0<std::uint8_t>(random, 0.045, 0.002);
  each_texel(a, [&](auto texel, int x, int y) {
    set_rgb(texel, {shade, shade - 15, shade - 40});
    texel[3] = std::hypot(x - set_edge / 2, y - set_edge / 2) < radius ? 255 : 0;
  });
  Planted out;
  out.rule = "ETK502";
  out.repaired = "crate_diff.png";
  out.right = {{"crate_diff.png", a}, {"crate_spec.png", b}};
  each_texel(a, [](auto texel, int, int) {
    if (texel[3] == 0) set_rgb(texel, {0, 0, 0});
  });
  out.wrong = {{"crate_diff.png", a}, {"crate_spec.png", b}};
  return out;
}

// A soft cut-out multiplied by its alpha: no repair, because little is left of colour under little alpha.
Planted premultiplied(Random& random) {
  Image8 a = noisy_diffuse(random);
  each_texel(a, [](auto texel, int x, int y) {
    texel[3] = to_byte(255 * std::abs(std::sin(x / 20.0) * std::sin(y / 20.0)));
  });
  Planted out;
  out.rule = "ETK501";
  out.repaired = "crate_diff.png";
  out.right =
      out.wrong = {{"crate_diff.png", a}, {"crate_spec.png", varied_f0<std::uint8_t>(random, 0.045, 0.004)}};
  each_texel(a, [](auto texel, int, int) {
    for (std::size_t c = 0; c < 3; ++c) texel[c] = to_byte(texel[c] * texel[3] / 255.0);
  });
  out.wrong["crate_diff.png"] = a;
  return out;
}

std::string file_of_codes(const Codes& codes) {
  return std::visit([](const auto& image) { return png_bytes(PngRows(image), {}); }, codes);
}

struct RepairedFolder {
  RepairReport report;
  ValidationReport before, after;  // of the originals and of the copies
};

RepairedFolder repair_folder(const std::string& from, const std::string& to,
                             const std::string& material = {}) {
  ValidationRequest request;
  request.paths = {from};
  request.manifest.material = material;
  request.config.root = from;
  request.door = picture_door();
  RepairedFolder out;
  ValidationRequest again = request;
  out.before = validate(std::move(request));
  OutputTree copies(to, true);
  RepairRequest how;
  how.door = picture_door();
  how.folder = to;
  out.report = repair_files(out.before, how, copies);
  copies.commit();
  again.paths = {to};
  again.config.root = to;
  out.after = validate(std::move(again));
  return out;
}

void put_pictures(const std::string& folder, const NamedCodes& pictures) {
  fs::create_directories(folder);
  for (const auto& [file, codes] : pictures) spit(folder + "/" + file, file_of_codes(codes));
}

bool has_rule(const ValidationReport& report, const std::string& rule) {
  return std::ranges::any_of(report.files,
                             [&](const CheckedFile& file) { return find(file, rule) != nullptr; });
}

// The 99th percentile, over the texels, of the largest difference of a channel in 8-bit codes.
double percentile_99(const Codes& one, const Codes& other) {
  REQUIRE(one.index() == other.index());
  std::vector<double> differences;
  std::visit(
      [&](const auto& a) {
        const auto& b = std::get<std::decay_t<decltype(a)>>(other);
        REQUIRE(a.values.size() == b.values.size());
        const auto channels = static_cast<std::size_t>(a.channels);
        const double step = sizeof(a.values[0]) == 1 ? 1 : 257;
        for (std::size_t i = 0; i < a.values.size(); i += channels) {
          double most = 0;
          for (std::size_t c = 0; c < channels; ++c)
            most = std::max(most, std::abs(double{1} * a.values[i + c] - b.values[i + c]) / step);
          differences.push_back(most);
        }
      },
      one);
  const auto at = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() * 99 / 100);
  std::nth_element(differences.begin(), at, differences.end());
  return *at;
}

Codes loaded_codes(const std::string& path) {
  Picture picture = load_picture(path, picture_door());
  if (auto* wide = std::get_if<Image16>(&picture.pixels)) return std::move(*wide);
  return std::get<Image8>(picture.pixels);
}

struct BackShare {
  int planted = 0, back = 0;
};

// Plants a defect, repairs it, and counts whether the file is back within 2 codes.
void plant_and_repair(BackShare& share, const Planted& planted) {
  const TempFolder folder;
  const std::string from = folder.file("in"), to = folder.file("out");
  put_pictures(from, planted.wrong);
  ++share.planted;
  const RepairedFolder repaired = repair_folder(from, to, planted.material);
  INFO(planted.rule << "\n" << validation_text(repaired.before) << repairs_text(repaired.report, {}));
  REQUIRE(has_rule(repaired.before, planted.rule));
  for (const auto& [file, codes] : planted.wrong) CHECK(slurp(from + "/" + file) == file_of_codes(codes));
  const auto file = std::ranges::find(repaired.report.files, planted.repaired, &RepairedFile::copy);
  if (file == repaired.report.files.end() || file->steps.empty()) return;
  CHECK_FALSE(has_rule(repaired.after, planted.rule));
  share.back +=
      percentile_99(planted.right.at(planted.repaired), loaded_codes(to + "/" + planted.repaired)) <= 2;
}

}  // namespace

TEST_CASE("nine of ten planted defects whose inverse lies within 2 codes are back within 2 codes") {
  constexpr int seeds = 8;
  std::map<std::string, BackShare> within, beyond;
  for (int seed = 0; seed < seeds; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    plant_and_repair(within["F0 encoded twice"],
                     curve_of_specular<std::uint8_t>(random, srgb_encode, "ETK402"));
    plant_and_repair(within["F0 encoded twice, 16 bits"],
                     curve_of_specular<std::uint16_t>(random, srgb_encode, "ETK402"));
    plant_and_repair(within["F0 stored linear, 16 bits"],
                     curve_of_specular<std::uint16_t>(random, srgb_decode, "ETK401"));
    plant_and_repair(within["normals encoded"], curve_of_normals<std::uint8_t>(random, srgb_encode));
    plant_and_repair(within["normals encoded, 16 bits"],
                     curve_of_normals<std::uint16_t>(random, srgb_encode));
    plant_and_repair(within["normals decoded, 16 bits"],
                     curve_of_normals<std::uint16_t>(random, srgb_decode));
    plant_and_repair(within["short normals"], short_normals(random));
    plant_and_repair(within["a patch encoded twice"], doubled_patch(random));
    plant_and_repair(within["a patch of a named material"], half_gold(random));
    plant_and_repair(within["half metal"], half_metal(random));
    plant_and_repair(within["diffuse under metal"], diffuse_under_metal(random));
    plant_and_repair(within["hidden colour"], hidden_black(random));
    plant_and_repair(within["F0 stored linear"],
                     curve_of_specular<std::uint8_t>(random, srgb_decode, "ETK401"));
    plant_and_repair(within["normals decoded"], curve_of_normals<std::uint8_t>(random, srgb_decode));
    // Where the curve is steepest, half a code of rounding comes back as more than 2.
    plant_and_repair(beyond["F0 below 0.022 stored linear"],
                     curve_of_specular<std::uint8_t>(random, srgb_decode, "ETK401", 0.018, 0.021));
    plant_and_repair(beyond["steep normals decoded"], curve_of_normals<std::uint8_t>(random, srgb_decode, 4));
    plant_and_repair(beyond["premultiplied colour"], premultiplied(random));
  }
  BackShare sum, rest;
  for (const auto& [what, share] : within) {
    UNSCOPED_INFO(what << ": " << share.back << " of " << share.planted);
    sum.planted += share.planted;
    sum.back += share.back;
  }
  for (const auto& [what, share] : beyond) {
    UNSCOPED_INFO("beyond 2 codes, " << what << ": " << share.back << " of " << share.planted);
    rest.planted += share.planted;
    rest.back += share.back;
  }
  CHECK(100 * sum.back >= 90 * sum.planted);
  CHECK(rest.planted == 3 * seeds);
}

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
  request.paths = {folder.file("in")};
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
