// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/table.h"

#include <catch2/catch.hpp>

#include "core/base/error.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

Table parse_rows(std::string_view text, const TableOptions& options = {}) {
  return parse_table(text, "t.csv", options);
}

std::string table_refusal(std::string_view text, const TableOptions& options = {}) {
  return error_of([&] { parse_rows(text, options); });
}

const Spectrum& n_of(const Table& table) {
  return std::get<Spectrum>(std::get<OpticalConstants>(table.optics).n);
}
const Spectrum& k_of(const Table& table) {
  return *std::get<OpticalConstants>(table.optics).k;
}
const Spectrum& r_of(const Table& table) {
  return std::get<Reflectance>(table.optics).spectrum;
}

TableOptions in(WavelengthUnit unit) {
  TableOptions options;
  options.unit = unit;
  return options;
}
TableOptions with_duplicates(Duplicates duplicates) {
  TableOptions options;
  options.duplicates = duplicates;
  return options;
}
TableOptions named_columns(std::vector<std::string> columns) {
  TableOptions options;
  options.columns = std::move(columns);
  return options;
}

using Doubles = std::vector<double>;

}  // namespace

TEST_CASE("the same table reads the same between commas, semicolons, tabs and blanks, quoted or not") {
  const Table expected = parse_rows("wavelength_nm,n,k\n400,1.5,0.1\n700,1.4,0.2\n");
  CHECK(n_of(expected) == Spectrum{{400, 700}, {1.5, 1.4}});
  CHECK(k_of(expected) == Spectrum{{400, 700}, {0.1, 0.2}});
  CHECK(expected.flags.none());
  for (const char* text :
       {"wavelength_nm;n;k\n400;1.5;0.1\n700;1.4;0.2\n", "wavelength_nm\tn\tk\n400\t1.5\t0.1\n700\t1.4\t0.2",
        "  wavelength (nm)   n  k \n  400  1.5 0.1\n\n 700\t1.4 \t 0.2\n",
        "\xEF\xBB\xBFWL / nm, N, K\r\n400, +1.5, 1e-1\r\n700, 1.4, .2\r\n",
        "\"wavelength, nm\",\"n\",\"k\"\n\"400\",\"1.5\",\"0.1\"\n700,1.4,0.2,\n",
        "# a comment, and more\nwl_nm n k # names\n400 1.5 0.1 # first\n# between\n700 1.4 0.2\n",
        "wavelength_nm,n,k\n400 1.5 0.1\n700 1.4 0.2\n",
        "lambda [nm],n,_,k\n400,1.5,x,0.1\n700,1.4,,0.2\n"}) {
    INFO(text);
    const Table table = parse_rows(text);
    CHECK(table.optics == expected.optics);
    CHECK(table.flags.none());
  }
}

TEST_CASE("units are read from the header in their usual spellings") {
  for (const char* header : {"wavelength (um)", "wl_um", "lambda [µm]", "λ (μm)", "Wavelength / micron", "um",
                             "wavelength_microns", "wavelength (micrometres)"}) {
    INFO(header);
    CHECK(n_of(parse_rows(std::string(header) + ";n\n0.5;1.5\n")).wavelength_nm == Doubles{500});
  }
  for (const char* header :
       {"wavelength (A)", "wl_Å", "lambda [Angstrom]", "wavelength [Ångströms]", "wavelength (Å)"}) {
    INFO(header);
    CHECK(n_of(parse_rows(std::string(header) + ";n\n5000;1.5\n")).wavelength_nm == Doubles{500});
  }
  for (const char* header : {"energy_eV", "photon energy (eV)", "eV", "Photon_Energy [eV]"}) {
    INFO(header);
    CHECK(n_of(parse_rows(std::string(header) + ";n\n2;1.5\n")).first_nm() == Approx(619.92099216600));
  }
  CHECK(n_of(parse_rows("photon energy (eV)  n\n2 1.5\n")).size() == 1);
}

TEST_CASE("every name of a unit is found again") {
  for (const auto unit : {WavelengthUnit::nanometre, WavelengthUnit::micrometre, WavelengthUnit::angstrom,
                          WavelengthUnit::electronvolt})
    CHECK(wavelength_unit_named(name(unit)) == unit);
  CHECK(!wavelength_unit_named("mm"));
  CHECK(!wavelength_unit_named("cm-1"));
  CHECK(!wavelength_unit_named(""));
}

