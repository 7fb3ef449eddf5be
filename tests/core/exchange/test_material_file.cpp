// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/material_file.h"

#include <catch2/catch.hpp>

#include "core/material/json.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr const char* table_text = "nm,n,k\n400,1.5,3\n700,1.6,4\n";
constexpr const char* page_text =
    "REFERENCES: |\n    A. Tester. Test data. J. Tests 1, 2 (2001)\nDATA:\n  - type: tabulated nk\n"
    "    data: |\n        0.4 1.6 0\n        0.7 1.5 0\n";

}  // namespace

TEST_CASE("the kind of a file is told by its ending, in any case, and by nothing else of its path") {
  CHECK(material_file_kind("a/b.YML") == MaterialFileKind::page);
  CHECK(material_file_kind("b.yaml") == MaterialFileKind::page);
  for (const char* name : {"b.csv", "b.Tsv", "b.txt", "b.DAT"})
    CHECK(material_file_kind(name) == MaterialFileKind::table);
  CHECK(material_file_kind("b.tar.json") == MaterialFileKind::material);
  for (const char* name : {"", "b", "csv", "a.csv/b", "b.csv ", "b.png"})
    CHECK(material_file_kind(name) == MaterialFileKind::none);
  for (const std::string_view ending : material_file_endings())
    CHECK(material_file_kind("x." + std::string(ending)) != MaterialFileKind::none);
}

TEST_CASE("without an ending the first bytes tell the kind; scenes and pictures are refused") {
  CHECK(material_content_kind(page_text, "pipe") == MaterialFileKind::page);
  CHECK(material_content_kind(table_text, "pipe") == MaterialFileKind::table);
  CHECK(material_content_kind("{\"schema\": \"etak-material/1\"}", "pipe") == MaterialFileKind::material);
  CHECK(contains(error_of([] { (void)material_content_kind("glTF", "pipe"); }), "pipe: holds a glTF scene"));
  CHECK(contains(error_of([] { (void)material_content_kind({"\0", 1}, "pipe"); }), "pipe: holds no text"));
}

TEST_CASE("prose is looked for in .txt and .dat files alone") {
  const char* const licence = "You may use this for any purpose.\n";
  CHECK(is_prose_file("LICENCE.Txt", licence));
  CHECK_FALSE(is_prose_file("table.txt", table_text));
  CHECK_FALSE(is_prose_file("broken.csv", licence));
  CHECK(may_be_prose("a/NOTES.TXT"));
  CHECK(may_be_prose("data.dat"));
  for (const char* name : {"b.csv", "b.tsv", "b.yml", "b.json", "txt"}) CHECK_FALSE(may_be_prose(name));
}

TEST_CASE("a table's material is named and identified by its file, and reads back as written") {
  const auto of = [](const std::string& path, std::string_view id = {}) {
    return material_of_text(table_text, path, MaterialFileKind::table, {}, id);
  };
  const Material plain = of("spectra/My Steel 2.csv");
  CHECK(plain.id == "my_steel_2");
  CHECK(plain.name == "My Steel 2");
  CHECK(plain.datasets.at(0).id == "my-steel-2");
  CHECK(plain.datasets[0].citation.title == "My Steel 2.csv");
  CHECK(of("spectra/x.csv", "given").id == "given");
  CHECK(of("spectra/x.csv", "given").name == "given");
  for (const std::string& path : {std::string("---.csv"), std::string(".csv"), std::string("\xCE\xB1.csv"),
                                  std::string(300, '\xFF') + ".csv", std::string(1200, 'a') + ".csv"}) {
    const Material made = of(path);
    INFO(made.name);
    CHECK(made.name.size() <= 1000);
    CHECK(parse_material(format_material(made), "written").name == made.name);
  }
}

TEST_CASE("rows that contradict each other are refused in a table, and averaged with a flag in a page") {
  const std::string twice = "nm,n\n400,1.5\n500,1.5\n500,1.7\n700,1.6\n";
  CHECK(contains(error_of([&] { (void)material_of_text(twice, "t.csv", MaterialFileKind::table); }),
                 "500 nm again"));
  TableOptions first;
  first.duplicates = Duplicates::first;
  CHECK(material_of_text(twice, "t.csv", MaterialFileKind::table, first)
            .datasets[0]
            .flags.has(Flag::duplicate_wavelength));
  const std::string text = std::string(page_text) + "        0.7 1.7 0\n";
  const Material averaged = material_of_text(text, "p.yml", MaterialFileKind::page);
  CHECK(averaged.datasets[0].flags.has(Flag::duplicate_wavelength));
  const auto& n = std::get<Spectrum>(std::get<OpticalConstants>(averaged.datasets[0].optics).n);
  CHECK(n.value.back() == Approx(1.6));
}
