// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/rii/rii_page.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

RiiPage parse_page(std::string_view text) {
  RiiPage page;
  parse_rii_page(text, "page.yml", page);
  return page;
}

// A page with one table of `type`, a row per line of `rows`.
std::string table_block(std::string_view type, const std::vector<std::string>& rows) {
  std::string text = "  - type: " + std::string(type) + "\n    data: |\n";
  for (const auto& row : rows) text += "        " + row + "\n";
  return text;
}
std::string page_of(const std::string& data) {
  return "# comment\n\nREFERENCES: |\n    Somebody.\n    DATA: of nobody\nDATA:\n" + data;
}
std::string formula(int number, std::string_view coefficients) {
  return "  - type: formula " + std::to_string(number) +
         "\n    wavelength_range: 0.3 2.5\n    coefficients: " + std::string(coefficients) + "\n";
}

const Spectrum& n_table(const RiiPage& page) {
  return std::get<Spectrum>(page.constants().n);
}
const DispersionFormula& n_formula(const RiiPage& page) {
  return std::get<DispersionFormula>(page.constants().n);
}
Flags only_flag(Flag flag) {
  Flags flags;
  flags.set(flag);
  return flags;
}
using Numbers = std::vector<double>;

std::string page_refusal(std::string_view text) {
  return error_of([&] { parse_page(text); });
}

}  // namespace

TEST_CASE("a table of n and k is read in nanometres") {
  const auto page =
      parse_page(page_of(table_block("tabulated nk", {"0.4 1.5 0.1", "0.5 1.4 2E-1", "0.7 +1.3 .3"})));
  CHECK(page.kind == PageKind::constants);
  CHECK(page.refusal.empty());
  CHECK(page.flags.none());
  CHECK(n_table(page).wavelength_nm == Numbers{0.4 * 1000.0, 0.5 * 1000.0, 0.7 * 1000.0});
  CHECK(n_table(page).value == Numbers{1.5, 1.4, 1.3});
  REQUIRE(page.constants().k);
  CHECK(page.constants().k->wavelength_nm == n_table(page).wavelength_nm);
  CHECK(page.constants().k->value == Numbers{0.1, 0.2, 0.3});
}

TEST_CASE("n and k may have tables of their own, tabs, blank lines, CRLF ends and no last line end") {
  const auto page = parse_page(
      "DATA:\r\n  - type: tabulated n\r\n    data: |\r\n        0.4\t1.5\r\n\r\n        0.8 \t 1.4\t\r\n"
      "  - type: tabulated k\r\n    data: |\r\n        0.5 0.1");
  CHECK(n_table(page).value == Numbers{1.5, 1.4});
  REQUIRE(page.constants().k);
  CHECK(page.constants().k->wavelength_nm == Numbers{500});
  CHECK(page.flags.none());
}

TEST_CASE("a page without k has none, and a page read after another keeps nothing of it") {
  RiiPage page;
  parse_rii_page(page_of(table_block("tabulated nk", {"0.4 1.5 -0.1", "0.3 1 1"})), "a.yml", page);
  REQUIRE(page.constants().k);
  parse_rii_page(page_of(table_block("tabulated n", {"0.5 2"})), "b.yml", page);
  CHECK(!page.constants().k);
  CHECK(page.flags.none());
  CHECK(n_table(page) == Spectrum{{500}, {2}});
}

TEST_CASE("a formula carries its number, coefficients and range") {
  for (int number = 1; number <= 9; ++number) {
    const auto page = parse_page(page_of(formula(number, "1.5 0 -2e-3")));
    CHECK(n_formula(page) == DispersionFormula{number, {1.5, 0, -2e-3}, 300, 2500});
  }
  const auto older =
      parse_page("DATA:\n  - type: formula 1\n    range: 0.3 2.5\n    coefficients: 1 # one\n");
  CHECK(n_formula(older) == DispersionFormula{1, {1}, 300, 2500});
}

TEST_CASE("beside a formula k comes from its table, and a table of n and k gives k only, in either order") {
  const auto k =
      parse_page(page_of(formula(3, "2.25") + table_block("tabulated k", {"0.4 1e-7", "0.5 2e-7"})));
  CHECK(n_formula(k).number == 3);
  CHECK(k.constants().k->value == Numbers{1e-7, 2e-7});
  const std::string nk = table_block("tabulated nk", {"0.4 1.5 0.1", "0.5 -1.6 0.2"});
  for (const auto& data : {formula(5, "1.5") + nk, nk + formula(5, "1.5")}) {
    const auto page = parse_page(page_of(data));
    CHECK(n_formula(page).number == 5);
    CHECK(page.constants().k->value == Numbers{0.1, 0.2});
    CHECK(page.flags.none());  // the table's n is not used, so its sign is nobody's business
  }
}

