// SPDX-License-Identifier: Apache-2.0
#include "core/material/json.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "core/base/files/file.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

const std::string good = R"({
  "schema": "etak-material/1",
  "id": "testium",
  "name": "Testium",
  "aliases": ["Tt", "test metal"],
  "class": "metal",
  "preferred": "author-2000",
  "preferred_reason": "The only one.",
  "datasets": [
    {
      "id": "author-2000",
      "quantity": "n,k",
      "origin": "measured",
      "sample": "evaporated film",
      "temperature_kelvin": 293.15,
      "axis": "ordinary",
      "citation": {
        "authors": ["A. Author", "B. Author"],
        "title": "On testium",
        "published_in": "J. Tests 1, 2",
        "year": 2000,
        "doi": "10.1000/1",
        "url": "https://example.org/1",
        "licence": "CC0-1.0",
        "via": "collection page"
      },
      "flags": ["duplicate-wavelength"],
      "note": "Made up.",
      "unit": "um",
      "valid_range": [0.3, 0.9],
      "columns": ["wavelength", "n", "k"],
      "rows": [
        [0.3, 0.1879, 3.5],
        [0.5876, 0.2, 3.6],
        [0.9, 0.3, 3.7]
      ]
    }
  ]
}
)";

std::string with_change(const std::string& from, const std::string& to) {
  std::string text = good;
  const auto place = text.find(from);
  REQUIRE(place != std::string::npos);
  return text.replace(place, from.size(), to);
}

std::string json_complaint(const std::string& text) {
  const std::string message = error_of([&] { parse_material(text, "testium.json"); });
  INFO(message);
  CHECK(message.starts_with("testium.json"));
  CHECK(!contains(message, "\n"));
  return message;
}

// The material of `good` with other optics.
Material holding(const Optics& optics) {
  Material m = parse_material(good, "testium.json");
  m.datasets[0].optics = optics;
  m.datasets[0].flags = {};
  return m;
}

void round_trip(const Material& m) {
  const std::string text = format_material(m);
  const Material back = parse_material(text, "back.json");
  CHECK(back == m);
  CHECK(format_material(back) == text);
}

}  // namespace

TEST_CASE("a material file is read into values, wavelengths in nanometres") {
  const Material m = parse_material(good, "testium.json");
  CHECK(m.id == "testium");
  CHECK(m.name == "Testium");
  CHECK(m.aliases == std::vector<std::string>{"Tt", "test metal"});
  CHECK(m.material_class == "metal");
  REQUIRE(m.datasets.size() == 1);
  const Dataset& d = m.preferred_dataset();
  CHECK(d.id == "author-2000");
  CHECK(d.origin == Origin::measured);
  CHECK(d.temperature_kelvin == 293.15);
  CHECK(d.axis == "ordinary");
  CHECK(d.citation.authors.size() == 2);
  CHECK(d.citation.year == 2000);
  CHECK(d.flags.has(Flag::duplicate_wavelength));
  const auto& optics = std::get<OpticalConstants>(d.optics);
  const auto& n = std::get<Spectrum>(optics.n);
  REQUIRE(n.size() == 3);
  CHECK(n.wavelength_nm[1] == Approx(587.6).epsilon(1e-14));
  CHECK(n.value[0] == 0.1879);
  REQUIRE(optics.k);
  CHECK(optics.k->value == std::vector<double>{3.5, 3.6, 3.7});
}

