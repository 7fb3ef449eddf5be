// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

#include "core/atlas/pack/pack.h"
#include "core/base/error.h"
#include "core/color/srgb.h"
#include "core/image/files/png.h"
#include "core/image/mips.h"
#include "core/material/f0.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;
namespace fs = std::filesystem;

namespace {

const MaterialLibrary& library() {
  static const MaterialLibrary built_in = MaterialLibrary::builtin();
  return built_in;
}

Image8 noise(int width, int height, int channels, unsigned seed) {
  std::mt19937 random(seed);
  Image8 out(width, height, channels);
  for (auto& each : out.values) each = static_cast<std::uint8_t>(random());
  return out;
}

void save(const std::string& path, const Image8& image) {
  const PngRows rows{{image.width, image.height, image.channels, 8},
                     image.values.data(),
                     static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels)};
  spit(path, png_bytes(rows, {}));
}

Image8 load(const std::string& path) {
  auto image = read_png8(slurp(path), path);
  REQUIRE(image);
  return *image;
}

// A material of four pictures of noise in the folder.
void add_material(const TempFolder& folder, const std::string& name, int width, int height, unsigned seed) {
  save(folder.file(name + "_diffuse.png"), noise(width, height, 3, seed));
  save(folder.file(name + "_specular.png"), noise(width, height, 3, seed + 1));
  save(folder.file(name + "_gloss.png"), noise(width, height, 1, seed + 2));
  save(folder.file(name + "_alpha.png"), noise(width, height, 1, seed + 3));
}

std::string entry(const std::string& name) {
  std::string out = "{\"name\": \"" + name + "\"";
  for (const char* role : {"diffuse", "specular", "gloss", "alpha"})
    out += std::string(", \"") + role + "\": \"" + name + "_" + role + ".png\"";
  return out + "}";
}

std::string manifest(const std::vector<std::string>& entries) {
  std::string out = "{\"materials\": [";
  for (std::size_t i = 0; i < entries.size(); ++i) out += (i == 0 ? "" : ", ") + entries[i];
  return out + "]}";
}

AtlasLayout layout_of(const std::string& out) {
  return parse_layout(slurp(out + "/layout.json"), "layout.json");
}

PackReport run(const TempFolder& folder, const std::string& text, const PackOptions& options = {}) {
  spit(folder.file("m.json"), text);
  return pack(folder.file("m.json"), folder.file("out"), options, library());
}

std::string fault(const TempFolder& folder, const std::string& text, const PackOptions& options = {}) {
  return error_of([&] { (void)run(folder, text, options); });
}

// Texel (x, y) of a material's picture in the page texture.
const std::uint8_t* texel(const Image8& page, const AtlasRect& rect, int x, int y) {
  if (rect.rotated) return page.at(rect.x + rect.width - 1 - y, rect.y + x).data();
  return page.at(rect.x + x, rect.y + y).data();
}

std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> out;
  for (const auto& each : fs::directory_iterator(folder)) out.push_back(each.path().filename().string());
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

TEST_CASE("every texel comes back, colour under alpha 0 and gloss 0 too") {
  for (const bool rotate : {false, true}) {
    const TempFolder folder;
    std::vector<std::string> entries;
    const std::vector<std::pair<int, int>> sizes{{64, 32}, {33, 70}, {1, 1}, {5, 17}, {1, 200}, {40, 40}};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      const std::string name = "m" + std::to_string(i);
      add_material(folder, name, sizes[i].first, sizes[i].second, static_cast<unsigned>(10 * i));
      entries.push_back(entry(name));
    }
    PackOptions options;
    options.rotate = rotate;
    options.keep = {"constant", "textures"};
    options.threads = 2;
    (void)run(folder, manifest(entries), options);
    const AtlasLayout layout = layout_of(folder.file("out"));
    REQUIRE(layout.rects.size() == sizes.size());
    for (const AtlasRect& rect : layout.rects) {
      const AtlasPage& page = layout.pages[static_cast<std::size_t>(rect.page)];
      const Image8 a = load(folder.file("out/" + page.files[0].at(0))),
                   b = load(folder.file("out/" + page.files[1].at(0)));
      const Image8 diffuse = load(folder.file(rect.name + "_diffuse.png")),
                   alpha = load(folder.file(rect.name + "_alpha.png"));
      const Image8 specular = load(folder.file(rect.name + "_specular.png")),
                   gloss = load(folder.file(rect.name + "_gloss.png"));
      std::size_t wrong = 0;
      for (int y = 0; y < diffuse.height; ++y)
        for (int x = 0; x < diffuse.width; ++x) {
          const auto *at = texel(a, rect, x, y), *bt = texel(b, rect, x, y);
          for (std::size_t c = 0; c < 3; ++c)
            wrong += (at[c] != diffuse.at(x, y)[c]) + (bt[c] != specular.at(x, y)[c]);
          wrong += (at[3] != alpha.at(x, y)[0]) + (bt[3] != gloss.at(x, y)[0]);
        }
      CHECK(wrong == 0);
    }
  }
}

