// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cstddef>
#include <string>

#include "core/base/json/node_json.h"
#include "tests/growth.h"
#include "tests/support.h"

using namespace etak;
using test::check_growth;
using test::contains;
using test::error_of;
using test::listed;

namespace {

Json parse(std::string_view text) {
  return parse_json_strictly(text, "f.json", 4, "a test");
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

TEST_CASE("reading takes time in proportion to the text") {
  const auto read = [](const std::string& text) { (void)parse(text); };
  const auto objects = [](std::size_t count) {
    return listed(
        "{\"a\":[", count, [](std::size_t) { return "{}"; }, "]}");
  };
  const auto keys = [](std::size_t count) {
    return listed(
        "{", count, [](std::size_t i) { return '"' + std::to_string(i) + "\":0"; }, "}");
  };
  check_growth("objects", 50000, objects, read);
  check_growth("keys", 20000, keys, read);
}
