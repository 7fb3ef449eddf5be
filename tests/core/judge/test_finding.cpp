// SPDX-License-Identifier: Apache-2.0
#include "core/judge/finding.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/bytes/member_bytes.h"
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
