// SPDX-License-Identifier: Apache-2.0
#include "core/validate/check_pack.h"

#include <catch2/catch.hpp>

#include "core/base/files/output.h"
#include "core/findings/output/formats.h"
#include "core/image/files/png.h"
#include "core/judge/check_pictures.h"
#include "core/validate/files/check.h"
#include "core/validate/files/layout_targets.h"
#include "core/validate/validate.h"
#include "tests/core/image/png_of.h"
#include "tests/core/judge/corpus.h"
#include "tests/core/material/library_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

// A manifest of textures with F0 in the forbidden zone, and of numbers in it.
std::string write_manifest(const TempFolder& folder) {
  TextureSet set = natural_set(64, 1);
  Random random(1);
  std::ranges::find(mutations(), "ETK101", &Mutation::rule)->inject(set, random);
  spit(folder.file("a.png"), png_of(set.a));
  spit(folder.file("b.png"), png_of(set.b));
  spit(folder.file("m.json"), R"({"schema": "etak-atlas-manifest/1", "materials": [
    {"name": "crate", "diffuse": "a.png", "specular": {"image": "b.png", "channels": "rgb"},
     "gloss": {"image": "b.png", "channels": "a"}},
    {"name": "impossible", "diffuse": [0.1, 0.1, 0.1], "specular": 0.3, "gloss": 0.5}]})");
  return folder.file("m.json");
}

struct Packed {
  PackResult report;
  ValidationReport findings;
  bool failed = false;
};

Packed pack_checked(const TempFolder& folder, PackCheckOptions asked, PackOptions options = {}) {
  asked.config.root = folder.path();
  PackCheck check(folder.file("atlas"), asked);
  CHECK(check.report() == nullptr);
  check.attach(options);
  options.check.beside = [&](PackResult& report, OutputFolder*) -> std::unique_ptr<Output> {
    check.finish(report);
    return nullptr;
  };
  Packed out;
  out.report = pack(write_manifest(folder), folder.file("atlas"), options, test::library());
  if (check.report() != nullptr) out.findings = *check.report();
  out.failed = check.failed();
  return out;
}

}  // namespace

TEST_CASE("what is found while packing is what validate() finds in the atlas on the disk") {
  const TempFolder folder;
  const Packed packed = pack_checked(folder, {});
  CHECK(packed.failed);
  CHECK(contains(packed.report.validation, "ETK101"));
  ValidationRequest request;
  request.inputs.paths = {folder.file("atlas/layout.json")};
  request.config.root = folder.path();
  const ValidationReport again = validate(request);
  REQUIRE(again.files.size() == 2);
  REQUIRE(packed.findings.files.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(packed.findings.files[i].path == again.files[i].path);
    CHECK(packed.findings.files[i].findings == again.files[i].findings);
    CHECK(!again.files[i].findings.empty());
  }
  CHECK(packed.findings.settings_hash == again.settings_hash);
}

TEST_CASE("an atlas that fails is never up to date, and one under a higher limit is") {
  const TempFolder folder;
  PackOptions update;
  update.output.update = true;
  CHECK(pack_checked(folder, {}).failed);
  CHECK(!pack_checked(folder, {}, update).report.up_to_date);
  PackCheckOptions lenient;
  lenient.never_fails = true;
  CHECK(!pack_checked(folder, lenient, update).failed);
  CHECK(pack_checked(folder, lenient, update).report.up_to_date);
}

TEST_CASE("the limit of the configuration is part of what an atlas depends on") {
  const TempFolder folder;
  PackOptions update;
  update.output.update = true;
  PackCheckOptions nothing;
  nothing.config.settings.profile = Profile::custom;  // no rule is on
  CHECK(!pack_checked(folder, nothing).failed);
  CHECK(pack_checked(folder, nothing, update).report.up_to_date);
  nothing.config.settings.fail_on = Severity::info;
  CHECK(!pack_checked(folder, nothing, update).report.up_to_date);
  CHECK(pack_checked(folder, nothing, update).report.up_to_date);
}

