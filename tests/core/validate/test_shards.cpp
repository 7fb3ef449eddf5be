// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/image/files/png.h"
#include "core/pages/finding_pictures.h"
#include "core/validate/files/cut_targets.h"
#include "core/validate/output/formats.h"
#include "core/validate/shards/report_shard.h"
#include "core/validate/validate.h"
#include "tests/core/image/png_of.h"
#include "tests/core/pages/json_schema.h"
#include "tests/core/validate/corpus.h"
#include "tests/core/validate/sample_report.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

const OutputOptions sharded_options{Severity::error, "1.2.3"};

// A folder of sets of every kind, whose names, sizes and defects follow from the seed.
void write_store(const TempFolder& folder, Random& random) {
  const std::vector<std::string> folders{"", "props/", "walls/old/", "A b/", "zz/"};
  for (const std::string& each : folders) std::filesystem::create_directories(folder.file(each));
  const auto defects = mutations();
  const int sets = random.below(24);
  for (int i = 0; i < sets; ++i) {
    const std::string stem =
        folders[static_cast<std::size_t>(random.below(5))] + "set" + std::to_string(random.below(40));
    TextureSet set = natural_set(64, random.next());
    if (random.below(3) > 0) std::ranges::find(defects, "ETK101", &Mutation::rule)->inject(set, random);
    std::string a = "_diff.png", b = "_spec.png";
    if (random.below(5) == 0) {
      // Tiles of a UDIM set.
      for (const char* tile : {".1001", ".1002", ".1011"}) {
        spit(folder.file(stem + "_diff" + tile + ".png"), png_of(set.a));
        spit(folder.file(stem + "_spec" + tile + ".png"), png_of(set.b));
      }
      continue;
    }
    spit(folder.file(stem + a), png_of(set.a));
    std::string bytes = png_of(set.b);
    if (random.below(8) == 0) bytes.resize(bytes.size() / 2);
    if (random.below(6) > 0) spit(folder.file(stem + b), bytes);
    if (random.below(4) == 0) spit(folder.file(stem + "_normal.png"), png_of(set.b));
    if (random.below(6) == 0) spit(folder.file(stem + "_palette.png"), png_of(set.a));
  }
  if (random.below(2) == 0) spit(folder.file("broken.json"), "{ \"id\": \"x\", \"datasets\": [] }");
  spit(folder.file("notes.md"), "text");
}

ValidationRequest store_request(const TempFolder& folder, Random& random) {
  ValidationRequest out;
  out.paths = {folder.path()};
  out.config.root = folder.path();
  out.config.file = folder.file("etak.toml");
  out.version = sharded_options.version;
  out.today = "2026-11-23";
  out.hashes = true;
  out.must_check = random.below(2) == 0;
  Settings& settings = out.config.settings;
  settings.profile = random.below(2) == 0 ? Profile::standard : Profile::strict;
  if (random.below(2) == 0) {
    settings.allow.push_back({"ETK101", "set1*_spec.png", "", "", "a sensor", ""});
    settings.allow.push_back({"ETK2", "props/**", "", "", "of old", "2026-01-01"});
    settings.allow.push_back({"ETK302", "", "", "", "as it is", "2027-01-01"});
    settings.allow.push_back({"ETK5", "gone/**", "", "", "not there any more", ""});
  }
  return out;
}

// Every form of the report, one behind the other.
std::vector<std::string> forms_of(const ValidationReport& report, const Settings& settings) {
  std::vector<std::string> out{validation_json(report, sharded_options),
                               validation_sarif(report, sharded_options),
                               validation_junit(report, sharded_options),
                               validation_csv(report),
                               validation_github(report),
                               validation_text(report),
                               baseline_json(baseline_of(report))};
  const auto pictures = page_pictures(report, settings, {}, most_files_with_pictures, 1);
  out.push_back(validation_page(report, pictures, {sharded_options.version, settings}));
  return out;
}

std::vector<ValidationReport> shards_of(const ValidationRequest& request, std::size_t count) {
  std::vector<ValidationReport> out;
  for (std::size_t i = 1; i <= count; ++i) {
    ValidationRequest part = request;
    part.shard = Shard{i, count};
    part.threads = 1 + static_cast<unsigned>(i % 3);
    const std::string text = validation_json(validate(std::move(part)), sharded_options);
    ReadShard read = read_shard(text, "shard.json");
    CHECK(read.version == sharded_options.version);
    out.push_back(std::move(read.report));
  }
  return out;
}

}  // namespace

