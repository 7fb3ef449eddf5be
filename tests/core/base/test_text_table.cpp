// SPDX-License-Identifier: Apache-2.0
#include "core/base/text/text_table.h"

#include <catch2/catch.hpp>

#include "core/base/json/json_text.h"

using namespace etak;

TEST_CASE(
    "A text table has columns as wide as their widest cell, but for the last cell of a row, and no blanks at an end") {
  const std::vector<TextRow> rows{{{"id", "Y     ", "note"}, "   "},
                                  {{"gold", "0.7", ""}, "## "},
                                  {{"a", "refused: for a reason that is longer than any column"}, "   "}};
  CHECK(text_table(rows) ==
        "   id    Y       note\n"
        "## gold  0.7\n"
        "   a     refused: for a reason that is longer than any column\n");
  CHECK(text_table({}).empty());
}

TEST_CASE("JSON of several lines: a document names its schema first, a list has an item a line, none is []") {
  const std::vector<std::string> none;
  CHECK(json_document("etak-test/1",
                      {{"some", json_lines_of(std::vector{1.5, 2.0}, 2, [](double v) { return json(v); })},
                       {"none", json_lines(none, 2)}}) ==
        "{\n  \"schema\": \"etak-test/1\",\n  \"some\": [\n    1.5,\n    2\n  ],\n  \"none\": []\n}\n");
}
