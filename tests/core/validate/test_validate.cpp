// SPDX-License-Identifier: Apache-2.0
#include "core/validate/validate.h"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <set>
#include <thread>

#include "core/image/files/png.h"
#include "core/image/image_io.h"
#include "core/pages/finding_pictures.h"
#include "core/validate/files/project_check.h"
#include "tests/core/image/png_of.h"
#include "tests/core/judge/corpus.h"
#include "tests/core/validate/checked.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

// Writes NAME_diff.png and NAME_spec.png, with F0 in the forbidden zone.
void write_pair(const TempFolder& folder, const std::string& name, std::uint64_t seed) {
  TextureSet set = natural_set(64, seed);
  Random random(seed);
  std::ranges::find(mutations(), "ETK101", &Mutation::rule)->inject(set, random);
  spit(folder.file(name + "_diff.png"), png_of(set.a));
  spit(folder.file(name + "_spec.png"), png_of(set.b));
}

ValidationRequest request_for(const TempFolder& folder) {
  ValidationRequest request;
  request.inputs.paths = {folder.path()};
  request.config.root = folder.path();
  request.memory.version = "test";
  return request;
}

std::vector<std::string> paths_of(const ValidationReport& report) {
  std::vector<std::string> out;
  for (const CheckedFile& file : report.files) out.push_back(file.path);
  return out;
}

std::vector<Finding> findings_of(const ValidationReport& report) {
  std::vector<Finding> out;
  for (const CheckedFile& file : report.files)
    out.insert(out.end(), file.findings.begin(), file.findings.end());
  return out;
}

const Finding* find_in_report(const ValidationReport& report, std::string_view rule) {
  for (const CheckedFile& file : report.files)
    for (const Finding& finding : file.findings)
      if (finding.rule == rule) return &finding;
  return nullptr;
}

}  // namespace

TEST_CASE("a folder is searched: pairs go together, what no rule is about and what is no file are told") {
  const TempFolder folder;
  std::filesystem::create_directory(folder.file("sub"));
  write_pair(folder, "crate", 1);
  write_pair(folder, "sub/wood", 2);
  spit(folder.file("notes.md"), "text");
  REQUIRE(::mkfifo(folder.file("pipe").c_str(), 0600) == 0);
  const ValidationReport report = validate(request_for(folder));
  CHECK(paths_of(report) == std::vector<std::string>{"crate_diff.png", "sub/wood_diff.png"});
  CHECK(report.files[0].companions == std::vector<std::string>{"crate_spec.png"});
  CHECK(report.files[1].roles[1] == RoleOfFile{"sub/wood_spec.png", "specular"});
  CHECK(report.run.files == 5);
  CHECK(report.run.skipped == 1);
  CHECK(report.run.checks == 2);
  CHECK(report.run.failed == 0);
  CHECK(report.not_opened == std::vector<std::string>{folder.file("pipe")});
  CHECK(find_in_report(report, "ETK101") != nullptr);
  CHECK(!report.passed);
  CHECK(!report.incomplete);
  CHECK(report.settings_hash == settings_hash({}));
  for (const CheckedFile& file : report.files) {
    REQUIRE(file.target != nullptr);
    CHECK(file.target->files.size() == 2);
    CHECK(file.sha256.empty());
  }
}

TEST_CASE("what was named and cannot be checked makes a report incomplete") {
  const TempFolder folder;
  ValidationRequest request = request_for(folder);
  request.inputs.paths = {folder.file("absent.png")};
  const ValidationReport report = validate(request);
  CHECK(report.run.failed == 1);
  CHECK(report.incomplete);
  REQUIRE(find_in_report(report, "ETK001") != nullptr);
  CHECK(find_in_report(report, "ETK001")->file == "absent.png");
}

TEST_CASE("hashes are those of the files, where they are asked for") {
  const TempFolder folder;
  write_pair(folder, "crate", 1);
  ValidationRequest request = request_for(folder);
  request.hashes = true;
  CHECK(validate(request).files.at(0).sha256.size() == 64);
}

TEST_CASE("the decoder is asked for what is no plain PNG, and without one that is a finding") {
  const TempFolder folder;
  write_pair(folder, "crate", 1);
  int asked = 0;
  ValidationRequest request = request_for(folder);
  request.run.door.file = [&](const std::string&) {
    ++asked;
    const Image8 pixels(64, 64, 4, 90);
    Picture out{header_of(pixels), pixels};
    out.header.format = "tiff";
    return out;
  };
  CHECK(find_in_report(validate(request), "ETK001") == nullptr);
  CHECK(asked == 0);
  spit(folder.file("other_spec.tif"), "II*");
  CHECK(find_in_report(validate(request), "ETK001") == nullptr);
  CHECK(asked > 0);
  request.run.door = {};
  const ValidationReport report = validate(request);
  REQUIRE(find_in_report(report, "ETK001") != nullptr);
  CHECK(contains(find_in_report(report, "ETK001")->message, "needs a decoder of pictures"));
}