TEST_CASE("an even count of coefficients loses the last one, flagged") {
  const auto page = parse_page(page_of(formula(2, "3.6453 2.2057 0.1879 1.8377")));
  CHECK(n_formula(page).coefficients == Numbers{3.6453, 2.2057, 0.1879});
  CHECK(page.flags == only_flag(Flag::unpaired_coefficient));
  CHECK(n_formula(parse_page(page_of(formula(4, "1 2 3 4 5 6 7 8 9 10")))).coefficients.size() == 9);
  CHECK(parse_page(page_of(formula(8, "0.4 0.1 0.07 -0.001"))).flags.none());
}

TEST_CASE("rows that do not ascend are sorted and flagged") {
  const auto page = parse_page(page_of(table_block("tabulated nk", {"0.7 3 30", "0.5 2 20", "0.4 1 10"})));
  CHECK(page.flags == only_flag(Flag::unsorted));
  CHECK(n_table(page).value == Numbers{1, 2, 3});
  CHECK(page.constants().k->value == Numbers{10, 20, 30});
}

TEST_CASE("identical duplicates are dropped, different ones averaged, each with its flag") {
  const auto dropped = parse_page(page_of(table_block("tabulated nk", {"0.4 1 5", "0.4 1 5", "0.5 2 6"})));
  CHECK(dropped.flags == only_flag(Flag::duplicate_dropped));
  CHECK(n_table(dropped).value == Numbers{1, 2});
  const auto averaged =
      parse_page(page_of(table_block("tabulated nk", {"0.4 1 5", "0.4 1 8", "0.5 2 6", "0.4 1 8"})));
  CHECK(averaged.flags.has(Flag::duplicate_wavelength));
  CHECK(averaged.flags.has(Flag::unsorted));
  CHECK(n_table(averaged) == Spectrum{{400, 500}, {1, 2}});
  CHECK(averaged.constants().k->value == Numbers{7, 6});
}

TEST_CASE("k below zero is taken as 0 and flagged") {
  const auto page = parse_page(page_of(table_block("tabulated nk", {"0.4 1 -0.001", "0.5 2 0.1"})));
  CHECK(page.flags == only_flag(Flag::negative_k));
  CHECK(page.constants().k->value == Numbers{0, 0.1});
}

TEST_CASE("n that is not positive refuses a page only where 360 to 830 nm uses it") {
  const auto rows = [](std::vector<std::string> text) {
    return parse_page(page_of(table_block("tabulated n", text)));
  };
  for (const auto& page :
       {rows({"0.2 -1", "0.36 1.5", "0.83 1.4"}), rows({"0.3 1.5", "0.83 1.4", "0.9 0"})}) {
    CHECK(page.refusal.empty());
    CHECK(page.flags == only_flag(Flag::n_not_positive));
  }
  for (const auto& page : {rows({"0.2 -1", "0.37 1.5", "0.83 1.4"}), rows({"0.3 1.5", "0.82 1.4", "0.9 0"}),
                           rows({"0.4 0", "0.5 1.5"}), rows({"0.1 1", "0.2 -1"})}) {
    CHECK(contains(page.refusal, "n must be positive"));
    CHECK(page.kind == PageKind::constants);
  }
}

TEST_CASE("k alone is a page without n, n2 alone is none of ours, and n2 beside n does not disturb") {
  const auto k = parse_page(page_of(table_block("tabulated k", {"0.4 1"})));
  CHECK(k.kind == PageKind::constants);
  CHECK(k.refusal == "no n given");
  CHECK(parse_page(page_of(table_block("tabulated n2", {"1.06 1.8E-17", "not 1.80-17"}))).kind ==
        PageKind::nonlinear);
  const auto both =
      parse_page(page_of(table_block("tabulated n2", {"1 2"}) + table_block("tabulated n", {"0.4 1.5"})));
  CHECK(both.kind == PageKind::constants);
  CHECK(both.refusal.empty());
}

