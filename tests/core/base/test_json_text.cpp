// SPDX-License-Identifier: Apache-2.0
#include "core/base/json/json_text.h"

#include <array>
#include <catch2/catch.hpp>
#include <limits>

using namespace etak;

TEST_CASE("JSON values are the shortest text that reads back equal, and quiet") {
  CHECK(json(0.1) == "0.1");
  CHECK(json(5123.0) == "5123");
  CHECK(json(std::numeric_limits<double>::infinity()) == "null");
  CHECK(json("a\"b\\\n") == R"("a\"b\\\u000a")");
  CHECK(json_array_of(std::array{1.5, 0.0}) == "[1.5, 0]");
}

TEST_CASE("JSON objects have a member a line, all on one line, or rows of members") {
  const std::vector<JsonMember> members{{"a", "1"}, {"b", json("x")}};
  CHECK(json_object(members, -1) == R"({"a": 1, "b": "x"})");
  CHECK(json_object(members, 2) == "{\n    \"a\": 1,\n    \"b\": \"x\"\n  }");
  CHECK(json_object(std::vector<JsonMember>{}, -1) == "{}");
  CHECK(json_object(std::vector<JsonMember>{}, 0) == "{\n}");
  CHECK(json_rows({members, {{"c", "2"}}}, 3) == "{\"a\": 1, \"b\": \"x\",\n   \"c\": 2}");
  CHECK(json_lines(std::vector<std::string>{"1", "2"}, 2) == "[\n    1,\n    2\n  ]");
}