TEST_CASE("library materials and constants come out as the core's own 8-bit F0") {
  const TempFolder folder;
  const PackReport report = run(folder, R"({"materials": [
    {"name": "gold", "specular": "gold", "gloss": 0.75},
    {"name": "copper in water", "specular": {"material": "copper", "outside": "water"}, "gloss": 1},
    {"name": "plastic", "diffuse": "#336699", "specular": [0.04, 0.04, 0.04], "gloss": 0.5, "alpha": 0.25}]})");
  CHECK(report.regions == 0);
  CHECK(report.pages.empty());
  const AtlasLayout layout = layout_of(folder.file("out"));
  const auto row = [&](const std::string& name) {
    return *std::find_if(layout.materials.begin(), layout.materials.end(),
                         [&](const auto& m) { return m.name == name; });
  };
  const auto f0 = [&](const char* id, double outside) {
    F0Options options;
    if (outside != 1)
      options.outside.index = std::get<OpticalConstants>(library().find("water")->preferred_dataset().optics);
    return F0Solver(options).solve(library().find(id)->preferred_dataset().optics).srgb8;
  };
  const Srgb8 gold = f0("gold", 1), copper = f0("copper", 1.33);
  CHECK(row("gold").constant[4] == gold.r);
  CHECK(row("gold").constant[5] == gold.g);
  CHECK(row("gold").constant[6] == gold.b);
  CHECK(row("gold").constant[7] == 191);
  CHECK(row("gold").constant[0] == 0);
  CHECK(row("gold").defines == std::vector<std::string>{"ETAK_NO_DIFFUSE"});
  CHECK(row("copper in water").constant[4] == copper.r);
  CHECK(row("copper in water").constant[6] == copper.b);
  CHECK(row("plastic").constant[0] == 0x33);
  CHECK(row("plastic").constant[4] == 56);
  CHECK(row("plastic").constant[3] == 64);
  CHECK_FALSE(report.remarks.empty());  // gold's red lies outside of sRGB
}

TEST_CASE("equal pixels are stored once, whatever their files look like") {
  const TempFolder folder;
  add_material(folder, "a", 32, 32, 1);
  add_material(folder, "b", 32, 32, 1);
  PngOptions small;
  small.level = PngLevel::smallest;
  const Image8 same = load(folder.file("a_diffuse.png"));
  spit(folder.file("b_diffuse.png"), png_bytes({{32, 32, 3, 8}, same.values.data(), 96}, small));
  PackReport report = run(folder, manifest({entry("a"), entry("b")}));
  CHECK(report.regions == 1);
  CHECK(report.passes == 2);  // it took the pixels to know
  const AtlasLayout layout = layout_of(folder.file("out"));
  REQUIRE(layout.rects.size() == 2);
  CHECK(layout.rects[0].x == layout.rects[1].x);
  PackOptions keep;
  keep.keep = {"equal"};
  CHECK(run(folder, manifest({entry("a"), entry("b")}), keep).regions == 2);
  // The same files: known before anything is read.
  std::string again = entry("a");
  again.replace(again.find("\"a\""), 3, "\"c\"");
  report = run(folder, manifest({entry("a"), again}));
  CHECK(report.regions == 1);
  CHECK(report.passes == 1);
}