TEST_CASE("about pages and catalogues are other files, not errors") {
  for (const char* text :
       {"ABOUT: |\n    A metal.\n\n    Shiny.\nNAMES:\n  - gold\nLINKS:\n- url: x\n  text: y\n",
        "- SHELF: main\n  content:\n    - BOOK: Ag\n", "NAMES:\n", "---\nNAMES: [a, b]\n"})
    CHECK(parse_page(text).kind == PageKind::other);
}

TEST_CASE("keys of DATA inside other blocks do not confuse") {
  const auto page =
      parse_page(page_of(table_block("tabulated n", {"0.4 1.5"})) +
                 "CONDITIONS:\n    temperatute: 293\nPROPERTIES:\n    thermal_dispersion:\n"
                 "      - type: formula A\n        coefficients: 1 2\n      - type: dn/dT\n        data: |\n"
                 "            1 2\n");
  CHECK(n_table(page).size() == 1);
}

TEST_CASE("keys of an entry may come in any order, list items at column 0, and type in quotes") {
  const auto page =
      parse_page("DATA:\n- data: |\n   0.4 1.5\n   0.8 1.4\n  type: \"tabulated n\"\nCOMMENTS: x\n");
  CHECK(n_table(page).value == Numbers{1.5, 1.4});
}

TEST_CASE("a byte order mark before the first key is not part of it") {
  CHECK(parse_page("\xEF\xBB\xBF" + page_of(table_block("tabulated n", {"0.4 1.5"}))).kind ==
        PageKind::constants);
}

TEST_CASE("a broken row is refused with its line") {
  // page_of() and table() put the first row into line 9.
  const auto nk = [](const std::string& text) {
    return page_refusal(page_of(table_block("tabulated nk", {"0.3 1 0.1", text})));
  };
  CHECK(contains(nk("0.4 1.5"), "page.yml:10: a row of 2; expected 3 numbers"));
  CHECK(contains(nk("0.4 1.5 0 7"), "page.yml:10: \"7\"; expected the end of a row"));
  CHECK(contains(nk("0.4 nan 0"), "page.yml:10: n = nan"));
  CHECK(contains(nk("0.4 1.5 inf"), "page.yml:10: k = inf"));
  CHECK(contains(nk("0.4 1,5 0"), "page.yml:10: \",5\""));
  CHECK(contains(nk("0.4 x 0"), "page.yml:10: \"x\"; expected a number"));
  CHECK(contains(nk("0.4 +-1 0"), "page.yml:10: \"+-1\"; expected a number"));
  CHECK(contains(nk("0 1.5 0"), "page.yml:10: wavelength 0"));
  CHECK(contains(nk("-0.4 1.5 0"), "page.yml:10: wavelength -0.4"));
  CHECK(contains(nk("0.4 10001 0"), "page.yml:10: n = 10001"));
  CHECK(contains(nk("0.4 1.5 1e7"), "page.yml:10: k = 10000000"));
  CHECK(contains(nk("0.4 1.5 1e999"), "page.yml:10: \"1e999\""));
  CHECK(contains(nk("# 0.4 1.5 0"), "page.yml:10: \"#\""));
}

TEST_CASE("what is no page is refused with its place") {
  CHECK(page_refusal("") == "page.yml: the file is empty");
  CHECK(contains(page_refusal("# only\n\n# comments\n"), "page.yml:4: the text ends without a key"));
  CHECK(contains(page_refusal(std::string_view("\x7F"
                                               "ELF\x02\x01\0\0",
                                               8)),
                 "page.yml:1: \"\\x7fELF"));
  CHECK(contains(page_refusal("wavelength,n,k\n1,2,3\n"), "page.yml:1: "));
  CHECK(contains(page_refusal(std::string_view("ABOUT: |\n  a\0b\n", 15)), "page.yml:2: a zero byte"));
  CHECK(contains(page_refusal("REFERENCES: |\n    Some"), "page.yml:2: the text ends without DATA"));
  CHECK(contains(page_refusal("  indented: 1\n"), "page.yml:1: an indented line"));
  CHECK(contains(page_refusal("\tA: 1\n"), "page.yml:1: a tab"));
}

TEST_CASE("a key twice is refused, at the top and in an entry") {
  const std::string page = page_of(table_block("tabulated n", {"0.4 1"}));
  CHECK(contains(page_refusal(page + "DATA:\n"), "page.yml:10: DATA twice"));
  CHECK(contains(page_refusal("A: 1\nA: 2\n"), "page.yml:2: A twice"));
  CHECK(contains(page_refusal(page + "    data: |\n        0.5 1\n"), "page.yml:10: data twice"));
  CHECK(contains(page_refusal(page_of(formula(1, "1") + "    range: 1 2\n")), "range twice"));
}

