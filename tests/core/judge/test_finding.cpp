// SPDX-License-Identifier: Apache-2.0
#include "core/judge/finding.h"

#include <catch2/catch.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/bytes/member_bytes.h"
#include "core/judge/deciding_members.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

using Names = std::set<std::string>;

// The names of the members of a value; those of an inner object begin with the name of that.
struct MemberNames {
  std::string begin;
  Names names;

  template <class Value>
  void member(const char* name, const Value&, Said = Said::always) {
    names.insert(begin + name);
  }
  template <class Act>
  void object(const char* name, bool, Act act) {
    MemberNames inner{begin + name + '/', {begin + name}};
    act(inner);
    names.merge(inner.names);
  }
};

template <class Value>
Names names_of(const Value& value) {
  MemberNames out;
  members(out, value);
  return out.names;
}

Names names_in_schema(const nlohmann::json& object, const std::string& begin = "") {
  Names out;
  for (const auto& [name, inner] : object.at("properties").items()) {
    out.insert(begin + name);
    if (inner.contains("properties")) out.merge(names_in_schema(inner, begin + name + '/'));
  }
  return out;
}

}  // namespace

TEST_CASE("the schema of a validation has the members of findings and files, and no others") {
  const auto schema =
      nlohmann::json::parse(slurp(source_folder() + "/resources/schema/validation.schema.json"));
  const auto& parts = schema.at("$defs");
  CHECK(names_of(Finding{}) == names_in_schema(parts.at("finding")));
  CHECK(names_of(CheckedFile{}) == names_in_schema(parts.at("file")));
  CHECK(names_of(FindingIsland{}) ==
        names_in_schema(parts.at("finding").at("properties").at("islands").at("items")));
  CHECK(names_of(NearestMaterial{}) ==
        names_in_schema(parts.at("finding").at("properties").at("nearest").at("items")));
}

TEST_CASE("a file with its findings comes back from its bytes as it was, and from no part of them") {
  CheckedFile file;
  file.path = "a.png";
  file.roles = {{"a.png", "specular"}};
  file.counts = {{"texels", -1}};
  file.is_set = true;
  Finding& finding = file.findings.emplace_back();
  finding.rule = "ETK101";
  finding.severity = Severity::error;
  finding.islands = {{"left", PixelBox{1, 2, 3, 4}, 5, UvBox{0, 0.25, 0.5, 1}}};
  finding.linear = {0.1, 0.2, 0.3};
  finding.nearest = {{"gold", "johnson-1972", 1.0 / 3}};
  finding.suppression = "seen";
  MemberWriter out;
  out.member(file);
  const auto read = [](std::string_view bytes, CheckedFile& to) {
    MemberReader in(bytes);
    in.member(to);
    return in.good();
  };
  CheckedFile back;
  REQUIRE(read(out.bytes, back));
  CHECK(back.findings == file.findings);
  CHECK(back.roles == file.roles);
  CHECK(back.counts == file.counts);
  CHECK(back.is_set);
  for (std::size_t size = 0; size < out.bytes.size(); ++size) {
    CheckedFile part;
    CHECK_FALSE(read(std::string_view(out.bytes).substr(0, size), part));
  }
}

TEST_CASE(
    "every member of a target and of settings counts among what decides results, but for places of files") {
  const auto bytes_of = [](const auto& value) {
    MemberWriter out;
    out.member(value);
    return out.bytes;
  };
  CheckTarget target;
  target.files = {{FileRole::normal, "/a/wood.png", "wood.png"}};
  target.manifest.tiles.resize(1);
  target.manifest.scene = "/a/scene.gltf";
  const std::string usual = bytes_of(target);
  const std::vector<std::function<void(CheckTarget&)>> changes{
      [](CheckTarget& t) { t.label = "x"; },
      [](CheckTarget& t) { t.files[0].role = FileRole::height; },
      [](CheckTarget& t) { t.files[0].label = "x"; },
      [](CheckTarget& t) { t.files[0].guessed = true; },
      [](CheckTarget& t) { t.files[0].channels = "m"; },
      [](CheckTarget& t) { t.files[0].green = GreenAxis::directx; },
      [](CheckTarget& t) { t.beside = t.files; },
      [](CheckTarget& t) { t.tile = "1001"; },
      [](CheckTarget& t) { t.manifest.scene.clear(); },
      [](CheckTarget& t) { t.manifest.layout_alone = true; },
      [](CheckTarget& t) { t.manifest.specular_weighs_diffuse = true; },
      [](CheckTarget& t) { t.manifest.parts.resize(1); },
      [](CheckTarget& t) {
        t.manifest.tiles[0].flat[1] = {1, 2, 3, 4};
      },
      [](CheckTarget& t) { t.manifest.tiles[0].own_around = 1; }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    CheckTarget other = target;
    changes[i](other);
    INFO(i);
    CHECK(bytes_of(other) != usual);
  }
  CheckTarget moved = target;
  moved.files[0].path = "/b/wood.png";
  moved.manifest.scene = "/b/scene.gltf";
  CHECK(bytes_of(moved) == usual);

  const std::string standard = bytes_of(Settings{});
  const std::vector<std::function<void(Settings&)>> turns{
      [](Settings& s) { s.profile = Profile::film; },
      [](Settings& s) { s.green = GreenAxis::opengl; },
      [](Settings& s) { s.fail_on = Severity::info; },
      [](Settings& s) { s.rules["ETK101"].parameters["limit"] = 1; },
      [](Settings& s) { s.zone.erode = 5; },
      [](Settings& s) {
        s.allow.push_back({"ETK101", "", "", "", "why", ""});
      }};
  for (std::size_t i = 0; i < turns.size(); ++i) {
    Settings other;
    turns[i](other);
    INFO(i);
    CHECK(bytes_of(other) != standard);
  }
}