TEST_CASE("what is written reads back equal, and writing it again gives the same bytes") {
  round_trip(parse_material(good, "testium.json"));
  SECTION("one row of data per line, figures as published") {
    const std::string text = format_material(parse_material(good, "testium.json"));
    CHECK(contains(text, "\n        [0.5876, 0.2, 3.6],\n"));
    CHECK(contains(text, "[0.3, 0.1879, 3.5]"));
    CHECK(text.back() == '\n');
  }
  SECTION("n alone") {
    round_trip(holding(OpticalConstants{Spectrum{{400, 589.3, 700}, {1.5, 1.49, 1.48}}, {}}));
  }
  SECTION("n and k on grids of their own") {
    round_trip(holding(
        OpticalConstants{Spectrum{{400, 700}, {1.5, 1.48}}, Spectrum{{350, 500, 900}, {1e-7, 2.5e-8, 0}}}));
  }
  SECTION("a formula, with and without k") {
    const DispersionFormula bk7{
        2, {0, 1.03961212, 0.00600069867, 0.231792344, 0.0200179144, 1.01046945, 103.560653}, 300, 2500};
    round_trip(holding(OpticalConstants{bk7, {}}));
    round_trip(holding(OpticalConstants{bk7, Spectrum{{300, 2325}, {2.8607e-6, 5e-6}}}));
  }
  SECTION("reflectance") {
    round_trip(holding(Reflectance{{{400, 410, 420}, {0, 0.5, 1}}}));
  }
  SECTION("quotes, control characters and other alphabets in texts") {
    Material m = parse_material(good, "testium.json");
    m.name = "Ca\"f\\2 \t Å µ 金";
    m.datasets[0].note = "line\nline";
    round_trip(m);
  }
  SECTION("wavelengths that no decimal micrometre names exactly") {
    Spectrum s;
    double nm = 300;
    for (int i = 0; i < 500; ++i) {
      s.wavelength_nm.push_back(nm);
      s.value.push_back(1 + 1.0 / (i + 3));
      nm *= 1.0017;
    }
    round_trip(holding(OpticalConstants{s, {}}));
  }
  SECTION("absent facts stay absent") {
    Material m = parse_material(good, "testium.json");
    m.aliases.clear();
    Dataset& d = m.datasets[0];
    d.temperature_kelvin.reset();
    d.axis = d.sample = d.note = "";
    d.flags = {};
    d.citation.year = 0;
    d.citation.doi = d.citation.url = "";
    round_trip(m);
    const std::string text = format_material(m);
    for (const auto* key : {"alias_notes", "group", "common", "temperature_kelvin", "axis", "flags", "note",
                            "year", "doi", "url"})
      CHECK(!contains(text, std::string("\"") + key + "\""));
  }
}

TEST_CASE(
    "notes on aliases, the group and commonness are read, written, and refused where they stand for nothing") {
  const std::string notes =
      R"("alias_notes": {"Tt": "its symbol", "testium": "its id"}, "group": "stone", "common": true, )";
  const Material m = parse_material(with_change("\"class\"", notes + "\"class\""), "testium.json");
  CHECK(m.group == "stone");
  CHECK(m.common);
  CHECK(m.alias_notes == std::vector<AliasNote>{{"Tt", "its symbol"}, {"testium", "its id"}});
  round_trip(m);
  CHECK(contains(json_complaint(with_change("\"class\"", R"("alias_notes": {"Xx": "a"}, "class")")),
                 "#/alias_notes: a note on \"Xx\""));
  CHECK(contains(json_complaint(with_change("\"class\"", R"("alias_notes": {"Tt": ""}, "class")")),
                 "#/alias_notes/Tt"));
  CHECK(contains(json_complaint(with_change("\"class\"", R"("alias_notes": ["Tt"], "class")")),
                 "#/alias_notes"));
  const std::string body = R"("bodies": {"Tt": "grains", "author-2000": "cells"}, "class")";
  const Material opaque = parse_material(with_change("\"class\"", body), "testium.json");
  CHECK(opaque.bodies == std::vector<AliasNote>{{"Tt", "grains"}, {"author-2000", "cells"}});
  round_trip(opaque);
  CHECK(contains(json_complaint(with_change("\"class\"", R"("bodies": {"Xx": "a"}, "class")")), "#/bodies"));
  CHECK(contains(json_complaint(with_change("\"class\"", R"("group": "Wood", "class")")), "#/group"));
  CHECK(contains(json_complaint(with_change("\"class\"", R"("common": 1, "class")")), "#/common"));
}

TEST_CASE(
    "every material file of the library stands under its id, class and group, and survives being written") {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source_folder() + "/materials")) {
    if (entry.path().extension() != ".json") continue;
    const std::string file = entry.path().string(), text = slurp(file);
    INFO(file);
    const Material m = parse_material(text, file);
    CHECK(m.id == entry.path().stem().string());
    const std::string folder = m.group == "film" ? m.group
                               : m.group.empty() ? m.material_class
                                                 : m.material_class + "/" + m.group;
    CHECK(file.ends_with("/" + folder + "/" + m.id + ".json"));
    CHECK((parse_material(format_material(m), file) == m));
  }
}

TEST_CASE("text that is no JSON is refused with line and column") {
  CHECK(contains(json_complaint("{\n  \"schema\": \"etak-material/1\",\n  oops\n}"), "line 3"));
  for (const std::string text :
       {"", " ", "{", "[", "null x", "{\"a\": 1,}",
        "\x7f"
        "ELF",
        "{\"schema\": NaN}", "{\"a\": 01}", "// comment\n{}", "'single'", "{\"a\": \"\xff\"}"}) {
    INFO(text);
    CHECK(!json_complaint(text).empty());
  }
  CHECK(!json_complaint(std::string("{\"a\0\": 1}", 9)).empty());
  CHECK(!json_complaint(good.substr(0, good.size() / 2)).empty());
  CHECK(!json_complaint(good + "x").empty());
}

