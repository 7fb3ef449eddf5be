// SPDX-License-Identifier: Apache-2.0
// Documents of shards: what is read back from them, and what is refused.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/hash/sha256.h"
#include "tests/core/findings/sample_report.h"
#include "tests/core/findings/shard_support.h"
#include "tests/core/pages/json_schema.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

ReadShard read_again(const std::string& text) {
  return read_shard(text, "s.json", sharded_options.version);
}

// The text with its own SHA-256, as somebody who changes it can give it.
std::string sealed_again(std::string text) {
  const std::string seal = "\"sha256\": \"";
  const std::size_t at = text.find(seal) + seal.size();
  text.replace(at, 64, std::string(64, '0'));
  return text.replace(at, 64, sha256(text));
}

// A document of many members, of a finding that has all of them.
std::string full_document() {
  Finding full = finding("ETK007", "a.exr", Severity::error, PixelBox{1, 2, 3, 4});
  full.linear = {0.5, 0.25, 0.1 + 0.2};
  full.byte = {1, 2, 3};
  full.luminance = 0.5;
  full.nearest = {{"gold", "johnson-1972", 1.0 / 3}};
  full.islands = {{"left", PixelBox{0, 0, 1, 1}, 1, UvBox{0, 0.1, 1, 1}}, {"right", {}, 2, {}}};
  full.uv = UvBox{0.3, 0, 1, 1};
  CheckedFile file = checked_file("a.exr", {full});
  file.companions = {"b.exr"};
  file.sha256 = std::string(64, 'b');
  file.counts = {{"texels", 16}, {"opaque_px", 3}, {"gloss_min", 2}};
  return validation_json(one_shard({file, checked_file("clean.png")}), sharded_options);
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != text.npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("numbers that JSON has no form of survive the way through a shard") {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  Finding odd = finding("ETK007", "a.exr", Severity::error, PixelBox{1, 2, 3, 4});
  odd.linear = {std::copysign(nan, -1.0), -inf, 0.1 + 0.2};
  odd.luminance = inf;
  ValidationReport report = one_shard({checked_file("a.exr", {odd})});
  report.files[0].counts = {{"texels", 1}, {"gloss_min", 0}};
  const ReadShard again = read_again(validation_json(report, sharded_options));
  REQUIRE(again.report.files.size() == 1);
  CHECK(again.report.files[0].counts == report.files[0].counts);
  const Finding& back = again.report.files[0].findings[0];
  CHECK(std::isnan((*back.linear)[0]));
  CHECK((*back.linear)[1] == -inf);
  CHECK((*back.linear)[2] == 0.1 + 0.2);
  CHECK(*back.luminance == inf);
  report.shard = nullptr;
  CHECK(validation_csv(merged_report({again}, false)) == validation_csv(report));
}

TEST_CASE("what a shard says comes back whole") {
  const std::string text = full_document();
  const ReadShard read = read_again(text);
  CHECK(validation_json(read.report, sharded_options) == text);
  const auto json = nlohmann::json::parse(text);
  const JsonSchema schema(
      nlohmann::json::parse(slurp(source_folder() + "/resources/schema/validation.schema.json")));
  CHECK(schema.problem(json) == "");
}

TEST_CASE("every damage of a shard is refused with its file and the place") {
  const std::string text = full_document();
  const auto why = [](const std::string& damaged) { return error_of([&] { (void)read_again(damaged); }); };
  REQUIRE(why(text).empty());
  const auto check = [&](const std::string& damaged) {
    const std::string said = why(damaged);
    INFO(said);
    CHECK((said.starts_with("s.json:") || said.starts_with("s.json#/")));
    CHECK(!contains(said, "json.exception"));
    CHECK(!contains(said, "syntax error"));
  };
  for (std::size_t end = 0; end < text.size(); end += 7) check(text.substr(0, end));
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t next = text.find('\n', at) + 1;
    check(text.substr(0, at) + text.substr(next));  // a line deleted
    check(text.substr(0, next) + text.substr(at));  // and doubled
    at = next;
  }
  for (std::size_t at = 0; at < text.size(); at += 5) {
    std::string zeros = text;
    zeros.replace(at, 16, std::min<std::size_t>(16, text.size() - at), '\0');
    check(zeros);
    std::string other = text;
    other[at] = static_cast<char>(other[at] ^ 1);
    check(other);
  }
}

