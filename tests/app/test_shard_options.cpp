// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "app/cli/options/shard.h"
#include "core/findings/output/formats.h"
#include "core/findings/shards/report_shard.h"
#include "core/validate/validate.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::cli;
using namespace etak::test;

namespace {

// What the line of a verb with options of every kind gives.
std::vector<GivenOption> given(std::vector<std::string> words) {
  CommandLine line("", "etak");
  Command verb = line.verb("check", "");
  std::string fresh, file, level = "2", output;
  std::vector<std::string> paths;
  unsigned threads = 0;
  bool strict = false, watch = false;
  verb.option("path", paths, "").reads_file().in_shards(InShards::free);
  verb.option("--fresh", fresh, "");
  verb.option("--file", file, "").reads_file();
  verb.option("--level", level, "").show_default();
  verb.flag("--strict", strict, "");
  verb.option("-j,--jobs", threads, "").in_shards(InShards::free);
  verb.option("-o,--output", output, "").in_shards(InShards::output);
  verb.flag("--watch", watch, "").in_shards(InShards::whole);
  words.insert(words.begin(), {"etak", "check"});
  (void)line.read(words);
  return verb.given();
}

std::string digest(const std::vector<std::string>& words) {
  return line_digest(given(words));
}

}  // namespace

TEST_CASE("two shards that differ in an option that was only declared do not join") {
  const TempFolder folder;
  const auto shard = [&](std::size_t index, const std::vector<std::string>& words) {
    ValidationRequest request;
    request.inputs.paths = {folder.path()};
    request.config.root = folder.path();
    request.part.shard = Shard{index, 2};
    request.part.line_digest = digest(words);
    const OutputOptions options{Severity::error, "1"};
    return read_shard(validation_json(validate(request), options), std::to_string(index), options.version);
  };
  const auto joined_with = [&](const std::vector<std::string>& words) {
    return error_of([&] { (void)merged_report({shard(1, {"--fresh", "a"}), shard(2, words)}, false); });
  };
  CHECK(joined_with({"--fresh", "a", "-j", "4", "-o", "x", "y"}) == "");
  CHECK(contains(joined_with({"--fresh", "b"}), "2: was run with other options than 1"));
  CHECK(contains(joined_with({}), "2: was run with other options than 1"));
  CHECK(contains(joined_with({"--fresh", "a", "--strict"}), "2: was run with other options than 1"));
}

TEST_CASE("a digest of a line knows values, the bytes of files, and defaults") {
  const TempFolder folder;
  const std::string a = folder.file("a"), b = folder.file("b");
  spit(a, "same");
  spit(b, "same");
  CHECK(digest({"--strict", "--fresh", "a"}) == digest({"--fresh=a", "--strict"}));
  CHECK(digest({"--level", "2"}) == digest({}));
  CHECK(digest({"--level", "3"}) != digest({}));
  CHECK(digest({"--file", a}) == digest({"--file", b}));
  spit(b, "other");
  CHECK(digest({"--file", a}) != digest({"--file", b}));
}

TEST_CASE("an option that needs the whole run is refused beside a shard") {
  CHECK(error_of([] { check_can_be_cut(given({"--strict", "-o", "x"})); }) == "");
  CHECK(contains(error_of([] { check_can_be_cut(given({"--watch"})); }), "--watch: in a run that is cut"));
}