TEST_CASE("a JSON value that is no object is refused") {
  for (const auto* text : {"null", "1", "\"x\"", "[]", "true"}) CHECK(!json_complaint(text).empty());
}

TEST_CASE("keys twice in one object are refused wherever they stand") {
  CHECK(contains(
      json_complaint(with_change("\"name\": \"Testium\",", "\"name\": \"Testium\", \"name\": \"Other\",")),
      "name"));
  CHECK(contains(json_complaint(with_change("\"year\": 2000,", "\"year\": 2000, \"year\": 2000,")), "year"));
  CHECK(contains(json_complaint(with_change("\"unit\": \"um\",", "\"unit\": \"um\", \"unit\": \"nm\",")),
                 "unit"));
}

TEST_CASE("deep nesting is refused, a million brackets included") {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  CHECK(contains(
      json_complaint(with_change("\"aliases\": [\"Tt\", \"test metal\"]", "\"aliases\": " + nested(20))),
      "16"));
  CHECK(!json_complaint(nested(1000000)).empty());
  CHECK(!json_complaint(std::string(1000000, '[')).empty());
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  CHECK(!json_complaint(objects).empty());
}

TEST_CASE("unknown and missing keys are named with their place") {
  CHECK(contains(json_complaint(with_change("\"aliases\"", "\"alias\"")), "alias"));
  CHECK(contains(json_complaint(with_change("\"year\": 2000,", "\"yaer\": 2000,")), "/datasets/0/citation"));
  CHECK(contains(json_complaint(with_change("\"year\": 2000,", "\"yaer\": 2000,")), "yaer"));
  CHECK(contains(json_complaint(with_change("\"note\": \"Made up.\",", "\"remark\": \"\",")), "/datasets/0"));
  for (const auto* line :
       {"  \"name\": \"Testium\",\n", "  \"preferred\": \"author-2000\",\n", "      \"unit\": \"um\",\n",
        "      \"quantity\": \"n,k\",\n", "        \"licence\": \"CC0-1.0\",\n",
        "      \"valid_range\": [0.3, 0.9],\n", "      \"columns\": [\"wavelength\", \"n\", \"k\"],\n"}) {
    INFO(line);
    const std::string message = json_complaint(with_change(line, ""));
    const std::string key = std::string(line).substr(std::string(line).find('"') + 1);
    CHECK(contains(message, key.substr(0, key.find('"'))));
  }
}

TEST_CASE("values of the wrong type are refused with their JSON pointer") {
  CHECK(contains(json_complaint(with_change("\"name\": \"Testium\"", "\"name\": 7")), "#/name"));
  CHECK(contains(json_complaint(with_change("[\"Tt\", \"test metal\"]", "[\"Tt\", 7]")), "#/aliases/1"));
  CHECK(contains(json_complaint(with_change("[\"Tt\", \"test metal\"]", "\"Tt\"")), "#/aliases"));
  CHECK(contains(json_complaint(with_change("\"year\": 2000", "\"year\": \"2000\"")),
                 "#/datasets/0/citation/year"));
  CHECK(contains(json_complaint(with_change("\"year\": 2000", "\"year\": 2000.5")),
                 "#/datasets/0/citation/year"));
  CHECK(contains(json_complaint(with_change("293.15", "\"293\"")), "#/datasets/0/temperature_kelvin"));
  CHECK(contains(json_complaint(with_change("[0.5876, 0.2, 3.6]", "[0.5876, \"0.2\", 3.6]")),
                 "#/datasets/0/rows/1"));
  CHECK(contains(json_complaint(with_change("[0.5876, 0.2, 3.6]", "[0.5876, 0.2]")), "#/datasets/0/rows/1"));
  CHECK(contains(json_complaint(with_change("[0.5876, 0.2, 3.6]", "[0.5876, 0.2, 3.6, 1]")),
                 "#/datasets/0/rows/1"));
  CHECK(contains(json_complaint(with_change("[0.5876, 0.2, 3.6]", "null")), "#/datasets/0/rows/1"));
  CHECK(contains(json_complaint(with_change("[0.3, 0.9]", "[0.3]")), "#/datasets/0/valid_range"));
}

