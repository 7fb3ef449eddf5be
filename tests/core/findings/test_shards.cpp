// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/image/files/png.h"
#include "core/validate/files/cut_targets.h"
#include "core/validate/validate.h"
#include "tests/core/findings/shard_support.h"
#include "tests/core/image/png_of.h"
#include "tests/core/judge/corpus.h"
#include "tests/core/pages/json_schema.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

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
  out.inputs.paths = {folder.path()};
  out.config.root = folder.path();
  out.config.file = folder.file("etak.toml");
  out.memory.version = sharded_options.version;
  out.allowed.today = "2026-11-23";
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

std::vector<ReadShard> shards_of(const ValidationRequest& request, std::size_t count) {
  std::vector<ReadShard> out;
  for (std::size_t i = 1; i <= count; ++i) {
    ValidationRequest part = request;
    part.part.shard = Shard{i, count};
    part.run.threads = 1 + static_cast<unsigned>(i % 3);
    const std::string text = validation_json(validate(std::move(part)), sharded_options);
    out.push_back(read_shard(text, std::to_string(i) + ".json", sharded_options.version));
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
      request.allowed.known = baseline_of(validate(request));
      std::erase_if(request.allowed.known, [&](const KnownDefect&) { return random.below(2) == 0; });
    }
    const ValidationReport whole = validate(request);
    const auto forms = forms_of(whole, request.config.settings);
    ValidationRequest renewing = request;
    renewing.allowed.renew_known = true;
    const auto renewed = forms_of(validate(renewing), request.config.settings);
    for (std::size_t count = 1; count <= 7; ++count) {
      INFO("run " << run << ", " << count << " shards");
      auto shards = shards_of(request, count);
      std::ranges::reverse(shards);
      const ValidationReport merged = merged_report(shards, false);
      for (const ValidationPageFile& each :
           page_pictures(merged, request.config.settings, {}, most_page_pictures, 1))
        CHECK(each.pictures.empty());
      CHECK(merged.passed == whole.passed);
      CHECK(merged.incomplete == whole.incomplete);
      const auto again = forms_of(merged, shards.front().report.shard->settings);
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
  request.part.shard = Shard{2, 3};
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
  request.part.shard = Shard{1, 3};
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
  request.part.shard = Shard{1, 2};
  const auto shard_by = [&](const std::function<void(ValidationRequest&)>& change) {
    ValidationRequest other = request;
    change(other);
    return *validate(other).shard;
  };
  const ReportShard usual = shard_by([](ValidationRequest&) {});
  CHECK(shard_by([](ValidationRequest& r) { r.run.threads = 5; }).options == usual.options);
  CHECK(shard_by([](ValidationRequest& r) { r.allowed.today = "2030-01-01"; }).options == usual.options);
  const std::vector<std::function<void(ValidationRequest&)>> changes{
      [](ValidationRequest& r) { r.config.settings.profile = Profile::film; },
      [](ValidationRequest& r) { r.config.settings.fail_on = Severity::info; },
      [](ValidationRequest& r) {
        r.config.settings.allow.push_back({"ETK101", "", "", "", "why", ""});
      },
      [](ValidationRequest& r) { r.part.line_digest = "of other options"; }};
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

TEST_CASE("missing, doubled, mixed and overlapping shards are named") {
  using Items = std::pair<std::size_t, std::size_t>;
  const auto shard = [](const std::string& file, Shard says, std::size_t groups) {
    ReadShard out{file, one_shard({})};
    ReportShard changed_shard = *out.report.shard;
    changed_shard.shard = says;
    changed_shard.groups = groups;
    out.report.shard = std::make_shared<const ReportShard>(changed_shard);
    return out;
  };
  const auto with = [](ReadShard read, const std::function<void(ReportShard&)>& change) {
    ReportShard other = *read.report.shard;
    change(other);
    read.report.shard = std::make_shared<const ReportShard>(other);
    return read;
  };
  const auto why = [](std::vector<ReadShard> shards) {
    return error_of([&] { (void)merged_report(std::move(shards), false); });
  };
  const ReadShard one = shard("a", {1, 2, Items(0, 3)}, 5), two = shard("b", {2, 2, Items(3, 5)}, 5);
  CHECK(why({one, two}).empty());
  CHECK(why({two, one}).empty());
  CHECK(contains(why({two}), "etak merge: missing: shard 1/2"));
  CHECK(contains(why({one, two, two}), "b: is shard 2/2, as b is; expected each shard once"));
  CHECK(contains(why({one, shard("x", {2, 5, Items(3, 5)}, 5)}), "x: is shard 2/5"));
  CHECK(contains(why({one, with(two, [](ReportShard& s) { s.list = "c"; })}),
                 "b: was cut from another list of inputs than a"));
  CHECK(contains(why({one, with(two, [](ReportShard& s) { s.options = "c"; })}),
                 "b: was run with other options than a"));
  CHECK(contains(why({one, with(two, [](ReportShard& s) { s.allowances.resize(1); })}),
                 "b: was run with other options than a"));
  CHECK(contains(why({one, shard("b", {2, 2, Items(3, 6)}, 6)}), "b: was cut from another list"));
  for (const Items& items : {Items(4, 5), Items(3, 4), Items(2, 5)})
    CHECK(contains(why({one, shard("b", {2, 2, items}, 5)}), "b: holds other items"));
  const std::string many = why({shard("a", {1, 1000, Items(0, 5)}, 5)});
  CHECK(contains(many, "missing: shards 2/1000, 3/1000"));
  CHECK(contains(many, "and 979 more"));
}
