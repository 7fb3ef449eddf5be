// SPDX-License-Identifier: Apache-2.0
#include "core/validate/find/find_targets.h"

#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "core/validate/find/listing.h"
#include "core/validate/validate.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

// Pictures are told by their names here, and no one is opened.
void make(const TempFolder& folder, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    std::filesystem::create_directories(std::filesystem::path(folder.file(name)).parent_path());
    spit(folder.file(name), "");
  }
}

FoundTargets found_in(const TempFolder& folder, std::vector<std::string> paths, unsigned threads = 1) {
  ValidationRequest request;
  request.inputs.paths = std::move(paths);
  request.config.root = folder.path();
  request.run.threads = threads;
  request.list_files = true;
  return find_targets(request);
}

std::vector<std::string> files_of(const FoundTarget& found) {
  std::vector<std::string> out;
  for (const TargetFile& file : found.target.files) out.push_back(file.label);
  return out;
}

std::vector<std::vector<std::string>> sets_of_run(const FoundTargets& found) {
  std::vector<std::vector<std::string>> out;
  for (const FoundTarget& target : found.targets) out.push_back(files_of(target));
  return out;
}

// All that a run tells of its files.
std::string told(const FoundTargets& found) {
  std::string out = file_list_json(found.listing);
  for (const FoundTarget& target : found.targets) {
    out += target.target.label + ' ' + target.target.udim + ' ' + target.target.tile;
    for (const std::string& path : target.depends) out += ' ' + path;
    out += '\n';
  }
  for (const CheckedFile& file : found.lone) out += "lone " + file.path + ' ' + file.findings[0].value + '\n';
  for (const std::string& name : found.unknown) out += "unknown " + name + '\n';
  return out + std::to_string(found.files) + ' ' + std::to_string(found.skipped);
}

}  // namespace

TEST_CASE("a hidden companion is found beside a picture, though a search leaves it out") {
  const TempFolder folder;
  make(folder, {"a/diffuse.png", "a/.specular.png", "b/diffuse.png", "b/specular.png"});
  const FoundTargets found = found_in(folder, {folder.path()});
  CHECK(sets_of_run(found) == std::vector<std::vector<std::string>>{{"a/diffuse.png", "a/.specular.png"},
                                                                    {"b/diffuse.png", "b/specular.png"}});
  CHECK(found.files == 3);
}

TEST_CASE("a picture that is named takes its companion along, also beside a folder that is searched") {
  const TempFolder folder;
  make(folder,
       {"a/crate_diff.png", "a/crate_spec.png", "a/other_diff.png", "b/wood_diff.png", "b/wood_spec.png"});
  CHECK(sets_of_run(found_in(folder, {folder.file("a/crate_spec.png"), folder.file("b")})) ==
        std::vector<std::vector<std::string>>{{"a/crate_diff.png", "a/crate_spec.png"},
                                              {"b/wood_diff.png", "b/wood_spec.png"}});
}

TEST_CASE("only what a search has seen to be a file counts as seen") {
  const TempFolder folder;
  make(folder, {"a/crate_diff.png", "a/crate_spec.png", "b/wood_diff.png", "far/wood_spec.png"});
  REQUIRE(::symlink("../far/wood_spec.png", folder.file("b/wood_spec.png").c_str()) == 0);
  const FoundTargets searched = found_in(folder, {folder.file("a")});
  REQUIRE(searched.targets.size() == 1);
  CHECK(searched.targets[0].plain);
  const FoundTargets named = found_in(folder, {folder.file("a/crate_diff.png")});
  REQUIRE(named.targets.size() == 1);
  CHECK(!named.targets[0].plain);
  const FoundTargets linked = found_in(folder, {folder.path()});
  for (const FoundTarget& found : linked.targets) CHECK(found.plain == !found.target.label.starts_with("b/"));
}

TEST_CASE("any number of threads finds the same in a large folder with a bit of everything") {
  const TempFolder folder;
  std::vector<std::string> names;
  for (int i = 0; i < 700; ++i) {
    const std::string stem = "f" + std::to_string(i % 7) + "/m" + std::to_string(i);
    names.push_back(stem + "_diff.png");
    if (i % 5 != 0) names.push_back(stem + "_spec.png");
    if (i % 11 == 0) names.push_back(stem + "_photo.png");          // no role
    if (i % 13 == 0) names.push_back(stem + "_normal.png");         // maps are a set of their own
    if (i % 17 == 0) names.push_back(stem + ".1001_f0.png");        // a number alone is no tile
    if (i % 19 == 0) names.push_back(stem + "_roughness.png");      // "diffuse" is then a base colour
    if (i % 23 == 0) names.push_back(stem + "part_roughness.png");  // lone
  }
  for (const char* tile : {"1001", "1002", "1011"})
    for (const char* role : {"diff", "spec"})
      names.push_back("f3/wall_" + std::string(role) + "." + tile + ".png");
  make(folder, names);
  const FoundTargets one = found_in(folder, {folder.path()}, 1);
  CHECK(one.files == names.size());
  CHECK(one.targets.size() > 500);
  CHECK(!one.lone.empty());
  CHECK(!one.unknown.empty());
  const std::string expected = told(one);
  for (const unsigned threads : {2u, 5u}) CHECK(told(found_in(folder, {folder.path()}, threads)) == expected);
  // The same files by their names, of which the folders are listed once more.
  std::vector<std::string> paths;
  for (const std::string& name : names) paths.push_back(folder.file(name));
  std::ranges::reverse(paths);
  ValidationRequest request;
  request.inputs.listed = std::move(paths);
  request.config.root = folder.path();
  request.list_files = true;
  CHECK(told(find_targets(request)) == expected);
}