TEST_CASE("the bytes do not depend on the manifest's order or on threads") {
  const TempFolder folder;
  std::vector<std::string> entries;
  for (int i = 0; i < 9; ++i) {
    const std::string name = "m" + std::to_string(i);
    add_material(folder, name, 20 + 7 * (i % 4), 30 + 5 * (i % 3), static_cast<unsigned>(100 + 10 * i));
    entries.push_back(entry(name));
  }
  PackOptions options;
  options.mips = 4;
  (void)run(folder, manifest(entries), options);
  std::vector<std::string> before;
  for (const std::string& name : files_in(folder.file("out")))
    if (name != "layout.json") before.push_back(slurp(folder.file("out/" + name)));
  const std::vector<AtlasRect> rects = layout_of(folder.file("out")).rects;
  std::reverse(entries.begin(), entries.end());
  options.threads = 4;
  (void)run(folder, manifest(entries), options);
  std::vector<std::string> after;
  for (const std::string& name : files_in(folder.file("out")))
    if (name != "layout.json") after.push_back(slurp(folder.file("out/" + name)));
  CHECK(before == after);
  CHECK(rects == layout_of(folder.file("out")).rects);
}

TEST_CASE("pages made slab by slab are the pages made at once") {
  const TempFolder folder;
  std::string list;
  const auto add = [&](const std::string& name, int width, int height, unsigned seed) {
    add_material(folder, name, width, height, seed);
    list += (list.empty() ? "" : ", ") + entry(name);
  };
  PackOptions options;
  bool some_slabs = true;
  SECTION("rows of regions, with their mips") {
    for (unsigned i = 0; i < 8; ++i) add("m" + std::to_string(i), 1024, 512, 10 * i);
    options.mips = GENERATE(1, 0, 3);
    options.bleed = GENERATE(false, true);
    options.page = 2048;
  }
  SECTION("a region in several slabs") {
    add("large", 2600, 1700, 7);
    options.mips = 1;
    options.gutter = GENERATE(0, 2);
  }
  SECTION("regions side by side in several slabs, and waste below one") {
    add("a", 2000, 1700, 1);
    add("b", 2001, 1602, 2);
    options.mips = 1;
    options.gutter = 0;
  }
  SECTION("a page that is too small for slabs") {
    add("small", 1024, 512, 7);
    options.mips = 4;
    some_slabs = false;
  }
  spit(folder.file("m.json"), "{\"gloss\": \"schueler\", \"materials\": [" + list + "]}");
  // The DDS file needs the page whole.
  PackOptions whole = options;
  whole.write.formats = {"png", "dds"};
  const auto stages = [](const PackReport& report) {
    std::string out;
    for (const PackStage& stage : report.stages) out += stage.name + ";";
    return out;
  };
  pack(folder.file("m.json"), folder.file("whole"), whole, library());
  for (const unsigned threads : {1u, 3u}) {
    options.threads = threads;
    const std::string out = folder.file("slabs" + std::to_string(threads));
    const PackReport report = pack(folder.file("m.json"), out, options, library());
    CHECK((stages(report).find("texels, mips and files;") != std::string::npos) == some_slabs);
    REQUIRE(!report.files.empty());
    for (const std::string& name : report.files)
      if (name.ends_with(".png")) {
        INFO(name);
        const bool same = slurp(out + "/" + name) == slurp(folder.file("whole") + "/" + name);
        CHECK(same);
      }
  }
}

TEST_CASE("a region's mips are those of the region alone") {
  const TempFolder folder;
  add_material(folder, "a", 64, 64, 1);
  add_material(folder, "b", 64, 128, 2);
  add_material(folder, "c", 96, 64, 3);
  PackOptions options;
  options.mips = 3;
  (void)run(folder, manifest({entry("a"), entry("b"), entry("c")}), options);
  const AtlasLayout layout = layout_of(folder.file("out"));
  for (const AtlasRect& rect : layout.rects) {
    const std::string page = folder.file("out/page" + std::to_string(rect.page));
    const auto cut = [&](const Image8& from, int x, int y, int width, int height) {
      Image8 out(width, height, 4);
      for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) std::copy_n(from.at(x + i, y + j).data(), 4, out.at(i, j).data());
      return out;
    };
    const auto level = [&](const char* texture, int l) {
      const std::string mip = l == 0 ? "" : ".mip" + std::to_string(l);
      return cut(load(page + "_" + texture + mip + ".png"), rect.x >> l, rect.y >> l, rect.width >> l,
                 rect.height >> l);
    };
    MipOptions mips;
    mips.levels = rect.mips;
    const MipPair alone = mip_pair(level("diffuse_alpha", 0), level("specular_gloss", 0), mips);
    CHECK(rect.mips >= 2);
    for (int l = 1; l < rect.mips; ++l) {
      CHECK(alone.diffuse_alpha[static_cast<std::size_t>(l)] == level("diffuse_alpha", l));
      CHECK(alone.specular_gloss[static_cast<std::size_t>(l)] == level("specular_gloss", l));
    }
  }
}