TEST_CASE("values outside their domain are refused with their JSON pointer") {
  CHECK(contains(json_complaint(with_change("etak-material/1", "etak-material/2")), "#/schema"));
  CHECK(contains(json_complaint(with_change("\"id\": \"testium\"", "\"id\": \"Testium\"")), "#/id"));
  CHECK(contains(json_complaint(with_change("\"id\": \"testium\"", "\"id\": \"../testium\"")), "#/id"));
  CHECK(contains(json_complaint(with_change("\"class\": \"metal\"", "\"class\": \"metals\"")), "#/class"));
  CHECK(contains(
      json_complaint(with_change("\"preferred\": \"author-2000\"", "\"preferred\": \"author-2001\"")),
      "#/preferred"));
  CHECK(contains(json_complaint(with_change("\"origin\": \"measured\"", "\"origin\": \"guessed\"")),
                 "#/datasets/0/origin"));
  CHECK(contains(json_complaint(with_change("\"unit\": \"um\"", "\"unit\": \"mm\"")), "#/datasets/0/unit"));
  CHECK(contains(json_complaint(with_change("duplicate-wavelength", "duplicated")), "#/datasets/0/flags"));
  CHECK(
      contains(json_complaint(with_change("\"quantity\": \"n,k\"", "\"quantity\": \"n\"")), "#/datasets/0"));
  CHECK(contains(json_complaint(with_change("[0.3, 0.9]", "[0.3, 0.8]")), "#/datasets/0/valid_range"));
  SECTION("n below zero, or at zero without k, k below zero, numbers beyond a double") {
    for (const auto* row :
         {"[0.5876, -0.2, 3.6]", "[0.5876, 0.2, -1e-9]", "[0.5876, 1e5, 3.6]", "[0.5876, 0.2, 1e7]"}) {
      INFO(row);
      CHECK(contains(json_complaint(with_change("[0.5876, 0.2, 3.6]", row)), "#/datasets/0/rows/1"));
    }
    CHECK(contains(json_complaint(with_change("[0.5876, 0.2, 3.6]", "[0.5876, 0, 0]")),
                   "n = 0 with k = 0 at 587.6 nm"));
    CHECK(!json_complaint(with_change("[0.5876, 0.2, 3.6]", "[0.5876, 0.2, 1e999]")).empty());
    CHECK(!json_complaint(with_change("[0.5876, 0.2, 3.6]", "[0.5876, NaN, 3.6]")).empty());
    CHECK(!json_complaint(with_change("[0.5876, 0.2, 3.6]", "[0.5876, Infinity, 3.6]")).empty());
  }
  SECTION("rows not ascending, equal wavelengths, wavelength zero") {
    CHECK(contains(json_complaint(with_change("[0.5876, 0.2", "[0.95, 0.2")), "#/datasets/0/rows/2"));
    CHECK(contains(json_complaint(with_change("[0.5876, 0.2", "[0.3, 0.2")), "#/datasets/0/rows/1"));
    CHECK(contains(json_complaint(with_change("[0.3, 0.1879", "[0, 0.1879")), "#/datasets/0/rows/0"));
  }
  SECTION("no datasets, no rows, a dataset twice") {
    CHECK(contains(json_complaint(good.substr(0, good.find("\"datasets\"")) + "\"datasets\": []}"),
                   "#/datasets"));
    std::string empty = good;
    const auto first = empty.find("\"rows\": ["), last = empty.find("]\n    }\n");
    CHECK(contains(json_complaint(empty.replace(first, last - first, "\"rows\": [")), "#/datasets/0/rows"));
    std::string twice = good;
    const auto begin = twice.find("    {\n      \"id\": \"author-2000\""), end = twice.find("\n  ]\n}");
    const std::string dataset = twice.substr(begin, end - begin);
    CHECK(contains(json_complaint(twice.insert(end, ",\n" + dataset)), "#/datasets/1"));
  }
  SECTION("reflectance outside [0, 1]") {
    std::string text = format_material(holding(Reflectance{{{400, 410, 420}, {0, 0.5, 1}}}));
    const auto place = text.find("[0.41, 0.5]");
    REQUIRE(place != std::string::npos);
    CHECK(contains(json_complaint(text.replace(place, 11, "[0.41, 1.5]")), "#/datasets/0/rows/1"));
  }
  SECTION("formulas that are none") {
    const std::string text =
        format_material(holding(OpticalConstants{DispersionFormula{5, {1.5, 0.004, -2}, 400, 700}, {}}));
    const auto changed = [&](const std::string& from, const std::string& to) {
      std::string other = text;
      const auto place = other.find(from);
      REQUIRE(place != std::string::npos);
      return json_complaint(other.replace(place, from.size(), to));
    };
    CHECK(contains(changed("\"number\": 5", "\"number\": 10"), "/datasets/0/formula"));
    CHECK(contains(changed("\"number\": 5", "\"number\": 0"), "/datasets/0/formula"));
    CHECK(contains(changed("[1.5, 0.004, -2]", "[]"), "/datasets/0/formula"));
    CHECK(contains(changed("\"valid_range\": [0.4, 0.7]", "\"valid_range\": [0.7, 0.4]"), "/datasets/0"));
  }
}