TEST_CASE("an entry of DATA that cannot be meant is refused") {
  const auto data = [](const std::string& text) { return page_refusal("DATA:\n" + text); };
  CHECK(contains(data(""), "page.yml:1: DATA is empty"));
  CHECK(contains(page_refusal("DATA: []\n"), "page.yml:1: a value behind DATA:"));
  CHECK(contains(data("  - type: formula 10\n"), "page.yml:2: type \"formula 10\""));
  CHECK(contains(data("  - type: tabulated R\n"), "page.yml:2: type \"tabulated R\""));
  CHECK(contains(data("  - type: tabulated n\n"), "page.yml:2: a table without data"));
  CHECK(contains(data("  - type: tabulated n\n    data: |\n"), "page.yml:3: a table without rows"));
  CHECK(contains(data("  - type: tabulated n\n    data: 0.4 1\n"), "page.yml:3: data: \"0.4 1\""));
  CHECK(contains(data("  - type: formula 1\n    coefficients: 1\n"),
                 "page.yml:2: a formula without wavelength_range"));
  CHECK(contains(data("  - type: formula 1\n    wavelength_range: 1 2\n"),
                 "page.yml:2: a formula without coeff"));
  CHECK(contains(data("  - type: formula 1\n    wavelength_range: 1\n"), "page.yml:3: 1 numbers"));
  CHECK(contains(data("  - type: formula 1\n    wavelength_range: 2 1\n    coefficients: 1\n"),
                 "empty wavelength range"));
  CHECK(contains(data("  - type: formula 1\n    coefficients: 1 two\n"), "page.yml:3: \"two\""));
  CHECK(contains(data("  - type: formula 1\n    coeficients: 1\n"), "page.yml:3: the key \"coeficients\""));
  CHECK(contains(data("  - data: |\n      0.4 1\n"), "page.yml:2: an entry of DATA without type"));
  CHECK(contains(data("  - type: formula 1\n      deeper: 1\n"), "page.yml:3: \"deeper:\""));
  CHECK(contains(data("  - type: tabulated n\n    data: |\n      0.4 1\n   - type: formula 1\n"),
                 "page.yml:5: "));
  CHECK(contains(data("  text\n"), "page.yml:2: \"text\""));
  CHECK(contains(data("  - type: formula 1\n    coefficients: 1\n    range: 1 2\n- x\n"),
                 "page.yml:5: a list item"));
  CHECK(contains(page_refusal("A: |\n    text\n- x\n"), "page.yml:3: a list item"));
}

TEST_CASE("n twice and k twice are refused") {
  const std::string n = table_block("tabulated n", {"0.4 1"}), k = table_block("tabulated k", {"0.4 1"});
  const std::string nk = table_block("tabulated nk", {"0.4 1 1"}), f = formula(1, "1");
  for (const auto& data : {n + n, n + nk, nk + nk, f + f, n + f, f + n})
    CHECK(contains(page_refusal(page_of(data)), "given twice"));
  for (const auto& data : {k + k, nk + k, k + nk, f + nk + k})
    CHECK(contains(page_refusal(page_of(data)), "k given twice"));
}

TEST_CASE("the real database is read to the last page") {
  const char* folder = std::getenv("ETAK_DATABASE");
  if (folder == nullptr) {
    WARN("skipped: ETAK_DATABASE does not name the data folder of a refractiveindex.info database");
    return;
  }
  std::size_t constants = 0, nonlinear = 0, other = 0, no_n = 0, negative_n = 0;
  RiiPage page;
  std::string text;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    read_file(entry.path().string(), text);
    REQUIRE_NOTHROW(parse_rii_page(text, entry.path().string(), page));
    constants += page.kind == PageKind::constants;
    nonlinear += page.kind == PageKind::nonlinear;
    other += page.kind == PageKind::other;
    if (page.kind != PageKind::constants) continue;
    no_n += page.refusal == "no n given";
    negative_n += page.flags.has(Flag::n_not_positive);
    CHECK((page.refusal.empty() || page.refusal == "no n given"));
    if (page.refusal.empty()) REQUIRE_NOTHROW(material_from_rii_page(text, entry.path().string(), ""));
  }
  CHECK(constants == 3480);  // 3,478 in the catalogue and two that are not
  CHECK(nonlinear == 240);
  CHECK(other == 460);
  CHECK(no_n == 19);
  CHECK(negative_n == 10);
}
