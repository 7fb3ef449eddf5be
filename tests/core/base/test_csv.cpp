// SPDX-License-Identifier: Apache-2.0
#include "core/base/text/csv.h"

#include <catch2/catch.hpp>

#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

using Fields = std::vector<std::string>;

}  // namespace

TEST_CASE("CSV fields in quotes hold commas, line ends and quotes, and a row knows its first line") {
  const auto rows = csv_rows("\xEF\xBB\xBFid,note\r\n\r\na,\"one, two\nthree \"\"four\"\"\"\nb,\n", "t.csv");
  REQUIRE(rows.size() == 3);
  CHECK(rows[0].fields == Fields{"id", "note"});
  CHECK(rows[1].fields == Fields{"a", "one, two\nthree \"four\""});
  CHECK(rows[1].line == 3);
  CHECK(rows[2].fields == Fields{"b", ""});
  CHECK(rows[2].line == 5);
  CHECK(csv_rows("", "t.csv").empty());
  CHECK(contains(error_of([] { (void)csv_rows("a\nb,\"c\n", "t.csv"); }), "t.csv:2: a quote"));
}

TEST_CASE("CSV fields that are written are read as they were, but for an apostrophe before a formula") {
  for (const char* text : {"plain", "one, two", "a \"quoted\" word", "-1.5", "-", ""})
    CHECK(csv_rows("x," + csv_field(text) + "\n", "t.csv").at(0).fields.at(1) == text);
  CHECK(csv_field("=1+1") == "'=1+1");
  std::string of_list, of_fields;
  append_csv_row(of_list, {"a,b", "", "=c"});
  append_csv_row(of_fields, Fields{"a,b", "", "=c"});
  CHECK(of_list == "\"a,b\",,'=c\n");
  CHECK(of_fields == of_list);
}

TEST_CASE("no cell of a CSV begins a formula, where semicolons separate cells neither") {
  for (const char* begin : {"=", "+", "-", "@", "|", "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"}) {
    const std::string formula = begin + std::string("cmd");
    CHECK(csv_field(formula) == "'" + formula);
    CHECK(csv_field("a;" + formula) == "a;'" + formula);
    CHECK(csv_field("a; " + formula + ";" + formula) == "a; '" + formula + ";'" + formula);
    CHECK(csv_field("a;\"" + formula) == "\"a;\"\"'" + formula + "\"");
    CHECK(csv_field("\t" + formula) == "\\x09" + formula);
    CHECK(csv_field("a" + formula) == "a" + formula);
  }
  for (const char* plain : {"a;b", "1;-2;+3", ";;", "a;-", "; ", "x=1; y"}) CHECK(csv_field(plain) == plain);
}