TEST_CASE("islands of a material have one finding for each rule, with the worst in front and a list of all") {
  AtlasLayout layout;
  layout.pages.push_back({128, 64, {}});
  layout.pages[0].files = {std::vector<std::string>{"a.png"}, std::vector<std::string>{"b.png"}};
  for (int island = 0; island < 3; ++island) {
    AtlasRect rect;
    rect.name = "crate";
    rect.island = island;
    rect.x = 40 * island;
    rect.width = 40, rect.height = 64;
    layout.rects.push_back(rect);
  }
  Image8 a(128, 64, 4, 120), b(128, 64, 4, 56);
  Random random(1);
  for (std::size_t i = 3; i < a.values.size(); i += 4) {
    a.values[i] = 255;
    b.values[i] = static_cast<std::uint8_t>(60 + random.below(100));
  }
  const auto plateau = [&](int left, int side) {
    for (int y = 8; y < 8 + side; ++y)
      for (int x = left; x < left + side; ++x) std::fill_n(b.at(x, y).begin(), 3, std::uint8_t{160});
  };
  plateau(4, 16);
  plateau(84, 24);
  const std::vector<CheckTarget> targets =
      targets_of_layout(layout, "atlas/layout.json", "atlas/layout.json");
  REQUIRE(!targets.empty());
  const CheckedFile file = check_pictures(targets[0], {a, b, {}}, {}, 1);
  std::vector<Finding> zone;
  for (const Finding& finding : file.findings)
    if (finding.rule == "ETK101") zone.push_back(finding);
  REQUIRE(zone.size() == 1);
  CHECK(zone[0].tile == "crate");
  REQUIRE(zone[0].islands.size() == 2);
  CHECK(zone[0].islands[0].tile == "crate");
  CHECK(zone[0].islands[1].tile == "crate#2");
  CHECK(zone[0].area_px == zone[0].islands[1].area_px);
  CHECK(zone[0].box == zone[0].islands[1].box);
  CHECK(contains(place_of(zone[0]), ":tile \"crate\" ["));
  CHECK(contains(place_of(zone[0]), "] and 1 more island"));
}

namespace {

// A page of one blue F0, which all of the materials have, each with its layers.
CheckedFile check_blue(const std::vector<std::pair<std::string, std::string>>& names_and_layers) {
  AtlasLayout layout;
  layout.pages.push_back({64, 64, {std::vector<std::string>{"a.png"}, std::vector<std::string>{"b.png"}}});
  for (const auto& [name, layers] : names_and_layers) {
    AtlasRect rect;
    rect.name = name;
    rect.width = rect.height = rect.source_width = rect.source_height = 64;
    rect.crop = {0, 0, 64, 64};
    layout.rects.push_back(rect);
    AtlasMaterialRow row;
    row.name = name;
    row.layers = layers;
    layout.materials.push_back(row);
  }
  Image8 a(64, 64, 4, 255), b(64, 64, 4);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const std::array<std::uint8_t, 4> blue{75, 53, 144, static_cast<std::uint8_t>(150 + (x + y) % 32)};
      std::ranges::copy(blue, b.at(x, y).begin());
      std::ranges::fill(a.at(x, y).first(3), std::uint8_t{0});
    }
  const AtlasLayout read = parse_layout(layout_json(layout), "layout.json");
  CHECK(read == layout);
  return check_pictures(targets_of_layout_text(layout_json(layout), "layout.json", "layout.json").at(0),
                        {a, b, {}}, {}, 1);
}

const Finding& hue_of(const CheckedFile& file) {
  const auto found = std::ranges::find(file.findings, "ETK106", &Finding::rule);
  REQUIRE(found != file.findings.end());
  return *found;
}

}  // namespace

TEST_CASE(
    "a layout's layers explain colours of interference, for a bare material of the same texels they do not") {
  const std::pair<std::string, std::string> oxide{"oxide", "anatase:40nm/titanium"}, paint{"paint", ""};
  const Finding explained = hue_of(check_blue({oxide}));
  CHECK(explained.severity == Severity::info);
  CHECK(contains(explained.message, "layers make such colours by interference: anatase:40nm/titanium"));
  for (const auto& materials : {std::vector{paint}, std::vector{oxide, paint}, std::vector{paint, oxide}}) {
    const Finding bare = hue_of(check_blue(materials));
    CHECK(bare.severity == Severity::error);
    CHECK(!contains(bare.message, "layers"));
  }
}
