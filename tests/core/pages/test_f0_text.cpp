// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <random>

#include "core/base/text/text.h"
#include "tests/core/pages/sample_rows.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

std::vector<std::string> split_at(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (true) {
    const auto at = text.find(separator);
    parts.emplace_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

std::string csv_row(const F0Result& result, std::string path = "p", std::string kind = {}) {
  F0Row row;
  row.path = std::move(path);
  row.result = result;
  row.kind = std::move(kind);
  std::string out;
  append_f0_csv(out, row);
  return out;
}

std::string nine_digits(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

}  // namespace

TEST_CASE("the CSV has the columns that are its interface, as many in every row") {
  CHECK(f0_csv_header() == "path,coverage,r,g,b,u8_r,u8_g,u8_b,Y,F82_r,F82_g,F82_b,zone,flags,kind\n");
  CHECK(split_at(csv_row(gold_result()), ',').size() == 15);
  CHECK(split_at(csv_row(result_of({0.1, 0.2, 0.3})), ',').size() == 15);
  CHECK(split_at(csv_row(refused_result("no n given")), ',').size() == 15);
}

TEST_CASE("a CSV row holds coverage, linear, 8 bit, Y, absolute F82, zone and flags") {
  F0Result r = gold_result();
  r.luminance = 0.5;
  r.zone = zone_of(0.5);
  CHECK(
      csv_row(r) ==
      "p,0.9962,1.0428,0.4,0.3,255,170,149,0.5,0.99,0.9,0.7,above,out-of-gamut:r+0.0428;channel-in-zone,\n");
}

TEST_CASE("reflectance data leave the F82 columns of the CSV empty") {
  F0Result r = result_of({0.5, 0.5, 0.5});
  CHECK(contains(csv_row(r), ",0.5,,,,above,,\n"));
}

TEST_CASE("CSV and table tell the kind of a dataset where it is known") {
  CHECK(contains(csv_row(result_of({0.5, 0.5, 0.5}), "p", "computed"), ",above,,computed\n"));
  CHECK(contains(csv_row(refused_result("no n given"), "p", "fit"), "refused: no n given,fit\n"));
  auto rows = sample_rows();
  CHECK_FALSE(contains(f0_table(rows, {}, false), "kind"));
  rows[1].kind = "fit";
  const auto lines = split_at(f0_table(rows, {}, false), '\n');
  CHECK(lines[0].ends_with("  coverage  kind  flags"));
  CHECK(contains(lines[1], "  -     out-of-gamut"));
  CHECK(lines[2].ends_with("  fit"));
}

TEST_CASE("a surface has an empty zone in CSV and a dash in the table") {
  F0Row row{"paper", "Paper", "surface", "sheet", "", surface_result({0.5, 0.5, 0.5})};
  CHECK(contains(csv_row(row.result), ",0.5,,,,,,\n"));
  const std::string line = split_at(f0_table({&row, 1}, {}, false), '\n')[1];
  CHECK(contains(line, "  0.5000  -    -       0.9962"));  // Y, F82, zone, coverage
}

TEST_CASE("with the method auto, the table says which step was taken and what it is estimated to miss") {
  F0Options options;
  options.method = Method::automatic;
  F0Row row{"p", "", "", "", "", gold_result()};
  row.result.integration = {Method::nm5, 3.14e-6, true};
  CHECK(contains(f0_table({&row, 1}, options, false), "integration, error"));
  CHECK(contains(f0_table({&row, 1}, options, false), "  5nm, 3.1e-06  "));
  row.result.integration = {Method::exact, 2e-4, false};
  CHECK(contains(f0_table({&row, 1}, options, false), "exact, 0.0002, above the bound"));
  CHECK(!contains(f0_table({&row, 1}, {}, false), "integration"));
}

TEST_CASE("a refused CSV row has empty numbers and the reason as its last flag") {
  CHECK(csv_row(refused_result("no n given")) == "p,,,,,,,,,,,,,extrapolated;refused: no n given,\n");
  CHECK(contains(csv_row(refused_result("0.3, not 0.95")), ",\"extrapolated;refused: 0.3, not 0.95\",\n"));
}

TEST_CASE("CSV fields with commas or quotes are quoted as RFC 4180 says, and a row is one line") {
  const F0Result r = refused_result("x");
  CHECK(csv_row(r, "a,b").starts_with("\"a,b\","));
  CHECK(csv_row(r, "a\"b").starts_with("\"a\"\"b\","));
  CHECK(csv_row(r, "a\nb").starts_with("a\\x0ab,"));
  CHECK(csv_row(r, "main/Au/nk/Olmon ev.yml").starts_with("main/Au/nk/Olmon ev.yml,"));
  CHECK(csv_row(r, "β (x)").starts_with("β (x),"));
}

TEST_CASE("CSV numbers are those of printf's %.9g in every magnitude, ties included") {
  std::vector<double> values{0,
                             -0.0,
                             1,
                             0.5,
                             0.1,
                             0.01,
                             0.001,
                             1e-4,
                             9.99e-5,
                             1e-8,
                             10,
                             123456.75,
                             1e9,
                             1e10,
                             0.9999999995,
                             0.99999999949,
                             9.9999999995,
                             0.09999999995,
                             -0.2,
                             -3e-7,
                             1.0000000005,
                             0.12345678950000001,
                             0.5000000005,
                             2.5000000050,
                             5e-324,
                             1.7e308};
  // Exact ties: nine digits and a half in binary fractions.
  for (int i = 1; i < 2000; i += 2) values.push_back(1 + i / 1024.0 / 1024.0);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-9, 3), mantissa(-1, 1);
  for (int i = 0; i < 20000; ++i) values.push_back(mantissa(random) * std::pow(10, exponent(random)));
  for (const double value : values) {
    F0Result r = result_of({0.5, 0.5, 0.5});
    r.linear.r = value;
    const auto fields = split_at(csv_row(r), ',');
    if (fields[2] != nine_digits(value)) FAIL_CHECK(fields[2] << " instead of " << nine_digits(value));
  }
}

TEST_CASE("every channel outside the gamut is a flag of its own with its amount") {
  F0Result r = result_of({1.5, 0.5, -0.25});
  r.gamut_excess = {0.5, 0, -0.25};
  r.flags.set(Flag::out_of_gamut);
  r.flags.set(Flag::gap);
  CHECK(flags_text(r) == "out-of-gamut:r+0.5;out-of-gamut:b-0.25;gap");
  CHECK(flags_text(result_of({0, 0, 0})).empty());
}

TEST_CASE("table columns start in the same place in every row, whatever letters a name has") {
  auto rows = sample_rows();
  rows.push_back({"石英", "", "", "", "", result_of({0.04, 0.04, 0.04})});
  rows.push_back({"e\u0301tain", "", "", "", "", result_of({0.6, 0.6, 0.6})});  // with a combining accent
  const auto lines = split_at(f0_table(rows, {}, false), '\n');
  const std::size_t place = display_width(lines[0].substr(0, lines[0].find("hex")));
  for (std::size_t i = 1; i <= rows.size(); ++i) {
    INFO(lines[i]);
    const std::string code = rows[i - 1].result.refused() ? "-" : hex(rows[i - 1].result.srgb8);
    const auto at = rows[i - 1].result.refused() ? std::string::npos : lines[i].find(code);
    if (at != std::string::npos) CHECK(display_width(lines[i].substr(0, at)) == place);
  }
}

TEST_CASE("below a table, for who asks, stand the flags that occur, no others, and the policy last") {
  CHECK_FALSE(contains(f0_table(sample_rows(), {}, false), policy({})));
  CHECK_FALSE(contains(f0_table(sample_rows(), {}, false), meaning(Flag::extrapolated)));
  const std::string table = f0_table(sample_rows(), {}, false) + f0_legend(sample_rows(), {});
  CHECK(table.ends_with("\n" + policy({}) + "\n"));
  CHECK(contains(table, "\nextrapolated "));
  CHECK(contains(table, meaning(Flag::extrapolated)));
  CHECK(contains(table, meaning(Flag::out_of_gamut)));
  CHECK_FALSE(contains(table, meaning(Flag::gap)));
  CHECK(contains(table, "refused: data cover 0.3"));
}

TEST_CASE("a table and its legend keep to the width of the terminal") {
  for (const bool color : {false, true})
    for (const std::size_t width : {80u, 100u, 120u}) {
      INFO(width << ' ' << color);
      const std::string narrow =
          f0_table(sample_rows(), {}, color, width) + f0_legend(sample_rows(), {}, width);
      std::string plain, joined;
      for (std::size_t i = 0; i < narrow.size(); ++i) {
        if (narrow[i] == '\x1b') i = narrow.find('m', i) + 1;
        plain += narrow[i];
      }
      for (const auto& line : split_at(plain, '\n')) {
        INFO(line);
        // A word that is longer than a line stands alone, behind the indent.
        CHECK((display_width(line) <= width || line.find(' ', line.find_first_not_of(' ')) == line.npos));
      }
      CHECK(contains(plain, "#"));
    }
  CHECK(f0_table(sample_rows(), {}, false, 1000) == f0_table(sample_rows(), {}, false));
}

TEST_CASE("swatches are in the table only when colour is wanted, and none for a refused row") {
  CHECK_FALSE(contains(f0_table(sample_rows(), {}, false), "\x1b"));
  const std::string table = f0_table(sample_rows(), {}, true);
  const auto lines = split_at(table, '\n');
  CHECK(lines[1].starts_with("\x1b[48;2;255;170;149m    \x1b[0m  gold"));
  CHECK(lines[3].starts_with("      a,b"));
}

TEST_CASE("a file name cannot break a table row or colour the terminal") {
  auto rows = sample_rows();
  rows[0].path = "a\nb\x1b[31m\xff";
  const std::string table = f0_table(rows, {}, false);
  CHECK_FALSE(contains(table, "\x1b"));
  CHECK(contains(table, "a\\x0ab\\x1b[31m\\xff"));
}

TEST_CASE("no table line ends in blanks") {
  for (const auto& line : split_at(f0_table(sample_rows(), {}, false), '\n'))
    CHECK_FALSE(line.ends_with(' '));
}

TEST_CASE("spread is the least and largest value per channel over the datasets that were not refused") {
  const Spread s = spread(sample_reports()[0]);
  CHECK(s.count == 2);
  CHECK(s.least == LinearRgb{0.9, 0.4, 0.2});
  CHECK(s.most == LinearRgb{1.0428, 0.5, 0.3});
  CHECK(s.least8 == Srgb8{srgb_u8(0.9), srgb_u8(0.4), srgb_u8(0.2)});
  CHECK(s.most8 == Srgb8{255, srgb_u8(0.5), srgb_u8(0.3)});
  CHECK(spread(sample_reports()[2]).count == 0);
}

TEST_CASE("bytes that are no UTF-8 are replaced, all else is kept") {
  CHECK(valid_utf8("Böhmit 石英 🪙") == "Böhmit 石英 🪙");
  CHECK(valid_utf8("a\xffz") == "a\uFFFDz");
  CHECK(valid_utf8("\xc3") == "\uFFFD");
  CHECK(valid_utf8("\xc0\x80") == "\uFFFD\uFFFD");            // overlong
  CHECK(valid_utf8("\xed\xa0\x80") == "\uFFFD\uFFFD\uFFFD");  // surrogate
  CHECK(display_width("βé石") == 4);
}