TEST_CASE("gloss changes its form by formula, and what does not fit is told") {
  CHECK(converted_gloss(0.1486, GlossForm::roughness, GlossForm::schueler) == Approx(1).margin(1e-3));
  CHECK(converted_gloss(0.9036, GlossForm::roughness, GlossForm::schueler) == Approx(0).margin(1e-3));
  CHECK(converted_gloss(0.3, GlossForm::one_minus_roughness, GlossForm::roughness) == Approx(0.7));
  for (const double g : {0.0, 0.25, 0.5, 1.0})
    CHECK(converted_gloss(converted_gloss(g, GlossForm::schueler, GlossForm::roughness), GlossForm::roughness,
                          GlossForm::schueler) == Approx(g).margin(1e-12));
  const TempFolder folder;
  add_material(folder, "a", 32, 32, 1);
  std::string text = entry("a");
  text.replace(text.find("\"gloss\""), 7, "\"roughness\"");
  const PackReport report = run(folder, manifest({text}));
  REQUIRE(report.remarks.size() == 1);
  CHECK(contains(report.remarks[0], "brought back to its ends"));
  const AtlasLayout layout = layout_of(folder.file("out"));
  const Image8 page = load(folder.file("out/page0_specular_gloss.png")),
               from = load(folder.file("a_gloss.png"));
  const double g = converted_gloss(from.at(3, 4)[0] / 255.0, GlossForm::roughness, GlossForm::schueler);
  CHECK(texel(page, layout.rects.at(0), 3, 4)[3] == static_cast<int>(255 * std::clamp(g, 0.0, 1.0) + 0.5));
}

TEST_CASE("bad inputs are told in one line, and what was there before stays") {
  const TempFolder folder;
  add_material(folder, "a", 16, 16, 1);
  (void)run(folder, manifest({entry("a")}));
  const std::string before = slurp(folder.file("out/layout.json"));
  const auto broken = [&](const std::string& from, const std::string& to) {
    std::string text = entry("a");
    text.replace(text.find(from), from.size(), to);
    return fault(folder, manifest({text}));
  };
  CHECK(contains(broken("a_diffuse.png", "missing.png"), "missing.png"));
  CHECK(contains(broken("\"a_gloss.png\"", R"({"image": "a_gloss.png", "channels": "a"})"),
                 "has 1 channels; expected at least 4"));
  CHECK(contains(broken("\"a_specular.png\"", "\"goldd\""), "no material of the library is called goldd"));
  CHECK(contains(broken("\"a_diffuse.png\"", "\"gold\""), "gold has n and k"));
  CHECK(contains(broken("\"a_diffuse.png\"", R"({"image": "a_diffuse.png", "space": "acescg"})"),
                 "/diffuse/space"));
  save(folder.file("b.png"), noise(16, 15, 3, 1));
  CHECK(contains(broken("a_diffuse.png", "b.png"), "is 16 x 16; expected 16 x 15"));
  std::string sized = entry("a");
  sized.insert(sized.size() - 1, ", \"width\": 17");
  CHECK(contains(fault(folder, manifest({sized})), "is 16 x 16; expected 17 x 16"));
  const std::string whole = slurp(folder.file("a_diffuse.png"));
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{20}, std::size_t{60}, whole.size() / 2, whole.size() - 1}) {
    spit(folder.file("a_diffuse.png"), whole.substr(0, size));
    PackOptions options;
    options.door.header = [](const std::string& path) -> PictureHeader {
      throw Error::at(path, "is no picture");
    };
    options.door.load = [](const std::string& path) -> std::variant<Image8, Image> {
      throw Error::at(path, "is no picture");
    };
    CHECK(contains(fault(folder, manifest({entry("a")}), options), "a_diffuse.png"));
  }
  spit(folder.file("a_diffuse.png"), whole);
  PackOptions small;
  small.page = 8;
  CHECK_FALSE(fault(folder, manifest({entry("a")}), small).empty());
  CHECK(slurp(folder.file("out/layout.json")) == before);
  CHECK(files_in(folder.path()).size() == 7);  // four pictures, b.png, m.json, out: nothing half-made is left
}