TEST_CASE("one table in four units gives one spectrum") {
  const Table nm = parse_rows("wavelength_nm,n\n400,1.5\n500,1.6\n");
  CHECK(n_of(parse_rows("wavelength_um,n\n0.4,1.5\n0.5,1.6\n")) == n_of(nm));
  CHECK(n_of(parse_rows("wavelength_A,n\n4000,1.5\n5000,1.6\n")) == n_of(nm));
  const Table ev = parse_rows("energy_eV,n\n2.4796839686640052,1.6\n3.0996049608300065,1.5\n");
  CHECK(ev.flags.none());  // ascending energy is in order
  CHECK(n_of(ev).value == n_of(nm).value);
  CHECK(n_of(ev).wavelength_nm[0] == Approx(400).epsilon(1e-15));
  CHECK(n_of(ev).wavelength_nm[1] == Approx(500).epsilon(1e-15));
}

TEST_CASE("a unit is never guessed: without one the table is refused, and the option wins over the header") {
  CHECK(contains(table_refusal("wavelength,n\n500,1.5\n"), "t.csv:1: no unit of wavelength"));
  CHECK(contains(table_refusal("energy,n\n2,1.5\n"), "t.csv:1: no unit of wavelength"));
  CHECK(contains(table_refusal("wavelength (mm),n\n2,1.5\n"), "t.csv:1: the unit \"mm\""));
  CHECK(contains(table_refusal("wavelength (eV),n\n2,1.5\n"), "t.csv:1: the unit \"eV\""));
  CHECK(n_of(parse_rows("wavelength,n\n0.5,1.5\n", in(WavelengthUnit::micrometre))).wavelength_nm ==
        Doubles{500});
  CHECK(n_of(parse_rows("wavelength_um,n\n500,1.5\n", in(WavelengthUnit::nanometre))).wavelength_nm ==
        Doubles{500});
}

TEST_CASE("a unit that puts every row outside 300 to 900 nm is refused with the one that would fit") {
  CHECK(contains(table_refusal("wavelength_nm,n\n0.4,1\n0.7,1\n"), "they would fit in um"));
  CHECK(contains(table_refusal("wavelength_um,n\n400,1\n700,1\n"), "they would fit in nm"));
  CHECK(contains(table_refusal("wavelength_nm,n\n4000,1\n7000,1\n"), "they would fit in A"));
  CHECK(contains(table_refusal("wavelength_nm,n\n20000,1\n"),
                 "no wavelength inside 300..900 nm: 20000..20000 nm"));
}

TEST_CASE("reflectance is a share or percent, and noise just outside it is clamped and flagged") {
  CHECK(r_of(parse_rows("wavelength_nm,R\n400,0.5\n")).value == Doubles{0.5});
  CHECK(r_of(parse_rows("wavelength_nm,R (%)\n400,50\n")).value == Doubles{0.5});
  CHECK(r_of(parse_rows("wavelength_nm;reflectance_percent\n400;50\n")).value == Doubles{0.5});
  const Table noisy = parse_rows("wavelength_nm,R\n400,-0.01\n500,1.01\n");
  CHECK(r_of(noisy).value == Doubles{0, 1});
  CHECK(noisy.flags.has(Flag::reflectance_clamped));
  CHECK(contains(table_refusal("wavelength_nm,R\n400,50\n"),
                 "t.csv:2: R = 50; expected 0 to 1 (in percent: name"));
  CHECK(contains(table_refusal("wavelength_nm,R\n400,-0.03\n"), "t.csv:2: R = -0.03"));
}

TEST_CASE("without a header the columns are named by the option") {
  CHECK(n_of(parse_rows("400 1.5 9\n700 1.4 9\n", named_columns({"wavelength_nm", "n", "_"}))) ==
        Spectrum{{400, 700}, {1.5, 1.4}});
  CHECK(contains(table_refusal("400 1.5\n"), "t.csv:1: numbers without a header"));
  CHECK(contains(table_refusal("400 1.5\n", named_columns({"wavelength_nm", "n", "k"})),
                 "t.csv:1: 2 columns; expected 3"));
  CHECK(contains(table_refusal("400 1.5\n", named_columns({"wavelength_nm", "x"})),
                 "columns: the column \"x\""));
  CHECK(contains(table_refusal("a b\n400 1.5\n", named_columns({"wavelength_nm", "n"})),
                 "t.csv:1: \"a\"; expected a finite number"));
}

