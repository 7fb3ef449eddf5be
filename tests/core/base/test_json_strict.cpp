// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <ctime>
#include <string>

#include "core/base/json_node.inc"
#include "tests/support.h"

using namespace etak;
using test::contains;
using test::error_of;

namespace {

Json parse(std::string_view text) {
  return parse_json_strictly(text, "f.json", 4, "a test");
}

std::string repeated(const std::string& head, const std::string& item, std::size_t count,
                     const std::string& tail) {
  std::string out = head;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) out += ',';
    out += item;
  }
  return out + tail;
}

// Processor time, the least of three, since a machine in use only ever adds to a time.
double seconds_of(const std::string& text) {
  double least = 1e9;
  for (int run = 0; run < 3; ++run) {
    const std::clock_t begin = std::clock();
    (void)parse(text);
    least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return least;
}

}  // namespace

TEST_CASE("the strict reader gives the document that nlohmann-json gives") {
  const std::string text =
      R"({"a": [1, -2, 3.5, "x\u00e9", true, false, null, [], {}], "b": {"c": {"d": [18446744073709551615]}}, "": 0})";
  CHECK(parse(text) == Json::parse(text));
  for (const char* scalar : {"1", "\"x\"", "null", "[]", "{}", "-1e-3"})
    CHECK(parse(scalar) == Json::parse(scalar));
}

TEST_CASE("equal keys, depth and broken text are refused") {
  CHECK(contains(error_of([] { (void)parse(R"({"a": {"k": [], "k": 1}})"); }),
                 "key \"k\" twice in one object"));
  CHECK_NOTHROW(parse(R"({"a": {"k": 1}, "b": {"k": 1}})"));
  CHECK_NOTHROW(parse("[[[[1]]]]"));
  CHECK(contains(error_of([] { (void)parse("[[[[[1]]]]]"); }), "nesting deeper than 4"));
  CHECK(contains(error_of([] { (void)parse("{\"a\": "); }), "parse error at line 1"));
  CHECK(contains(error_of([] { (void)parse("[1e999]"); }), "number overflow"));
  CHECK(contains(error_of([] { (void)parse("[1] 2"); }), "f.json"));
  CHECK(contains(error_of([] { (void)parse(""); }), "f.json"));
}

TEST_CASE("found 4.02: reading takes time in proportion to the text") {
  const auto objects = [](std::size_t count) { return repeated("{\"a\":[", "{}", count, "]}"); };
  const auto keys = [](std::size_t count) {
    std::string out = "{";
    for (std::size_t i = 0; i < count; ++i) out += (i > 0 ? ",\"" : "\"") + std::to_string(i) + "\":0";
    return out + "}";
  };
  // Eight times the text: quadratic growth takes 64 times as long, and a document that leaves the caches some
  // 12 times.
  CHECK(seconds_of(objects(800000)) < 32 * seconds_of(objects(100000)));
  CHECK(seconds_of(keys(800000)) < 32 * seconds_of(keys(100000)));
}