TEST_CASE("the merge of any number of shards is the run of all, in every form") {
  Random random(11);
  for (int run = 0; run < 10; ++run) {
    const TempFolder folder;
    write_store(folder, random);
    ValidationRequest request = store_request(folder, random);
    if (random.below(2) == 0) {
      request.known = baseline_of(validate(request));
      std::erase_if(request.known, [&](const KnownDefect&) { return random.below(2) == 0; });
    }
    const ValidationReport whole = validate(request);
    const auto forms = forms_of(whole, request.config.settings);
    ValidationRequest renewing = request;
    renewing.renew_known = true;
    const auto renewed = forms_of(validate(renewing), request.config.settings);
    for (std::size_t count = 1; count <= 7; ++count) {
      INFO("run " << run << ", " << count << " shards");
      const auto shards = shards_of(request, count);
      const ValidationReport merged = merged_report(shards, false);
      CHECK(merged.passed == whole.passed);
      CHECK(merged.incomplete == whole.incomplete);
      const auto again = forms_of(merged, shards.front().shard->settings);
      for (std::size_t f = 0; f < forms.size(); ++f) {
        INFO("form " << f);
        CHECK((again[f] == forms[f]));
      }
      CHECK((forms_of(merged_report(shards, true), request.config.settings) == renewed));
    }
  }
}

TEST_CASE("a shard says which it is in every form, and its JSON fits the schema") {
  const TempFolder folder;
  Random random(5);
  for (int i = 0; i < 4; ++i) write_store(folder, random);
  ValidationRequest request = store_request(folder, random);
  request.shard = Shard{2, 3};
  const ValidationReport report = validate(request);
  REQUIRE(!report.files.empty());
  const auto json = nlohmann::json::parse(validation_json(report, sharded_options));
  const JsonSchema schema(
      nlohmann::json::parse(slurp(source_folder() + "/resources/schema/validation.schema.json")));
  CHECK(schema.problem(json) == "");
  CHECK(json["shard"]["index"] == 2);
  CHECK(contains(validation_sarif(report, sharded_options), "\"shard\": \"2/3\""));
  CHECK(contains(validation_junit(report, sharded_options), "name=\"etak validate, shard 2/3\""));
  CHECK(contains(validation_csv(report), ",2/3\r\n"));
  CHECK(contains(validation_text(report), "shard 2/3: "));
  CHECK(contains(validation_github(report), "shard 2/3: "));
  request.shard = Shard{1, 3};
  const auto first = nlohmann::json::parse(validation_json(validate(request), sharded_options));
  CHECK(schema.problem(first) == "");
  CHECK(first["shard"]["list"] == json["shard"]["list"]);
  CHECK(first["shard"]["options"] == json["shard"]["options"]);
}

TEST_CASE("what decides the result changes the digests of a shard, and nothing else does") {
  const TempFolder folder;
  Random random(7);
  for (int i = 0; i < 3; ++i) write_store(folder, random);
  ValidationRequest request = store_request(folder, random);
  request.config.settings.allow.clear();
  request.shard = Shard{1, 2};
  const auto shard_by = [&](const std::function<void(ValidationRequest&)>& change) {
    ValidationRequest other = request;
    change(other);
    return *validate(other).shard;
  };
  const ReportShard usual = shard_by([](ValidationRequest&) {});
  CHECK(shard_by([](ValidationRequest& r) { r.threads = 5; }).options == usual.options);
  CHECK(shard_by([](ValidationRequest& r) { r.today = "2030-01-01"; }).options == usual.options);
  const std::vector<std::function<void(ValidationRequest&)>> changes{
      [](ValidationRequest& r) { r.config.settings.profile = Profile::film; },
      [](ValidationRequest& r) { r.config.settings.fail_on = Severity::info; },
      [](ValidationRequest& r) {
        r.config.settings.allow.push_back({"ETK101", "", "", "", "why", ""});
      },
      [](ValidationRequest& r) {
        r.known.push_back({"ETK101", "a.png", "", "", "", {}});
      },
      [](ValidationRequest& r) { r.role = FileRole::f0_only; },
      [](ValidationRequest& r) { r.manifest.material = "gold"; },
      [](ValidationRequest& r) { r.verdict.max_warnings = 3; },
      [](ValidationRequest& r) { r.verdict.never_fails = true; }};
  for (const auto& change : changes) CHECK(shard_by(change).options != usual.options);
  CHECK(shard_by([](ValidationRequest&) {}).list == usual.list);
  spit(folder.file("new_diff.png"), "x");
  CHECK(shard_by([](ValidationRequest&) {}).list != usual.list);
}

