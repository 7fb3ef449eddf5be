// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "core/atlas/layout.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

AtlasLayout layout() {
  AtlasLayout out;
  out.gloss = GlossForm::one_minus_roughness;
  out.levels = 3;
  AtlasPage page{64, 32, {}};
  page.files[0] = {"page0_diffuse_alpha.png", "page0_diffuse_alpha.ktx2"};
  out.pages.push_back(page);
  AtlasRect rect;
  rect.name = "a \"quoted\" name\n";
  rect.x = 4, rect.y = 8, rect.width = 10, rect.height = 20;
  rect.rotated = true;
  rect.crop = {1, 2, 20, 10};
  rect.source_width = 30, rect.source_height = 40;
  rect.gutter = 2, rect.mips = 2;
  rect.inset = 0.5;
  rect.repeats = true;
  rect.island = 3;
  out.rects.push_back(rect);
  AtlasMaterialRow row;
  row.name = rect.name;
  row.alpha_mode = AlphaMode::mask;
  row.alpha_cutoff = 0.25;
  row.constant[4] = 56;
  row.defines = {"ETAK_SCALAR_F0"};
  row.layers = "anatase:40nm/titanium";
  out.materials.push_back(row);
  out.settings_hash = "12", out.content_hash = "34";
  out.other_files = {"scene.gltf"};
  out.xxh128 = {{"scene.gltf", std::string(32, 'a')}, {"a \"quoted\" name", "b"}};
  return out;
}

}  // namespace

TEST_CASE("a layout says which channels a texture in BC4 or BC5 holds") {
  AtlasLayout with = layout();
  with.pages[0].in_blocks = {"specular", "gloss"};
  const std::string text = layout_json(with);
  CHECK(parse_layout(text, "l") == with);
  std::string bad = text;
  bad.replace(bad.find("[\"specular\", \"gloss\"]"), 21, "[\"gloss\", \"gloss\"]");
  CHECK(contains(error_of([&] { (void)parse_layout(bad, "l"); }), "/pages/0/specular_gloss_in_blocks"));
}

TEST_CASE("a layout says which fourth channels lie in files of their own") {
  AtlasLayout with = layout();
  with.pages[0].fourth_apart = {false, true};
  const std::string text = layout_json(with);
  CHECK(parse_layout(text, "l") == with);
  CHECK(fourth_file_beside("page0_specular_gloss.dds", Texture::specular_gloss) == "page0_gloss.dds");
  CHECK(fourth_file_beside("page12_diffuse_alpha.ktx2", Texture::diffuse_alpha) == "page12_alpha.ktx2");
  CHECK(fourth_file_beside("page0_specular_gloss.png", Texture::specular_gloss).empty());
  std::string bad = text;
  bad.replace(bad.find("[\"gloss\"]"), 9, "[\"F0\"]");
  CHECK(contains(error_of([&] { (void)parse_layout(bad, "l"); }), "/pages/0/apart_in_blocks"));
}

TEST_CASE("a layout reads back as it was written") {
  CHECK(parse_layout(layout_json(layout()), "l") == layout());
}

TEST_CASE("a layout whose materials' parts lie apart is of version 2, which a reader of version 1 refuses") {
  AtlasLayout apart = layout();
  CHECK(contains(layout_json(apart), "\"etak-atlas-layout/1\""));
  apart.rects[0].holds = {true, false, false, true};
  const std::string text = layout_json(apart);
  CHECK(contains(text, "\"etak-atlas-layout/2\""));
  CHECK(contains(text, "\"parts\": [\"diffuse\", \"gloss\"]"));
  CHECK(parse_layout(text, "l") == apart);
  std::string wrong = text;
  wrong.replace(wrong.find("[\"diffuse\""), 10, "[\"colour\"");
  CHECK(contains(error_of([&] { (void)parse_layout(wrong, "l.json"); }), "#/rects/0/parts"));
}

TEST_CASE("a layout that is wrong is told where") {
  const auto fault = [](const std::string& from, const std::string& to) {
    std::string text = layout_json(layout());
    const auto at = text.find(from);
    REQUIRE(at != text.npos);
    text.replace(at, from.size(), to);
    return error_of([&] { (void)parse_layout(text, "l.json"); });
  };
  CHECK(contains(fault("etak-atlas-layout/1", "other"), "l.json#/: not an atlas layout"));
  CHECK(contains(fault("\"page\": 0", "\"page\": 1"), "#/rects/0/page"));
  CHECK(contains(fault("\"w\": 10", "\"w\": 0"), "#/rects/0/w"));
  CHECK(contains(fault("\"inset\": 0.5", "\"inset\": -0.5"), "#/rects/0/inset"));
  CHECK(contains(fault("\"mask\"", "\"mksa\""), "#/materials/0/alpha_mode: \"mksa\""));
  CHECK(contains(fault("\"diffuse_alpha\": \"page0_diffuse_alpha.png\"", "\"diffuse_alpha\": null"),
                 "#/pages/0/diffuse_alpha_more"));
  CHECK(contains(fault("\"specular_r\": 56", "\"specular_r\": 256"), "#/materials/0/constant/specular_r"));
  CHECK(contains(error_of([] { (void)parse_layout("[]", "l.json"); }), "l.json"));
}

TEST_CASE("a layout names files of its own folder only") {
  for (const char* name : {"../victim.txt", "/absolute", "..", ".", "", "sub/page.png"}) {
    AtlasLayout other = layout();
    other.other_files = {"scene.gltf", name};
    CHECK(contains(error_of([&] { (void)parse_layout(layout_json(other), "l.json"); }),
                   "l.json#/other_files/1"));
    AtlasLayout page = layout();
    page.pages.at(0).files[0] = {name, name};
    CHECK(contains(error_of([&] { (void)parse_layout(layout_json(page), "l.json"); }), "l.json#/pages/0/"));
  }
}
