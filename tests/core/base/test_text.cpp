// SPDX-License-Identifier: Apache-2.0
#include "core/base/text/text.h"

#include <catch2/catch.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/error.h"
#include "core/base/json/json_text.h"
#include "core/base/number.h"
#include "core/base/text/csv.h"
#include "tests/growth.h"

using namespace etak;

TEST_CASE("a text falls into the parts between separators, without empty ones") {
  using Parts = std::vector<std::string>;
  CHECK(parts_of("a,b c,d", ',') == Parts{"a", "b c", "d"});
  CHECK(parts_of(",a,,b,", ',') == Parts{"a", "b"});
  CHECK(parts_of("", ':').empty());
  CHECK(parts_of("::", ':').empty());
}

TEST_CASE("parts are joined as they are, by a function or by a member") {
  struct Named {
    std::string_view name;
  };
  CHECK(joined(std::vector<std::string>{"a", "b"}) == "a, b");
  CHECK(joined(std::vector<std::string>{}) == "");
  CHECK(joined(std::vector{1.5, 2.0}, " ", [](double value) { return number(value, 3); }) == "1.5 2");
  CHECK(joined(std::vector<Named>{{"x"}, {"y"}}, "|", &Named::name) == "x|y");
}

TEST_CASE("numbers with fixed decimals stay short, however large they are") {
  CHECK(fixed(0.5, 1) == "0.5");
  CHECK(fixed(-0.001, 2) == "0.00");
  CHECK(fixed(999999999999999, 1) == "999999999999999.0");
  CHECK(fixed(-999999999999999, 30).size() == 47);
  CHECK(fixed(1e15, 4) == "1e+15");
  CHECK(fixed(std::numeric_limits<double>::max(), 4) == "1.79769e+308");
  CHECK(fixed(std::numeric_limits<double>::lowest(), 4) == "-1.79769e+308");
  CHECK(fixed(std::numeric_limits<double>::infinity(), 4) == "inf");
  CHECK(fixed(std::numeric_limits<double>::quiet_NaN(), 4) == "nan");
}

TEST_CASE("a line shows by its number what a terminal or a build would act on") {
  CHECK(line_text("gold, \"fine\" \\ 100 % <b>") == "gold, \"fine\" \\ 100 % <b>");
  CHECK(line_text("Å µm 金 🙂 a\u00A0b") == "Å µm 金 🙂 a\u00A0b");
  CHECK(line_text(std::string_view("\0\x1b]0;t\x07\r\n\t\x7f", 11)) ==
        "\\x00\\x1b]0;t\\x07\\x0d\\x0a\\x09\\x7f");
  CHECK(line_text("\u0080\u009b\u009f\u202a\u202e\u2066\u2069\u200e\u200f\u061c\u2028\u2029") ==
        "\\u0080\\u009b\\u009f\\u202a\\u202e\\u2066\\u2069\\u200e\\u200f\\u061c\\u2028\\u2029");
  CHECK(line_text("a\xff\xc3") == "a\\xff\\xc3");
  CHECK(line_text("::error::x ::y std::z") == "\\x3a:error::x \\x3a:y std::z");
  CHECK(line_text("a ##[error] ### #1") == "a \\x23#[error] \\x23\\x23# #1");
  for (const char* text : {"\x1b\n::error", "###", "\xff\u202e", " :: "})
    CHECK(line_text(line_text(text)) == line_text(text));
  CHECK(printable("\u202e::") == "\\u202e::");
  CHECK(printable("aÅb", 2) == "aÅ...");
}

TEST_CASE("two colons behind any blank of Unicode begin no command of a build") {
  for (const char* blank :
       {" ", "\u00A0", "\u1680", "\u2000", "\u2005", "\u200A", "\u202F", "\u205F", "\u3000"}) {
    const std::string name = blank;
    CHECK(line_text(name + "::error x::y.csv") == name + "\\x3a:error x::y.csv");
    CHECK(line_text("a" + name + "::error") == "a" + name + "\\x3a:error");
    CHECK(line_text(line_text(name + "::")) == line_text(name + "::"));
  }
  // These are shown by their numbers, behind which no command is looked for.
  for (const char* active : {"\t", "\v", "\f", "\u0085", "\u2028", "\u2029"})
    CHECK(line_text(active + std::string("::error")).starts_with("\\"));
}

TEST_CASE("JSON holds the true text and no character that acts") {
  for (const std::string text : {"\x1b\x7f\u009b\u202e\n::error", "##[error] \\ \" Å 金", "\u2028\u2066"}) {
    const std::string written = json(text);
    CHECK(nlohmann::json::parse(written) == text);
    CHECK(line_text(written) == written);
    const std::string document = quiet_json(nlohmann::json{{text, {text, 1}}}.dump(2));
    CHECK(nlohmann::json::parse(document)[text][0] == text);
    CHECK(document.find_first_of("\x1b\x7f") == document.npos);
    CHECK(document.find("\u202e") == document.npos);
    CHECK(document.find("##") == document.npos);
  }
  CHECK(quiet_json("{\n  \"a\": \"Å\"\n}") == "{\n  \"a\": \"Å\"\n}");
}

TEST_CASE("a text cell of CSV is no formula and one line; numbers stay numbers") {
  CHECK(csv_field("gold") == "gold");
  CHECK(csv_field("a,b") == "\"a,b\"");
  CHECK(csv_field("a\"b") == "\"a\"\"b\"");
  CHECK(csv_field("=1+1") == "'=1+1");
  CHECK(csv_field("@a,b") == "\"'@a,b\"");
  CHECK(csv_field("+cmd|x") == "'+cmd|x");
  CHECK(csv_field("-1+1") == "'-1+1");
  CHECK(csv_field("-1.5e-3") == "-1.5e-3");
  CHECK(csv_field("+2") == "+2");
  CHECK(csv_field("-") == "-");
  CHECK(csv_field("\t=1\n") == "\\x09=1\\x0a");
  CHECK(csv_field("") == "");
}

TEST_CASE("text in HTML neither ends its element nor acts on a terminal that shows the page") {
  CHECK(escape_html("<script>\"'&") == "&lt;script&gt;&quot;&#39;&amp;");
  CHECK(escape_html("a\n::b\tc\x1b\u202e") == "a \\x3a:b c\\x1b\\u202e");
  CHECK(padded("\nÅ", 7) == "\\x0aÅ  ");
  CHECK(cell_width("\nÅ") == 5);
}

TEST_CASE("the front of a text is made of whole characters") {
  CHECK(front_of("gold", 9) == "gold");
  CHECK(front_of("gold", 2) == "go");
  CHECK(front_of("金属", 3) == "金");
  CHECK(front_of("金属", 4) == "金属");
  CHECK(front_of("e\u0301x", 1) == "e\u0301");
  CHECK(front_of("a\xff", 1) == "a");
  CHECK(front_of("gold", 0).empty());
  CHECK(front_of("", 5).empty());
}

TEST_CASE("the front of a wide text takes time for the front, its width for the text") {
  const auto wide = [](std::size_t count) {
    std::string out;
    for (std::size_t i = 0; i < count; ++i) out += "金";
    return out;
  };
  test::check_growth("front", 100000, wide,
                     [](const std::string& text) { CHECK(front_of(text, 79).size() == 117); });
  test::check_growth("width", 100000, wide,
                     [](const std::string& text) { CHECK(display_width(text) % 200000 == 0); });
}