TEST_CASE("a block of n and a block of k, each with its header, make one table") {
  const Table table =
      parse_rows("wl\tn\n0.4\t1.5\n0.8\t1.4\n\nwl\tk\n0.5\t0.1\n0.6\t0.2\n", in(WavelengthUnit::micrometre));
  CHECK(n_of(table) == Spectrum{{400, 800}, {1.5, 1.4}});
  CHECK(k_of(table) == Spectrum{{500, 600}, {0.1, 0.2}});
  CHECK(
      contains(table_refusal("wl_nm,n\n400,1\nwl_nm,n\n500,1\n"), "t.csv:3: the same column in both blocks"));
  CHECK(
      contains(table_refusal("wl_nm,n\n400,1\nwl_nm,k\n500,1\nwl_nm,k\n500,1\n"), "t.csv:5: a third header"));
  CHECK(contains(table_refusal("wl_nm,n\n400,1\nwl_nm,k\n"), "t.csv:3: a header without rows"));
}

TEST_CASE("rows out of order are sorted and flagged") {
  const Table table = parse_rows("wavelength_nm,n\n700,3\n400,1\n500,2\n");
  CHECK(n_of(table) == Spectrum{{400, 500, 700}, {1, 2, 3}});
  CHECK(table.flags.has(Flag::unsorted));
}

TEST_CASE("equal wavelengths are refused with both rows unless the first or the mean is asked for") {
  const std::string text = "wavelength_nm,n\n400,1\n500,2\n400,3\n";
  CHECK(contains(table_refusal(text),
                 "t.csv:4: wavelength 400 nm again; expected one row for it (the other is in line 2)"));
  CHECK(contains(table_refusal("energy_eV,n\n2,1\n2,2\n3,1\n"), "t.csv:3: wavelength 2 eV again"));
  const Table first = parse_rows(text, with_duplicates(Duplicates::first));
  CHECK(n_of(first).value == Doubles{1, 2});
  CHECK(first.flags.has(Flag::duplicate_wavelength));
  CHECK(n_of(parse_rows(text, with_duplicates(Duplicates::mean))).value == Doubles{2, 2});
  // A row that says the same twice is no question.
  const Table same = parse_rows("wavelength_nm,n\n400,1\n400,1\n");
  CHECK(same.flags.has(Flag::duplicate_dropped));
  CHECK(!same.flags.has(Flag::duplicate_wavelength));
}

TEST_CASE("a bad number is refused with its line") {
  const auto row = [](const std::string& text) {
    return table_refusal("wavelength_nm,n,k\n400,1.5,0\n" + text + "\n");
  };
  CHECK(contains(row("500,nan,0"), "t.csv:3: \"nan\"; expected a finite number"));
  CHECK(contains(row("nan,1,0"), "t.csv:3: \"nan\"; expected a finite number"));
  CHECK(contains(row("500,inf,0"), "t.csv:3: \"inf\""));
  CHECK(contains(row("500,,0"), "t.csv:3: \"\""));
  CHECK(contains(row("500,1"), "t.csv:3: 2 columns; expected 3"));
  CHECK(contains(row("500,1,0,0"), "t.csv:3: 4 columns; expected 3"));
  CHECK(contains(row("500,0,0"), "t.csv:3: n = 0 with k = 0; expected n above 0, or k above 0"));
  CHECK(contains(row("500,-1,0"), "t.csv:3: n = -1"));
  CHECK(contains(row("500,1,-1e-9"), "t.csv:3: k = -1e-09"));
  CHECK(contains(row("-500,1,0"), "t.csv:3: wavelength -500"));
  CHECK(contains(row("0,1,0"), "t.csv:3: wavelength 0"));
  CHECK(contains(row("\"500\"x,1,0"), "t.csv:3: 4 columns"));
}