TEST_CASE("a NaN in a float picture is refused, and values out of range are counted") {
  const TempFolder folder;
  add_material(folder, "a", 4, 4, 1);
  std::string text = entry("a");
  text.replace(text.find("a_diffuse.png"), 13, "a_diffuse.exr");
  spit(folder.file("a_diffuse.exr"), "what the door below reads");
  Image floats(4, 4, 3, 0.5f);
  PackOptions options;
  options.door.header = [](const std::string&) { return PictureHeader{4, 4, 3, 32, false}; };
  options.door.load = [&](const std::string&) -> std::variant<Image8, Image> { return floats; };
  CHECK(run(folder, manifest({text}), options).remarks.empty());
  const Image8 page = load(folder.file("out/page0_diffuse_alpha.png"));
  const AtlasLayout layout = layout_of(folder.file("out"));
  CHECK(texel(page, layout.rects.at(0), 0, 0)[0] == srgb_u8(0.5));
  floats.values[5] = 2;
  CHECK(contains(run(folder, manifest({text}), options).remarks.at(0), "diffuse_alpha"));
  floats.values[5] = std::numeric_limits<float>::quiet_NaN();
  CHECK(contains(fault(folder, manifest({text}), options), "no finite number"));
}

TEST_CASE("files of nobody's atlas are not replaced without leave; those of an earlier atlas are") {
  const TempFolder folder;
  add_material(folder, "a", 8, 8, 1);
  fs::create_directory(folder.file("out"));
  spit(folder.file("out/page0_diffuse_alpha.png"), "mine");
  spit(folder.file("out/notes.txt"), "kept");
  CHECK(contains(fault(folder, manifest({entry("a")})), "exists already and is of no earlier atlas"));
  CHECK(slurp(folder.file("out/page0_diffuse_alpha.png")) == "mine");
  PackOptions options;
  options.overwrite = true;
  (void)run(folder, manifest({entry("a")}), options);
  options.overwrite = false;
  options.mips = 3;
  (void)run(folder, manifest({entry("a")}), options);
  CHECK(files_in(folder.file("out")).size() == 8);
  options.mips = 1;
  (void)run(folder, manifest({entry("a")}), options);
  CHECK(files_in(folder.file("out")) == std::vector<std::string>{"layout.json", "notes.txt",
                                                                 "page0_diffuse_alpha.png",
                                                                 "page0_specular_gloss.png"});
}

TEST_CASE("-u does nothing until an input or an option changes") {
  const TempFolder folder;
  add_material(folder, "a", 8, 8, 1);
  PackOptions options;
  options.update = true;
  CHECK_FALSE(run(folder, manifest({entry("a")}), options).up_to_date);
  CHECK(run(folder, manifest({entry("a")}), options).up_to_date);
  save(folder.file("a_gloss.png"), noise(8, 8, 1, 77));
  CHECK_FALSE(run(folder, manifest({entry("a")}), options).up_to_date);
  options.mips = 2;
  CHECK_FALSE(run(folder, manifest({entry("a")}), options).up_to_date);
  fs::remove(folder.file("out/page0_diffuse_alpha.png"));
  CHECK_FALSE(run(folder, manifest({entry("a")}), options).up_to_date);
  CHECK(run(folder, manifest({entry("a")}), options).up_to_date);
}

TEST_CASE("a dry run reports and writes nothing") {
  const TempFolder folder;
  add_material(folder, "a", 8, 8, 1);
  PackOptions options;
  options.dry_run = true;
  CHECK(run(folder, manifest({entry("a")}), options).regions == 1);
  CHECK_FALSE(fs::exists(folder.file("out")));
}