TEST_CASE(
    "tiles of a set, pages of a layout and maps of a material are one group; shared textures join none") {
  FoundTargets found;
  const auto add = [&](FileRole role, const std::string& path,
                       std::vector<std::string> depends) -> CheckTarget& {
    FoundTarget& each = found.targets.emplace_back();
    each.target.label = path;
    each.target.files = {{role, path, path}};
    each.depends = std::move(depends);
    return each.target;
  };
  add(FileRole::specular_gloss, "atlas/a.png", {"atlas/layout.json", "atlas/a.png"}).manifest.scene =
      "atlas/scene.gltf";
  add(FileRole::specular_gloss, "atlas/b.png", {"atlas/layout.json", "atlas/b.png"});
  add(FileRole::scene, "atlas/scene.gltf", {"atlas/scene.gltf", "noise.png"});
  add(FileRole::scene, "chair.gltf", {"chair.gltf", "noise.png"});
  add(FileRole::diffuse_alpha, "wood_diff.png", {"wood_diff.png", "wood_spec.png"});
  add(FileRole::normal, "wood_normal.png", {"wood_normal.png", "wood_spec.png"});
  add(FileRole::diffuse_alpha, "x.1001.png", {"x.1001.png"}).udim = "x.<UDIM>.png";
  add(FileRole::diffuse_alpha, "x.1002.png", {"x.1002.png"}).udim = "x.<UDIM>.png";
  found.lone.emplace_back().path = "lone.png";
  found.failed.emplace_back().path = "failed.png";
  const auto groups = groups_of(found, 1);
  std::vector<std::vector<std::size_t>> targets;
  for (const TargetGroup& group : groups) targets.push_back(group.targets);
  CHECK(targets == std::vector<std::vector<std::size_t>>{{0, 1, 2}, {3}, {4, 5}, {6, 7}, {}, {}});
  CHECK(groups[4].lone == std::vector<std::size_t>{0});
  CHECK(groups[5].failed == std::vector<std::size_t>{0});
}

TEST_CASE("numbers that JSON has no form of survive the way through a shard") {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  Finding odd = finding("ETK007", "a.exr", Severity::error, PixelBox{1, 2, 3, 4});
  odd.linear = {nan, -inf, 0.1 + 0.2};
  odd.luminance = inf;
  odd.nearest = {{"gold", "johnson-1972", 1.0 / 3}};
  odd.islands = {{"left", PixelBox{0, 0, 1, 1}, 1, UvBox{0, 0.1, 1, 1}}, {"right", {}, 2, {}}};
  odd.uv = UvBox{0.3, 0, 1, 1};
  ValidationReport report = report_of({checked_file("a.exr", {odd})}, {});
  report.files[0].counts = {{"zebra", 1}, {"apple", -2}};
  report.shard = std::make_shared<const ReportShard>(ReportShard{{1, 1}, "l", "o", 1, {}, {}, {}, {}});
  const ValidationReport again = read_shard(validation_json(report, sharded_options), "s").report;
  REQUIRE(again.files.size() == 1);
  CHECK(again.files[0].counts == report.files[0].counts);
  const Finding& back = again.files[0].findings[0];
  CHECK(std::isnan((*back.linear)[0]));
  CHECK((*back.linear)[1] == -inf);
  CHECK((*back.linear)[2] == 0.1 + 0.2);
  CHECK(*back.luminance == inf);
  CHECK(back.islands == odd.islands);
  CHECK(back.uv == odd.uv);
  CHECK(back.nearest == odd.nearest);
  report.shard = nullptr;
  CHECK(validation_csv(merged_report({again}, false)) == validation_csv(report));
}

TEST_CASE("a shard that is cut off, changed or of another kind is refused with its name") {
  ValidationReport report = report_of({checked_file("a.png")}, {});
  report.shard = std::make_shared<const ReportShard>(ReportShard{{1, 2}, "l", "o", 1, {}, {}, {}, {}});
  const std::string text = validation_json(report, sharded_options);
  REQUIRE(error_of([&] { read_shard(text, "s.json"); }).empty());
  for (std::size_t end = 0; end + 2 < text.size(); end += 7) {
    const std::string why = error_of([&] { read_shard(text.substr(0, end), "s.json"); });
    CHECK(contains(why, "s.json: is no whole JSON document"));
  }
  report.shard = nullptr;
  CHECK(contains(error_of([&] { read_shard(validation_json(report, sharded_options), "s.json"); }),
                 "has no right value of \"shard\""));
  std::string changed = text;
  changed.replace(changed.find("\"index\": 1"), 10, "\"index\": 9");
  CHECK(contains(error_of([&] { read_shard(changed, "s.json"); }), "no right value of \"index\""));
}

TEST_CASE("a name that JSON cannot hold is refused in a shard, not changed in silence") {
  ValidationReport report = report_of({checked_file("a\xff.png")}, {});
  report.shard = std::make_shared<const ReportShard>(ReportShard{{1, 2}, "l", "o", 1, {}, {}, {}, {}});
  CHECK(contains(error_of([&] { validation_json(report, sharded_options); }), "no UTF-8"));
}
