// SPDX-License-Identifier: Apache-2.0
// Folders with one defect each, judged as `etak validate FOLDER` judges them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>

#include "core/findings/output/formats.h"
#include "tests/core/image/block_files.h"
#include "tests/core/validate/checked.h"
#include "tests/core/validate/planted_sets.h"
#include "tests/core/validate/repaired.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

ValidationReport report_on_files(const std::map<std::string, std::string>& files) {
  const TempFolder folder;
  for (const auto& [name, bytes] : files) spit(folder.file(name), bytes);
  ValidationRequest request;
  request.inputs.paths = {folder.path()};
  request.config.root = folder.path();
  request.run.door = picture_door();
  return validate(std::move(request));
}

Severity worst_of(const ValidationReport& report, std::string_view rule) {
  Severity worst = Severity::off;
  for (const CheckedFile& file : report.files)
    for (const Finding& finding : file.findings)
      if (rule.empty() || finding.rule == rule) worst = std::max(worst, finding.severity);
  return worst;
}

}  // namespace

TEST_CASE("of the planted sets at least 95 in a hundred are found, all with their severity") {
  struct Score {
    int planted = 0, found = 0, severities = 0, statuses = 0;
  };
  std::map<std::string, Score> scores;
  Score all;
  std::string missed;
  for (const PlantedSet& set : planted_sets(24, 37)) {
    const ValidationReport report = report_on_files(set.files);
    const Severity found = worst_of(report, set.rule);
    for (Score* score : {&scores[set.kind], &all}) {
      ++score->planted;
      score->found += found != Severity::off;
      score->severities += found == set.severity;
      score->statuses += (report.incomplete ? 2 : report.passed ? 0 : 1) == set.status;
    }
    if (found != set.severity) missed += set.kind + ":\n" + validation_text(report);
  }
  INFO(missed);
  for (const auto& [kind, score] : scores) {
    CAPTURE(kind, score.planted, score.found, score.severities, score.statuses);
    CHECK(100 * score.found >= 90 * score.planted);
    CHECK(score.statuses == score.planted);
  }
  CHECK(100 * all.found >= 95 * all.planted);
  CHECK(all.severities == all.found);
}

TEST_CASE("right sets give no warning and no error") {
  int alarms = 0;
  for (const PlantedSet& set : right_sets(96, 11)) {
    const ValidationReport report = report_on_files(set.files);
    if (worst_of(report, {}) < Severity::warning) continue;
    ++alarms;
    UNSCOPED_INFO(validation_text(report));
  }
  CHECK(alarms == 0);
}

TEST_CASE(
    "a repair makes no normals unit whose mean leans, so that a second run does not pass what is wrong") {
  for (const PlantedSet& set : planted_sets(2, 5)) {
    if (set.rule != "ETK704") continue;
    const TempFolder folder;
    const std::string from = folder.file("in"), to = folder.file("out");
    std::filesystem::create_directories(from);
    // A lean without the curve: red and green are raised, and the lengths with them.
    Image8 map = std::get<Image8>(loaded_codes([&] {
      spit(from + "/" + set.files.begin()->first, set.files.begin()->second);
      return from + "/" + set.files.begin()->first;
    }()));
    std::filesystem::remove(from + "/" + set.files.begin()->first);
    each_texel(map, [](auto texel, int, int) { texel[1] = 128; });
    put_pictures(from, {{"wall_normal.png", map}});
    const RepairedFolder repaired = repair_folder(from, to);
    INFO(validation_text(repaired.before) << validation_text(repaired.after));
    CHECK(has_rule(repaired.before, "ETK701"));
    CHECK(repaired.report.files.empty());
  }
}

TEST_CASE("a file that cannot be read is no fault of the sound map beside it") {
  for (const PlantedSet& set : planted_sets(1, 6)) {
    if (set.rule != "ETK011") continue;
    std::map<std::string, std::string> files = right_sets(1, 3).front().files;
    files["wall_roughness.png"] = set.files.begin()->second;
    for (const CheckedFile& file : report_on_files(files).files)
      for (const Finding& finding : file.findings)
        CHECK((finding.rule != "ETK011" || finding.file == "wall_roughness.png"));
  }
}

TEST_CASE("textures whose blocks cannot hold what they are for are told by their format") {
  struct Row {
    FileRole role;
    std::string_view format;
    Severity told;  // off: not at all
  };
  const Row rows[] = {{FileRole::specular_gloss, "BC1", Severity::error},
                      {FileRole::specular_gloss, "BC2", Severity::error},
                      {FileRole::specular_gloss, "BC3", Severity::off},
                      {FileRole::specular_gloss, "BC7", Severity::off},
                      {FileRole::specular_gloss, "ASTC 4x4", Severity::off},
                      {FileRole::specular_gloss, "ASTC 6x6", Severity::warning},
                      {FileRole::diffuse_alpha, "ASTC 8x8", Severity::off},
                      {FileRole::diffuse_alpha, "BC1", Severity::off},
                      {FileRole::f0_only, "BC1", Severity::warning},
                      {FileRole::normal, "BC1", Severity::warning},
                      {FileRole::normal, "BC5", Severity::off},
                      {FileRole::metal_rough, "BC3", Severity::warning},
                      {FileRole::metal_rough, "BC7", Severity::off}};
  const TempFolder folder;
  for (const Row& row : rows) {
    CAPTURE(static_cast<int>(row.role), row.format);
    const BlockFormat& format = *block_format_named(row.format);
    const BlockTexture texture = random_blocks(format, 48, 48, 3);
    const auto sides = static_cast<unsigned>((format.block_height - 1) << 8 | (format.block_width - 1));
    const bool astc = format.code == BlockCode::astc;
    const std::string path = folder.file(astc ? "x.ktx2" : "x.dds");
    spit(path,
         astc ? ktx2_of(texture, format.vk_srgb, block_descriptor(162, true, 16, {{0, 128, 0}}, sides), false)
              : dds_of(texture, "", format.dxgi));
    const CheckedFile file = checked(single(row.role, path, "x"));
    const Finding* const found = find(file, "ETK017");
    CHECK((found == nullptr ? Severity::off : found->severity) == row.told);
    CHECK(find(file, "ETK005") == nullptr);  // that is for JPEG and WebP
    if (found != nullptr) CHECK(found->value == row.format);
  }
}

TEST_CASE("a block with texels of two materials is told, at the first level where there is one") {
  const TempFolder folder;
  const BlockFormat& format = *block_format_named("BC7");
  spit(folder.file("x.dds"), dds_of(random_blocks(format, 48, 48, 3), "", format.dxgi));
  // The second tile begins on a block of level 0, and in the middle of one of level 1.
  CheckTarget target = single(FileRole::specular_gloss, folder.file("x.dds"), "x.dds");
  for (const auto& [name, x, width] : {std::tuple("stone", 0, 20), std::tuple("iron", 20, 28)}) {
    CheckTile tile;
    tile.name = name;
    tile.box = {x, 0, width, 48};
    target.manifest.tiles.push_back(tile);
  }
  CHECK(find(checked(target), "ETK018") == nullptr);
  target.manifest.mips = 1;
  const CheckedFile shared = checked(target);
  const Finding* found = find(shared, "ETK018");
  REQUIRE(found != nullptr);
  CHECK(found->tile == "stone");
  CHECK(contains(found->message, "on level 1"));
  CHECK(contains(found->message, "\"iron\""));
  // Parts of one material may share a block.
  for (CheckTile& tile : target.manifest.tiles) tile.island_of = "stone";
  CHECK(find(checked(target), "ETK018") == nullptr);
}
