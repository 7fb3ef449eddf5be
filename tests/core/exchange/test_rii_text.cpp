// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "core/base/error.h"
#include "core/exchange/rii/rii_page.h"
#include "core/material/json.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

const std::string rows =
    "DATA:\n  - type: tabulated n\n    data: |\n        0.2 -1\n        0.3 1.5\n        0.9 1.4\n";

std::string page_of_references(const std::string& references, const std::string& rest = {}) {
  return "REFERENCES: |\n" + references + rest + rows;
}

Citation citation(const std::string& references) {
  return material_from_rii_page(page_of_references(references), "main/X/nk/Y.yml", "").datasets[0].citation;
}

Dataset dataset_of_page(const std::string& path, const std::string& rest = {}) {
  return material_from_rii_page(page_of_references("    A. Author.\n    A title.\n", rest), path, "")
      .datasets[0];
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("references, comments and temperature are read, blank and indented lines among them") {
  const auto read = [](const std::string& text) {
    return material_from_rii_page(text, "p.yml", "").datasets[0];
  };
  const auto data = read(page_of_references("    A. One.\n      <i>Two</i>\n\n    Three.\n\n",
                                            "COMMENTS: |\n    Film\nCONDITIONS:\n    temperature: 293\n"));
  CHECK(data.citation.authors == Names{"A. One"});
  CHECK(data.citation.title == "Two");
  CHECK(data.citation.published_in == "Three.");
  CHECK(data.note == "Film");
  CHECK(data.temperature_kelvin == 293.0);
  CHECK(read("COMMENTS: \"a \\\"b\\\"\"\n" + rows).note == "a \"b\"");
  CHECK(read("CONDITIONS:\n    temperature: 20 °C\n" + rows).temperature_kelvin == 293.15);
  CHECK(!read("CONDITIONS:\n    temperature: warm\n" + rows).temperature_kelvin);
}

TEST_CASE("a citation of three lines is taken apart") {
  const auto c = citation(
      "    P. B. One and R.-W. Two.\n    Optical constants of H<sub>2</sub>O &amp; ice.\n"
      "    <a href=\"https://doi.org/10.1103/None.6.4370\"><i>J. None B</i> <b>6</b>, 4370-4379 (1972)</a>\n");
  CHECK(c.authors == Names{"P. B. One", "R.-W. Two"});
  CHECK(c.title == "Optical constants of H2O & ice");
  CHECK(c.published_in == "J. None B 6, 4370-4379");
  CHECK(c.year == 1972);
  CHECK(c.doi == "10.1103/None.6.4370");
  CHECK(c.url.empty());
  CHECK(c.licence == "CC0-1.0");
  CHECK(c.via == "refractiveindex.info main/X/nk/Y");
}

TEST_CASE("a citation of one line is split behind the last author") {
  const auto stop =
      citation("    M. R. One. On indices, <a href=\"https://x.org/a\"><i>Report</i> 12 (1985)</a>\n");
  CHECK(stop.authors == Names{"M. R. One"});
  CHECK(stop.title == "On indices");
  CHECK(stop.published_in == "Report 12");
  CHECK(stop.url == "https://x.org/a");
  CHECK(stop.year == 1985);
  const auto comma = citation(
      "    L. One, F. Two and G. M. Three, Index of a thing, <a href=\"x\">J. <b>5</b>, 7, 2006</a>\n");
  CHECK(comma.authors == Names{"L. One", "F. Two", "G. M. Three"});
  CHECK(comma.title == "Index of a thing");
  CHECK(comma.published_in == "J. 5, 7");
  CHECK(comma.year == 2006);
}

TEST_CASE("of several references the first is taken, and a journal without a link is still one") {
  const auto c = citation(
      "    1) A. One et al.\n    A title.\n    <i>Journal</i> <b>1</b>, 2 (1913)<br>\n    2) B. Two.\n");
  CHECK(c.authors == Names{"A. One et al."});
  CHECK(c.title == "A title");
  CHECK(c.published_in == "Journal 1, 2");
  CHECK(c.year == 1913);
}

TEST_CASE("a maker's catalogue is title and author in one") {
  const auto c =
      citation("    <a href=\"https://x.org/m.agf\">MAKER Zemax catalog 2017-11</a> (obtained from there)\n");
  CHECK(c.authors == Names{"MAKER"});
  CHECK(c.title == "MAKER Zemax catalog 2017-11");
  CHECK(c.year == 2017);
}

TEST_CASE("the axis comes from the page's name, then from its conditions, then from its comments") {
  CHECK(dataset_of_page("main/X/nk/One-o.yml").axis == "ordinary");
  CHECK(dataset_of_page("main/X/nk/One-500K-e.yml").axis == "extraordinary");
  CHECK(dataset_of_page("main/X/nk/One-γ.yml").axis == "gamma");
  CHECK(dataset_of_page("main/X/nk/One-alpha.yml", "COMMENTS: |\n    Ordinary ray\n").axis == "alpha");
  CHECK(dataset_of_page("main/X/nk/One.yml", "CONDITIONS:\n    direction: beta\n").axis == "beta");
  CHECK(dataset_of_page("main/X/nk/One.yml", "COMMENTS: |\n    Extraordinary ray (e).\n").axis ==
        "extraordinary");
  CHECK(dataset_of_page("main/X/nk/o.yml").axis.empty());
}

TEST_CASE("ids and names come from the path, whatever characters it has") {
  const auto material =
      material_from_rii_page(page_of_references("    A.\n    T (1999)\n"),
                             "/x/database/data/organic/(C2H4)n - poly, odd/nk/Li-o.yml", "");
  CHECK(material.id == "c2h4_n_poly_odd");
  CHECK(material.name == "poly, odd");
  CHECK(material.datasets[0].id == "li-o-1999");
  CHECK(material.datasets[0].citation.via == "refractiveindex.info organic/(C2H4)n - poly, odd/nk/Li-o");
  CHECK(material_from_rii_page(rows, "specs/maker/optical/N-BK7.yml", "").id == "n_bk7");
  CHECK(material_from_rii_page(rows, "N-BK7.yml", "mine").id == "mine");
  CHECK(material_from_rii_page(rows, "+.yml", "").id == "material");
}

TEST_CASE("imported metals are metals, named by their sample") {
  const auto import = [](const char* path, const char* n_and_k) {
    const std::string table = "DATA:\n  - type: tabulated nk\n    data: |\n        0.3 " +
                              std::string(n_and_k) + "\n        0.9 " + n_and_k + "\n";
    return material_from_rii_page(
        "REFERENCES: |\n    D. I. One.\n    Films\n    <a href=\"x\"><i>J.</i> (2017)</a>\n" + table, path,
        "");
  };
  const Material gold = import("database/data/main/Au/nk/Yakubovsky-25nm.yml", "0.3 2.6");
  CHECK(gold.material_class == "metal");
  CHECK(gold.name == "Au, Yakubovsky 2017, 25 nm");
  CHECK(gold.id == "au");
  CHECK(import("main/W/nk/Rakic-LD.yml", "3.5 2.7").material_class == "metal");  // n is above k
  CHECK(import("main/W/nk/Rakic-LD.yml", "3.5 2.7").name == "W, Rakic 2017, LD");
  CHECK(import("main/TiN/nk/Beliaev-2017-b.yml", "0.9 2.1").material_class == "conductor");
  CHECK(import("main/TiN/nk/Beliaev-2017-b.yml", "0.9 2.1").name == "TiN, Beliaev 2017, b");
  CHECK(import("main/Si/nk/Green.yml", "4.08 0.028").material_class == "semiconductor");
  CHECK(import("main/Ge/nk/One.yml", "5.2 2.3").material_class == "semiconductor");
  CHECK(import("main/Ge/nk/One.yml", "5.2 2.3").name == "Ge");
  CHECK(import("main/C/nk/Diamond.yml", "2.42 0").material_class == "solid");
  CHECK(import("main/TiO2/nk/Rutile.yml", "2.8 1e-5").material_class == "solid");
  // Data that do not reach visible light tell nothing of it.
  const std::string infrared =
      "DATA:\n  - type: tabulated nk\n    data: |\n        0.36 1.4 0\n        0.5 1.4 0\n        9 0.5 2\n";
  CHECK(material_from_rii_page(infrared, "main/SiO2/nk/Ir.yml", "").material_class == "solid");
}

TEST_CASE("rows with n at or below zero outside the visible are left out of the material, flagged") {
  const auto data = dataset_of_page("main/X/nk/Y.yml");
  CHECK(std::get<Spectrum>(std::get<OpticalConstants>(data.optics).n).value == std::vector<double>{1.5, 1.4});
  CHECK(data.flags.has(Flag::n_not_positive));
}

TEST_CASE("an imported page survives being written as JSON, foreign bytes in its text included") {
  const auto material = material_from_rii_page(
      page_of_references("    A. \xFFuthor.\n    T\x01tle \xE0\x90\x91.\n"), "main/X/nk/\xFE.yml", "");
  CHECK(parse_material(format_material(material), "x.json") == material);
}

TEST_CASE("pages without linear n are not imported") {
  const auto refused = [](const std::string& text) {
    return error_of([&] { material_from_rii_page(text, "p.yml", ""); });
  };
  CHECK(refused("DATA:\n  - type: tabulated k\n    data: |\n        0.4 1\n") == "p.yml: no n given");
  CHECK(contains(refused("NAMES:\n  - x\n"), "p.yml: no linear optical constants"));
}