TEST_CASE("decimal commas are read where no comma separates columns") {
  const Table points = parse_rows("wavelength_nm,n,k\n400,1.5,0\n500.5,1.25,0.1\n");
  const auto same = [&](const std::string& text) {
    const Table table = parse_rows(text);
    const auto& a = std::get<OpticalConstants>(points.optics);
    const auto& b = std::get<OpticalConstants>(table.optics);
    CHECK(std::get<Spectrum>(a.n).value == std::get<Spectrum>(b.n).value);
    CHECK(std::get<Spectrum>(a.n).wavelength_nm == std::get<Spectrum>(b.n).wavelength_nm);
    CHECK(a.k->value == b.k->value);
  };
  for (const std::string separator : {";", "\t", " ", " \t", "; "}) {
    const auto row = [&](const char* nm, const char* n, const char* k) {
      return nm + separator + n + separator + k + "\n";
    };
    same(row("wavelength_nm", "n", "k") + row("400", "1,5", "0") + row("500,5", "1,25", "0,1"));
  }
  same("wavelength_nm,n,k\n\"400\",\"1,5\",0\n\"500,5\",\"1,25\",\"0,1\"\n");
  // Commas beside points separate thousands, or columns.
  CHECK(contains(table_refusal("wl_nm;n\n400;1.5\n1,000;1.4\n"),
                 "t.csv:3: \"1,000\"; expected a number with '.' as those above, or without decimals"));
  CHECK(contains(table_refusal("wl_nm;n\n400;1,5\n500;1.4\n"), "t.csv:3: \"1.4\""));
  CHECK(contains(table_refusal("wl_nm;n\n400;1.000,5\n"), "t.csv:2: \"1.000,5\"; expected a finite number"));
  CHECK(contains(table_refusal("wl_nm;n\n400;1,0,5\n"), "t.csv:2: \"1,0,5\"; expected a finite number"));
  same("wavelength_nm,n,k\n400 ,1.5, 0\n500.5, 1.25 ,0.1\n");
}

TEST_CASE("a header that cannot be meant is refused") {
  CHECK(contains(table_refusal("wavelength_nm,n,T\n400,1,1\n"), "t.csv:1: the column \"T\""));
  CHECK(contains(table_refusal("n,k\n400,1\n"), "t.csv:1: no column of wavelength"));
  CHECK(
      contains(table_refusal("wl_nm,energy_eV,n\n400,3,1\n"), "t.csv:1: more than one column of wavelength"));
  CHECK(contains(table_refusal("wl_nm,n,n\n400,3,1\n"), "t.csv:1: the column \"n\" twice"));
  CHECK(contains(table_refusal("wl_nm\n400\n"), "t.csv:1: no column of n, k or R"));
  CHECK(contains(table_refusal("wl_nm,k\n400,1\n"), "t.csv:1: k without n"));
  CHECK(contains(table_refusal("wl_nm,n,R\n400,1,1\n"), "t.csv:1: both R and n"));
}

TEST_CASE("empty, comment-only and binary files are refused") {
  CHECK(table_refusal("") == "t.csv: the file is empty");
  CHECK(contains(table_refusal("# nothing\n\n"), "t.csv: no rows"));
  CHECK(contains(table_refusal(std::string_view("\x89PNG\r\n\x1A\n\0\0", 10)),
                 "t.csv:1: the column \"\\x89PNG\""));
  CHECK(contains(table_refusal("wl_nm,n\n"), "t.csv:1: a header without rows"));
}

TEST_CASE("a table of other quantities is read in the order of its columns, whatever these are called") {
  const auto columns =
      parse_columns("# a lamp\nwavelength_um;Watt;_;k\n0.5;-2;9;3e9\n0.4;1;9;0\n", "t.csv", 2);
  REQUIRE(columns.size() == 2);
  CHECK(columns[0].wavelength_nm == std::vector{400.0, 500.0});
  CHECK(columns[0].value == std::vector{1.0, -2.0});
  CHECK(columns[1].value == std::vector{0.0, 3e9});
  const auto said = [](std::string_view text, std::size_t count) {
    try {
      (void)parse_columns(text, "t.csv", count);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("read");
  };
  CHECK(said("nm,power,other\n400,1,2\n", 1) ==
        "t.csv:1: more columns; expected one of wavelength and 1 more");
  CHECK(said("nm,x\n400,1\n", 3) == "t.csv:1: too few columns; expected one of wavelength and 3 more");
  CHECK(said("nm,x\n400,1\nnm,y\n500,1\n", 1) == "t.csv:3: a second header; expected one");
}