TEST_CASE("with the previous layout given, regions that did not change stay where they were") {
  const TempFolder folder;
  std::vector<std::string> entries;
  for (int i = 0; i < 12; ++i) {
    const std::string name = "m" + std::to_string(i);
    add_material(folder, name, 20 + 3 * i, 60 - 4 * i, static_cast<unsigned>(100 + 10 * i));
    entries.push_back(entry(name));
  }
  (void)run(folder, manifest(entries));
  const AtlasLayout old = layout_of(folder.file("out"));
  fs::copy_file(folder.file("out/layout.json"), folder.file("previous.json"));
  entries.erase(entries.begin() + 5);
  PackOptions options;
  options.previous = folder.file("previous.json");
  const PackReport report = run(folder, manifest(entries), options);
  const AtlasLayout now = layout_of(folder.file("out"));
  CHECK(report.kept_previous);
  CHECK(report.moved == 0);
  for (const AtlasRect& rect : now.rects)
    CHECK(std::find(old.rects.begin(), old.rects.end(), rect) != old.rects.end());
}

TEST_CASE("metal-rough pictures become diffuse and F0 by formula") {
  const TempFolder folder;
  save(folder.file("a_basecolor.png"), noise(8, 8, 3, 1));
  save(folder.file("a_metallic.png"), noise(8, 8, 1, 2));
  save(folder.file("a_roughness.png"), noise(8, 8, 1, 3));
  PackOptions options;
  options.gloss = GlossForm::one_minus_roughness;
  (void)pack(folder.path(), folder.file("out"), options, library());
  const AtlasRect rect = layout_of(folder.file("out")).rects.at(0);
  const Image8 a = load(folder.file("out/page0_diffuse_alpha.png")),
               b = load(folder.file("out/page0_specular_gloss.png"));
  const Image8 base = load(folder.file("a_basecolor.png")), metal = load(folder.file("a_metallic.png")),
               rough = load(folder.file("a_roughness.png"));
  for (int i = 0; i < 8; ++i) {
    const double m = metal.at(i, i)[0] / 255.0, c = srgb_decode(base.at(i, i)[1] / 255.0);
    CHECK(texel(a, rect, i, i)[1] == srgb_u8(c * (1 - m)));
    CHECK(texel(b, rect, i, i)[1] == srgb_u8(0.04 * (1 - m) + c * m));
    CHECK(texel(b, rect, i, i)[3] == 255 - rough.at(i, i)[0]);
    CHECK(texel(a, rect, i, i)[3] == 255);
  }
}

TEST_CASE("mips average gloss in the form it has") {
  const TempFolder folder;
  Image8 halves(64, 64, 1);
  for (std::size_t i = 0; i < halves.values.size(); ++i) halves.values[i] = i % 2 == 0 ? 0 : 255;
  add_material(folder, "a", 64, 64, 1);
  save(folder.file("a_gloss.png"), halves);
  const auto level_1 = [&](const std::string& form) {
    PackOptions options;
    options.mips = 2;
    (void)run(folder, "{\"gloss\": \"" + form + "\", " + manifest({entry("a")}).substr(1), options);
    const AtlasRect rect = layout_of(folder.file("out")).rects.at(0);
    return int{load(folder.file("out/page0_specular_gloss.mip1.png")).at(rect.x / 2 + 3, rect.y / 2 + 3)[3]};
  };
  // Half of each texel is a mirror, half is fully rough: alpha^2 of 1/2.
  const double roughness = std::pow(0.5, 0.25);
  CHECK(level_1("roughness") == static_cast<int>(255 * roughness + 0.5));
  CHECK(level_1("one_minus_roughness") == static_cast<int>(255 * (1 - roughness) + 0.5));
  // 1/e of 1 and 1/4096, weighted by F0's luminance; between the plain mean and its neighbours.
  CHECK(std::abs(level_1("schueler") - 255 * std::log2(2.0) / 12) <= 25);
}