TEST_CASE("results are taken from the cache, but not those of other settings, versions and keys") {
  const TempFolder folder, cache;
  for (int i = 0; i < 3; ++i) write_pair(folder, "m" + std::to_string(i), static_cast<std::uint64_t>(i));
  ValidationRequest request = request_for(folder);
  const ValidationReport fresh = validate(request);
  request.memory.cache.path = cache.file("results");
  CHECK(validate(request).run.from_cache == 0);
  const ValidationReport again = validate(request);
  CHECK(again.run.from_cache == 3);
  CHECK(findings_of(again) == findings_of(fresh));
  CHECK(again.files[0].target != nullptr);
  write_pair(folder, "m1", 9);
  CHECK(validate(request).run.from_cache == 2);
  for (auto change : std::vector<std::function<void(ValidationRequest&)>>{
           [](ValidationRequest& r) { r.memory.version = "other"; },
           [](ValidationRequest& r) { r.memory.cache.key = "0123456789abcdef"; },
           [](ValidationRequest& r) { r.config.settings.profile = Profile::strict; }}) {
    ValidationRequest other = request;
    change(other);
    CHECK(validate(other).run.from_cache == 0);
  }
}

TEST_CASE("progress is told by the caller's thread, rises, and ends with all checks") {
  const TempFolder folder;
  for (int i = 0; i < 6; ++i) write_pair(folder, "m" + std::to_string(i), static_cast<std::uint64_t>(i));
  for (const unsigned threads : {1u, 3u}) {
    ValidationRequest request = request_for(folder);
    request.run.threads = threads;
    std::vector<std::size_t> told;
    std::set<std::thread::id> tellers;
    request.run.progress = [&](std::size_t done, std::size_t all) {
      CHECK(all == 6);
      told.push_back(done);
      tellers.insert(std::this_thread::get_id());
    };
    (void)validate(request);
    REQUIRE(!told.empty());
    CHECK(std::is_sorted(told.begin(), told.end()));
    CHECK(told.back() == 6);
    CHECK(tellers == std::set{std::this_thread::get_id()});
  }
}

TEST_CASE("a check that is stopped says so and holds what was done") {
  const TempFolder folder;
  for (int i = 0; i < 4; ++i) write_pair(folder, "m" + std::to_string(i), static_cast<std::uint64_t>(i));
  ValidationRequest request = request_for(folder);
  int asked = 0;
  request.run.stop = [&] { return ++asked > 2; };
  const ValidationReport report = validate(request);
  CHECK(paths_of(report) == std::vector<std::string>{"m0_diff.png", "m1_diff.png"});
  CHECK(report.stopped);
  CHECK(report.incomplete);
  CHECK(!report.passed);
}

TEST_CASE("what is known and what is allowed is marked and does not count") {
  const TempFolder folder;
  write_pair(folder, "crate", 1);
  ValidationRequest request = request_for(folder);
  const ValidationReport fresh = validate(request);
  REQUIRE(fresh.errors > 0);
  request.allowed.renew_known = true;
  CHECK(validate(request).passed);
  request.allowed.renew_known = false;
  request.allowed.known = baseline_of(fresh);
  CHECK(validate(request).errors == 0);
  request.allowed.known.clear();
  request.config.settings.allow = {{"ETK1", "", "", "", "made up", "2020-01-01"}};
  request.allowed.today = "2019-12-31";
  CHECK(find_in_report(validate(request), "ETK101")->suppressed);
  request.allowed.today = "2020-01-02";
  CHECK(!find_in_report(validate(request), "ETK101")->suppressed);
}

TEST_CASE("materials of a project are checked by the same door, in the order of their names") {
  ValidationRequest request;
  ProjectMaterial zone, plain;
  zone.name = "impossible";
  zone.specular = {0.3, 0.3, 0.3};
  plain.name = "clean";
  plain.diffuse = {0.3, 0.2, 0.1};
  request.inputs.materials.materials = {zone, plain};
  request.inputs.materials.library = std::make_shared<const MaterialLibrary>(MaterialLibrary::builtin());
  const ValidationReport report = validate(request);
  CHECK(paths_of(report) == std::vector<std::string>{"clean", "impossible"});
  REQUIRE(find_in_report(report, "ETK101") != nullptr);
  CHECK(find_in_report(report, "ETK101")->material == "impossible");
}

TEST_CASE("every finding with a place gets a mask") {
  const TempFolder folder;
  write_pair(folder, "crate", 1);
  const ValidationReport report = validate(request_for(folder));
  REQUIRE(find_in_report(report, "ETK101") != nullptr);
  const std::string masks_folder = folder.file("masks");
  masks(report, {}, {}, masks_folder, 1)->commit();
  CHECK(std::filesystem::exists(masks_folder + "/crate_spec.png.ETK101.png"));
}

TEST_CASE("the colour of layers is a note that names them, and the same colour typed is an error") {
  const MaterialLibrary library = MaterialLibrary::builtin();
  const PictureDoor door = picture_door();
  ProjectMaterial layers;
  layers.name = "blue";
  layers.measured = MeasuredF0{"anodised_titanium_50nm", {}, {}, {}};
  layers.specular = {0.027071, 0.17335, 0.46205};
  layers.diffuse = {0, 0, 0};
  layers.alpha_mode = AlphaMode::opaque;
  const CheckedFile noted = check_material(layers, {library, door, {}});
  CHECK(!noted.findings.empty());
  for (const Finding& each : noted.findings) {
    INFO(each.rule << ' ' << each.message);
    CHECK(each.severity == Severity::info);
    if (each.rule == "ETK106") CHECK(contains(each.message, "titania_amorphous:50nm/titanium"));
  }
  layers.measured.reset();
  bool is_error = false;
  for (const Finding& each : check_material(layers, {library, door, {}}).findings)
    is_error = is_error || (each.rule == "ETK106" && each.severity == Severity::error);
  CHECK(is_error);
}