TEST_CASE("values that etak does not write in a shard are refused though their SHA-256 fits") {
  const std::string text = full_document();
  REQUIRE(error_of([&] { (void)read_again(sealed_again(text)); }).empty());
  const std::vector<std::pair<std::string, std::string>> changes{
      {"\"index\": 1", "\"index\": 0"},
      {"\"count\": 1", "\"count\": 0"},
      {"\"index\": 1", "\"index\": 9"},
      {"\"items\": 1", "\"items\": -1"},
      {"\"first\": 0", "\"first\": 2"},
      {"\"last\": 1", "\"last\": 2"},
      {"\"list\": \"a", "\"list\": \"<"},
      {"\"files\": 3", "\"files\": 4"},
      {"\"errors\": 1", "\"errors\": 0"},
      {"\"passed\": false", "\"passed\": true"},
      {"\"profile\": \"default\"", "\"profile\": \"\\u001b[31m\""},
      {"\"profile\": \"default\"", "\"profile\": \"d\\u0065fault\""},
      {"\"hash\": \"a", "\"hash\": \"\\u001b"},
      {"\"id\": \"ETK007\"", "\"id\": \"ETK007\\u001b[31m\""},
      {"\"id\": \"ETK007\"", "\"id\": \"<script>\""},
      {"\"slug\": \"nan-inf\"", "\"slug\": \"::error\""},
      {"\"severity\": \"error\"", "\"severity\": \"off\""},
      {"\"width\": 1024", "\"width\": 2147483647"},
      {"\"width\": 1024", "\"width\": 1e3"},
      {"\"role\": \"specular\"", "\"role\": \"owner\""},
      {"\"sha256\": \"b", "\"sha256\": \"/"},
      {"\"texels\": 16", "\"texels\": -1"},
      {"\"texels\": 16", "\"pixels\": 16"},
      {"\"areaShare\": 0.01", "\"areaShare\": \"much\""},
      {"\"unreadable\": false", "\"unreadable\": 0"},
      {"\"place\": 0", "\"place\": 0.5"},
      {"\"never\": false", "\"never\": null"},
      {"\"minSeverity\": \"\"", "\"minSeverity\": \"all\""},
      {"\"notOpened\": []", "\"notOpened\": [1]"},
      {"\"notOpened\": []", "\"notOpened\": [], \"targets\": [{\"path\": \"../../../etc/passwd\"}]"},
      {"\"truncated\": false", "\"truncated\": true"}};
  for (const auto& [from, to] : changes) {
    const std::string said = error_of([&] { (void)read_again(sealed_again(changed(text, from, to))); });
    INFO(from << " -> " << to << ": " << said);
    CHECK(said.starts_with("s.json"));
    CHECK(!contains(said, "\x1b"));
    CHECK(!contains(said, "json.exception"));
  }
}

TEST_CASE("names in a shard that would act on a terminal or a page are escaped in every merged form") {
  const std::string name = "\x1b[31m<script>x</script>\n::error file=a::b##[error]\xe2\x80\xae.png";
  Finding bad = finding("ETK101", name, Severity::error, PixelBox{1, 2, 3, 4});
  for (std::string* text : {&bad.tile, &bad.material, &bad.pointer, &bad.message, &bad.cause, &bad.fix,
                            &bad.source, &bad.value, &bad.limit})
    *text = name;
  bad.nearest = {{name, name, 1}};
  CheckedFile file = checked_file(name, {bad});
  file.companions = {name};
  ValidationReport shard = one_shard({file});
  shard.unknown = shard.not_opened = {name};
  shard.typed = {{name, name}};
  const ReadShard read = read_again(validation_json(shard, sharded_options));
  for (const std::string& form : forms_of(merged_report({read}, false), {})) {
    INFO(form.substr(0, 300));
    CHECK(!contains(form, "\x1b"));
    CHECK(!contains(form, "\n::error file=a::b"));
    CHECK(!contains(form, "\xe2\x80\xae"));
  }
  CHECK(!contains(forms_of(merged_report({read}, false), {}).back(), "<script>"));
}

TEST_CASE("a shard that is cut off, of a whole run or of another version is refused with its name") {
  ValidationReport report = one_shard({checked_file("a.png")});
  const std::string text = validation_json(report, sharded_options);
  CHECK(contains(error_of([&] { (void)read_shard(text, "s.json", "1.2.4"); }),
                 "s.json: was written by etak 1.2.3; expected all shards of etak 1.2.4"));
  report.shard = nullptr;
  CHECK(contains(error_of([&] { (void)read_again(validation_json(report, sharded_options)); }),
                 "s.json: is not the output of a shard"));
  for (const char* text_ : {"", "[]", "3", "null", "{}", "{\"tool\": 1, \"shard\": 2}"}) {
    INFO(text_);
    CHECK(contains(error_of([&] { (void)read_again(text_); }), "s.json"));
  }
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  CHECK(contains(error_of([&] { (void)read_again(deep); }), "nesting deeper"));
}

TEST_CASE("a name that JSON cannot hold is refused in a shard, not changed in silence") {
  CHECK(contains(error_of([] { validation_json(one_shard({checked_file("a\xff.png")}), sharded_options); }),
                 "no UTF-8"));
}