TEST_CASE("a rough normal map lowers the gloss of the mips, in every form") {
  const TempFolder folder;
  add_material(folder, "a", 64, 64, 1);
  save(folder.file("a_gloss.png"), Image8(64, 64, 1, 200));
  // Tilted to the left and to the right by turns: |N| of the mean is the cosine of the tilt.
  Image8 tilted(64, 64, 3, 128);
  const double tilt = 0.5;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      tilted.at(x, y)[0] =
          static_cast<std::uint8_t>(127.5 * (1 + (x % 2 == 0 ? 1 : -1) * std::sin(tilt)) + 0.5);
      tilted.at(x, y)[2] = static_cast<std::uint8_t>(127.5 * (1 + std::cos(tilt)) + 0.5);
    }
  save(folder.file("a_normal.png"), tilted);
  PackOptions options;
  options.mips = 2;
  const auto level_1 = [&](const std::string& more, const std::string& form) {
    std::string text = entry("a");
    text.insert(text.size() - 1, more);
    (void)run(folder, "{\"gloss\": \"" + form + "\", " + manifest({text}).substr(1), options);
    const AtlasRect rect = layout_of(folder.file("out")).rects.at(0);
    return int{load(folder.file("out/page0_specular_gloss.mip1.png")).at(rect.x / 2 + 3, rect.y / 2 + 3)[3]};
  };
  const std::string map = ", \"normal\": \"a_normal.png\"";
  CHECK(level_1("", "schueler") == 200);
  CHECK(level_1(map, "schueler") < 150);
  const double spread = (1 - std::cos(tilt)) / std::cos(tilt);
  const auto rougher = [&](double r) { return std::pow(r * r * r * r + 2 * spread, 0.25); };
  CHECK(level_1("", "roughness") == 200);
  CHECK(std::abs(level_1(map, "roughness") - 255 * rougher(200 / 255.0)) <= 2);
  CHECK(std::abs(level_1(map, "one_minus_roughness") - 255 * (1 - rougher(1 - 200 / 255.0))) <= 2);
}

TEST_CASE("the gutter repeats what was bled, of converted pictures too") {
  const TempFolder folder;
  Image8 alpha(48, 48, 1, 255);  // its border of 6 texels is hidden
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x)
      if (std::min({x, y, 47 - x, 47 - y}) < 6) alpha.at(x, y)[0] = 0;
  save(folder.file("a.png"), alpha);
  save(folder.file("base.png"), noise(48, 48, 3, 1));
  save(folder.file("metal.png"), noise(48, 48, 1, 2));
  save(folder.file("gloss.png"), noise(48, 48, 1, 3));
  PackOptions options;
  options.bleed = true;
  options.gutter = 4;
  const std::string colours = GENERATE(R"("basecolor": "base.png", "metallic": "metal.png")",
                                       R"("diffuse": "base.png", "specular": "base.png")");
  (void)run(folder,
            R"({"materials": [{"name": "a", )" + colours + R"(, "gloss": "gloss.png", "alpha": "a.png"}]})",
            options);
  const AtlasRect rect = layout_of(folder.file("out")).rects.at(0);
  REQUIRE(rect.gutter == 4);
  for (const char* file : {"out/page0_diffuse_alpha.png", "out/page0_specular_gloss.png"}) {
    const Image8 page = load(folder.file(file));
    for (int y = -4; y < 52; ++y)
      for (int x = -4; x < 52; ++x) {
        const auto inner = page.at(rect.x + std::clamp(x, 0, 47), rect.y + std::clamp(y, 0, 47));
        REQUIRE(std::equal(inner.begin(), inner.end(), page.at(rect.x + x, rect.y + y).begin()));
      }
  }
}

TEST_CASE(
    "found 4.03: a picture that is exported anew while the atlas is made is told, and nothing is written") {
  const TempFolder folder;
  add_material(folder, "a", 32, 32, 1);
  const std::string picture = folder.file("a_diffuse.png");
  fs::last_write_time(picture, fs::file_time_type{});
  PackOptions options;
  bool change = true;
  // Called when the pixels of a page are whole, and so after the picture was read.
  options.check_page = [&](const AtlasLayout&, int page, const PagePixels&) {
    if (change && page == 0) save(picture, noise(32, 32, 3, 77));
    return true;
  };
  CHECK(fault(folder, manifest({entry("a")}), options) ==
        picture + ": changed while the atlas was made; expected a file that stays as it is");
  CHECK_FALSE(fs::exists(folder.file("out")));
  change = false;
  CHECK(fault(folder, manifest({entry("a")}), options).empty());
}
