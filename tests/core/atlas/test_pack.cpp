// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/color/srgb.h"
#include "core/material/f0.h"
#include "core/pack/pack.h"
#include "tests/core/atlas/pack_support.h"

using namespace etak;
using namespace etak::test;

TEST_CASE("every texel comes back, colour under alpha 0 and gloss 0 too") {
  for (const bool rotate : {false, true}) {
    const TempFolder folder;
    std::vector<std::string> entries;
    const std::vector<std::pair<int, int>> sizes{{64, 32}, {33, 70}, {1, 1}, {5, 17}, {1, 200}, {40, 40}};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      const std::string name = "m" + std::to_string(i);
      add_noise_material(folder, name, sizes[i].first, sizes[i].second, static_cast<unsigned>(10 * i));
      entries.push_back(manifest_entry(name));
    }
    PackOptions options;
    options.layout.rotate = rotate;
    options.leave_out.keep = {"constant", "textures"};
    options.run.threads = 2;
    (void)pack_text(folder, manifest_of(entries), options);
    const AtlasLayout layout = packed_layout(folder);
    REQUIRE(layout.rects.size() == sizes.size());
    for (const AtlasRect& rect : layout.rects) {
      const AtlasPage& page = layout.pages[static_cast<std::size_t>(rect.page)];
      const Image8 a = load_png(folder.file("out/" + page.files[0].at(0))),
                   b = load_png(folder.file("out/" + page.files[1].at(0)));
      const Image8 diffuse = load_png(folder.file(rect.name + "_diffuse.png")),
                   alpha = load_png(folder.file(rect.name + "_alpha.png"));
      const Image8 specular = load_png(folder.file(rect.name + "_specular.png")),
                   gloss = load_png(folder.file(rect.name + "_gloss.png"));
      std::size_t wrong = 0;
      for (int y = 0; y < diffuse.height; ++y)
        for (int x = 0; x < diffuse.width; ++x) {
          const auto *at = texel_of(a, rect, x, y), *bt = texel_of(b, rect, x, y);
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
  const PackResult report = pack_text(folder, R"({"materials": [
    {"name": "gold", "specular": "gold", "gloss": 0.75},
    {"name": "copper in water", "specular": {"material": "copper", "outside": "water"}, "gloss": 1},
    {"name": "plastic", "diffuse": "#336699", "specular": [0.04, 0.04, 0.04], "gloss": 0.5, "alpha": 0.25}]})");
  CHECK(report.regions == 0);
  CHECK(report.pages.empty());
  const AtlasLayout layout = packed_layout(folder);
  const auto row = [&](const std::string& name) {
    return *std::find_if(layout.materials.begin(), layout.materials.end(),
                         [&](const auto& m) { return m.name == name; });
  };
  const auto f0 = [&](const char* id, double outside) {
    F0Options options;
    if (outside != 1)
      options.outside.index =
          std::get<OpticalConstants>(built_in_library().find("water")->preferred_dataset().optics);
    return F0Solver(options).solve(built_in_library().find(id)->preferred_dataset().optics).srgb8;
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
  add_noise_material(folder, "a", 32, 32, 1);
  add_noise_material(folder, "b", 32, 32, 1);
  PngOptions small;
  small.level = PngLevel::smallest;
  const Image8 same = load_png(folder.file("a_diffuse.png"));
  spit(folder.file("b_diffuse.png"), png_bytes({{32, 32, 3, 8}, same.values.data(), 96}, small));
  PackResult report = pack_text(folder, manifest_of({manifest_entry("a"), manifest_entry("b")}));
  CHECK(report.regions == 1);
  CHECK(report.passes == 2);  // it took the pixels to know
  const AtlasLayout layout = packed_layout(folder);
  REQUIRE(layout.rects.size() == 2);
  CHECK(layout.rects[0].x == layout.rects[1].x);
  PackOptions keep;
  keep.leave_out.keep = {"equal"};
  CHECK(pack_text(folder, manifest_of({manifest_entry("a"), manifest_entry("b")}), keep).regions == 2);
  // The same files: known before anything is read.
  std::string again = manifest_entry("a");
  again.replace(again.find("\"a\""), 3, "\"c\"");
  report = pack_text(folder, manifest_of({manifest_entry("a"), again}));
  CHECK(report.regions == 1);
  CHECK(report.passes == 1);
}

TEST_CASE("gloss changes its form by formula, and what does not fit is told") {
  CHECK(converted_gloss(0.1486, GlossForm::roughness, GlossForm::schueler) == Approx(1).margin(1e-3));
  CHECK(converted_gloss(0.9036, GlossForm::roughness, GlossForm::schueler) == Approx(0).margin(1e-3));
  CHECK(converted_gloss(0.3, GlossForm::one_minus_roughness, GlossForm::roughness) == Approx(0.7));
  for (const double g : {0.0, 0.25, 0.5, 1.0})
    CHECK(converted_gloss(converted_gloss(g, GlossForm::schueler, GlossForm::roughness), GlossForm::roughness,
                          GlossForm::schueler) == Approx(g).margin(1e-12));
  const TempFolder folder;
  add_noise_material(folder, "a", 32, 32, 1);
  std::string text = manifest_entry("a");
  text.replace(text.find("\"gloss\""), 7, "\"roughness\"");
  const PackResult report = pack_text(folder, manifest_of({text}));
  REQUIRE(report.remarks.size() == 1);
  CHECK(contains(report.remarks[0], "brought back to its ends"));
  const AtlasLayout layout = packed_layout(folder);
  const Image8 page = load_png(folder.file("out/page0_specular_gloss.png")),
               from = load_png(folder.file("a_gloss.png"));
  const double g = converted_gloss(from.at(3, 4)[0] / 255.0, GlossForm::roughness, GlossForm::schueler);
  CHECK(texel_of(page, layout.rects.at(0), 3, 4)[3] == static_cast<int>(255 * std::clamp(g, 0.0, 1.0) + 0.5));
}

TEST_CASE("metal-rough pictures become diffuse and F0 by formula") {
  const TempFolder folder;
  save_png(folder.file("a_basecolor.png"), noise(8, 8, 3, 1));
  save_png(folder.file("a_metallic.png"), noise(8, 8, 1, 2));
  save_png(folder.file("a_roughness.png"), noise(8, 8, 1, 3));
  PackOptions options;
  options.input.pictures.gloss = GlossForm::one_minus_roughness;
  (void)pack(folder.path(), folder.file("out"), options, built_in_library());
  const AtlasRect rect = packed_layout(folder).rects.at(0);
  const Image8 a = load_png(folder.file("out/page0_diffuse_alpha.png")),
               b = load_png(folder.file("out/page0_specular_gloss.png"));
  const Image8 base = load_png(folder.file("a_basecolor.png")),
               metal = load_png(folder.file("a_metallic.png")),
               rough = load_png(folder.file("a_roughness.png"));
  for (int i = 0; i < 8; ++i) {
    const double m = metal.at(i, i)[0] / 255.0, c = srgb_decode(base.at(i, i)[1] / 255.0);
    CHECK(texel_of(a, rect, i, i)[1] == srgb_u8(c * (1 - m)));
    CHECK(texel_of(b, rect, i, i)[1] == srgb_u8(0.04 * (1 - m) + c * m));
    CHECK(texel_of(b, rect, i, i)[3] == 255 - rough.at(i, i)[0]);
    CHECK(texel_of(a, rect, i, i)[3] == 255);
  }
}

TEST_CASE("the gutter repeats what was bled, of converted pictures too") {
  const TempFolder folder;
  Image8 alpha(48, 48, 1, 255);  // its border of 6 texels is hidden
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x)
      if (std::min({x, y, 47 - x, 47 - y}) < 6) alpha.at(x, y)[0] = 0;
  save_png(folder.file("a.png"), alpha);
  save_png(folder.file("base.png"), noise(48, 48, 3, 1));
  save_png(folder.file("metal.png"), noise(48, 48, 1, 2));
  save_png(folder.file("gloss.png"), noise(48, 48, 1, 3));
  PackOptions options;
  options.output.bleed = true;
  options.layout.gutter = 4;
  const std::string colours = GENERATE(R"("basecolor": "base.png", "metallic": "metal.png")",
                                       R"("diffuse": "base.png", "specular": "base.png")");
  (void)pack_text(
      folder, R"({"materials": [{"name": "a", )" + colours + R"(, "gloss": "gloss.png", "alpha": "a.png"}]})",
      options);
  const AtlasRect rect = packed_layout(folder).rects.at(0);
  REQUIRE(rect.gutter == 4);
  for (const char* file : {"out/page0_diffuse_alpha.png", "out/page0_specular_gloss.png"}) {
    const Image8 page = load_png(folder.file(file));
    for (int y = -4; y < 52; ++y)
      for (int x = -4; x < 52; ++x) {
        const auto inner = page.at(rect.x + std::clamp(x, 0, 47), rect.y + std::clamp(y, 0, 47));
        REQUIRE(std::equal(inner.begin(), inner.end(), page.at(rect.x + x, rect.y + y).begin()));
      }
  }
}

TEST_CASE("a layout settles however many of its pages teach that less is needed") {
  const TempFolder folder;
  std::vector<std::string> entries;
  PackOptions options;
  options.layout.page = 64;  // each picture has a page of its own
  for (unsigned i = 0; i < 8; ++i) {
    const std::string name = "m" + std::to_string(i);
    add_noise_material(folder, name, 64, 64, 4 * i);
    save_png(folder.file(name + "_specular.png"), Image8(64, 64, 3, 50));
    save_png(folder.file(name + "_gloss.png"), Image8(64, 64, 1, 99));
    entries.push_back(manifest_entry(name));
  }
  const PackResult result = pack_text(folder, manifest_of(entries), options);
  CHECK(result.passes <= 3);
  for (const AtlasPage& page : packed_layout(folder).pages) {
    CHECK_FALSE(page.files[static_cast<std::size_t>(Texture::diffuse_alpha)].empty());
    CHECK(page.files[static_cast<std::size_t>(Texture::specular_gloss)].empty());
  }
}
