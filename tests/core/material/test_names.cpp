// SPDX-License-Identifier: Apache-2.0
#include "core/material/names.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "core/base/error.h"
#include "core/material/embedded/unmeasured.h"
#include "core/material/library.h"
#include "tests/core/material/library_support.h"
#include "tests/growth.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

using Kind = NameDistance::Kind;

std::string found(std::string_view name) {
  const auto material = test::library().find(name);
  return material ? material->id : "";
}

std::vector<std::string> suggested(std::string_view name) {
  std::vector<std::string> out;
  for (const Suggestion& each : test::library().suggest(name)) out.push_back(each.id);
  return out;
}

}  // namespace

TEST_CASE("a formula is found in its own case only, so that tin is not TiN") {
  CHECK(found("TiN") == "titanium_nitride");
  for (const char* other : {"tin", "Tin", "TIN", "tiN"}) {
    INFO(other);
    CHECK(found(other).empty());
  }
  CHECK(found("Co") == "cobalt");
  CHECK(found("co").empty());
  CHECK(found("CO").empty());  // carbon monoxide
  CHECK(found("In") == "indium");
  CHECK(found("in").empty());
  CHECK(found("Pb") == "lead");
  CHECK(found("pb").empty());
  CHECK(found("Au") == "gold");
  CHECK(found("au").empty());
  CHECK(found("SiO2") == "fused_silica");
  CHECK(found("sio2").empty());
  CHECK(found("W") == "tungsten");
  CHECK(found("w").empty());
  // Abbreviations that read as formulas are listed in lower case too.
  CHECK(found("PC") == "polycarbonate");
  CHECK(found("pc") == "polycarbonate");
  CHECK(found("sf11") == "glass_sf11");
}

TEST_CASE("what reads as a chemical formula") {
  for (const char* formula : {"TiN", "Au", "W", "SiO2", "Au80Ag20", "Si0.47Ge0.53", "In2O3-SnO2",
                              "CH3NH3PbI3", "KH2PO4", "PC", "CuZn30"}) {
    INFO(formula);
    CHECK(is_formula(formula));
  }
  for (const char* word : {"", "tin", "Gold", "4H-SiC", "SiC film", "a-Si", "316", "ITO", "C26000", "-Au",
                           "Au-", "TiO2 anatase", "Jc", "ABS", "1"}) {
    INFO(word);
    CHECK(!is_formula(word));
  }
}

TEST_CASE("over the whole library no word stands for two materials, and none for another's formula") {
  std::map<std::string, std::string> words, formulas, folded_formulas;
  for (std::size_t i = 0; i < test::library().ids().size(); ++i) {
    const Material m = test::library().at(i);
    std::set<std::string> own;
    const auto claim = [&](std::map<std::string, std::string>& owners, const std::string& key) {
      const auto [place, fresh] = owners.try_emplace(key, m.id);
      INFO(key << " of " << m.id << " is taken by " << place->second);
      CHECK((fresh || place->second == m.id));
    };
    claim(words, folded_name(m.id));
    claim(words, folded_name(m.name));
    for (const std::string& alias : m.aliases) {
      INFO(m.id << ": " << alias);
      CHECK(own.insert(alias).second);
      CHECK(folded_name(alias) != folded_name(m.id));
      if (!is_formula(alias)) {
        claim(words, folded_name(alias));
        continue;
      }
      claim(formulas, alias);
      folded_formulas.try_emplace(folded_name(alias), m.id);
    }
  }
  for (const auto& [key, id] : words)
    if (const auto clash = folded_formulas.find(key); clash != folded_formulas.end()) {
      INFO(key << " is a word of " << id << " and a formula of " << clash->second);
      CHECK(clash->second == id);
    }
}

TEST_CASE("every name of every material finds it, and id wins over name, alias and formula") {
  for (std::size_t i = 0; i < test::library().ids().size(); ++i) {
    const Material m = test::library().at(i);
    INFO(m.id);
    CHECK(test::library().look_up(m.id)->kind == NameKind::id);
    CHECK(found(m.id) == m.id);
    CHECK(found(m.name) == m.id);
    for (const std::string& alias : m.aliases) {
      INFO(alias);
      CHECK(found(alias) == m.id);
    }
  }
}

TEST_CASE("a shared word wins, then letters exchanged or wrong") {
  CHECK(name_distance("bronze", "commercial bronze")->kind == Kind::word);
  CHECK(name_distance("steel", "stainless steel")->kind == Kind::word);
  CHECK(name_distance("stainless steel pipe", "stainless steel")->kind == Kind::word);
  CHECK(*name_distance("stainless", "stainless steel") == NameDistance{Kind::word, 5});
  CHECK(*name_distance("glod", "gold") == NameDistance{Kind::edits, 1});
  CHECK(name_distance("sio2", "SiO2")->kind == Kind::same);
  CHECK(*name_distance("alumnium", "aluminium") == NameDistance{Kind::edits, 1});
  CHECK(*name_distance("polycrabonat", "polycarbonate") == NameDistance{Kind::edits, 2});
  CHECK(NameDistance{Kind::word, 9} < NameDistance{Kind::edits, 1});
}

TEST_CASE("what is not near is not suggested") {
  CHECK(!name_distance("teflon", "lemon"));
  CHECK(!name_distance("lica", "silica"));       // a part of a word
  CHECK(!name_distance("foil", "soil"));         // another first letter
  CHECK(!name_distance("petal", "pearl"));       // two mistakes in five letters
  CHECK(!name_distance("white", "white gold"));  // a word that says nothing alone
  CHECK(!name_distance("skin", "indium"));
  CHECK(!name_distance("glod", "blood"));
  CHECK(!name_distance("bronze", "boron"));
  CHECK(!name_distance("bronze", "iron"));
  CHECK(!name_distance("bronze", "orange"));
  CHECK(!name_distance("x", "xps"));
  CHECK(!name_distance("", "gold"));
  CHECK(!name_distance("gold", ""));
  CHECK(suggested("qwertzuiop").empty());
  CHECK(suggested("").empty());
  CHECK(test::library().suggest("bronz", 0).empty());
}

TEST_CASE("a name of more than 100 bytes gets no suggestion, however long it is") {
  const std::string words = "gold " + std::string(95, 'x');
  CHECK(suggested(words).at(0) == "gold");
  CHECK(suggested(words + 'x').empty());
  const std::string megabyte(1 << 20, 'a');
  CHECK(seconds_of([&] { CHECK(test::library().missing(megabyte).expected.empty()); }, 1) < 0.1);
}

TEST_CASE("the nearest names of common mistakes") {
  CHECK(suggested("glod").at(0) == "gold");
  CHECK(suggested("golt").at(0) == "gold");
  CHECK(suggested("bronz").at(0) == "bronze_commercial");
  CHECK(suggested("alumnum").at(0) == "aluminum");
  CHECK(suggested("silverr").at(0) == "silver");
  CHECK(suggested("irn").at(0) == "iron");
  CHECK(suggested("chromuim").at(0) == "chromium");
  CHECK(suggested("sio2").at(0) == "fused_silica");
  CHECK(test::library().suggest("polycarbonat").at(0).text == "polycarbonate");
  // The alias that comes near is told, and each material once.
  CHECK(test::library().suggest("plexiglasss").at(0).text == "pmma (plexiglass)");
  const auto many = suggested("glass");
  CHECK(std::set<std::string>(many.begin(), many.end()).size() == many.size());
}

TEST_CASE("everyday words are answered by what was measured, or told to be without a measurement") {
  std::ifstream table(source_folder() + "/tests/data/everyday_words.csv");
  std::string line;
  REQUIRE(std::getline(table, line));
  CHECK(line == "word,answer");
  std::size_t words = 0, measured = 0;
  while (std::getline(table, line)) {
    const std::size_t comma = line.find(',');
    const std::string word = line.substr(0, comma), answer = line.substr(comma + 1);
    INFO(word << " should be " << answer);
    ++words;
    measured += answer != "unmeasured";
    CHECK(found(word) == (answer == "unmeasured" ? "" : answer));
    CHECK((test::library().unmeasured(word) != nullptr) == (answer == "unmeasured"));
  }
  CHECK(words > 180);
  CHECK(measured > 130);
}

TEST_CASE("a word without a measurement says why, and names what is measured and near") {
  const auto milk = test::library().missing("Milk");
  CHECK(contains(milk.found, "no open measurement known: "));
  CHECK(milk.expected.empty());  // nothing measured looks like it
  CHECK(test::library().missing("bone").expected == "what is measured and near: egg_shell_white");
  CHECK(contains(test::library().missing("tin").found, "730 nm"));
  const auto other = test::library().missing("glod");
  CHECK(other.found.empty());
  CHECK(contains(other.expected, "one of the nearest names: gold"));
  CHECK(test::library().missing("qwertzuiop").expected.empty());
  // A misspelt one would lead nowhere, too.
  CHECK(test::library().suggest("mlik").empty());
}

TEST_CASE("no word without a measurement names a material, and what is near to it is one") {
  const std::string file = source_folder() + "/resources/unmeasured.json";
  for (const Unmeasured& each : parse_unmeasured(slurp(file), file)) {
    for (const std::string& word : each.words) {
      INFO(word);
      CHECK(found(word).empty());
      CHECK(test::library().unmeasured(word) != nullptr);
      CHECK(*test::library().unmeasured(word) == each);
    }
    for (const std::string& id : each.nearest) CHECK(found(id) == id);
  }
}

TEST_CASE("a broken list of words without a measurement is refused") {
  const auto refusal = [](const std::string& things) {
    return error_of([&] {
      (void)parse_unmeasured(R"({"schema": "etak-unmeasured/1", "things": [)" + things + "]}", "u.json");
    });
  };
  CHECK(refusal(R"({"words": ["a"], "why": "b", "nearest": []})").empty());
  CHECK(contains(refusal(R"({"words": ["a", "A"], "why": "b", "nearest": []})"),
                 "u.json#/things/0/words: \"A\" again"));
  CHECK(contains(refusal(R"({"words": [], "why": "b", "nearest": []})"), "/things/0/words"));
  CHECK(contains(refusal(R"({"words": ["a"], "why": "", "nearest": []})"), "/things/0/why"));
  CHECK(contains(refusal(R"({"words": ["a"], "why": "b"})"), "nearest"));
  CHECK(contains(error_of([] { (void)parse_unmeasured("{}", "u.json"); }), "schema"));
}

TEST_CASE("a dataset is named by its id, its unique beginning, or with others by a star") {
  const Material gold = *test::library().find("gold");
  CHECK(&dataset_named(gold, "", "gold") == &gold.preferred_dataset());
  CHECK(dataset_named(gold, "johnson-1972", "gold").id == "johnson-1972");
  CHECK(dataset_named(gold, "john", "gold").id == "johnson-1972");
  CHECK(datasets_named(gold, "*", "gold").size() == gold.datasets.size());
  CHECK(datasets_named(gold, "john*", "gold").size() == 1);
  const Material aluminum = *test::library().find("aluminum");
  CHECK(contains(error_of([&] { (void)dataset_named(gold, "nobody", "gold"); }),
                 "gold: has no dataset nobody; expected"));
  CHECK(contains(error_of([&] { (void)dataset_named(gold, "*", "gold"); }),
                 "names " + std::to_string(gold.datasets.size())));
  // An id wins over the longer ones that begin with it.
  Material two = gold;
  two.datasets.resize(2);
  two.preferred = 0;
  two.datasets[0].id = "a-1972";
  two.datasets[1].id = "a-1972-2";
  CHECK(dataset_named(two, "a-1972", "x").id == "a-1972");
  const std::string both = error_of([&] { (void)dataset_named(two, "a-", "x"); });
  CHECK(contains(both, "x: more than one dataset begins with a-; expected one of a-1972, a-1972-2"));
}

TEST_CASE("a note says which steel steel is, and stands under a name of its material") {
  const Material steel = *test::library().find("steel");
  CHECK(contains(std::string(alias_note(steel.alias_notes, "Steel")), "stainless"));
  CHECK(alias_note(steel.alias_notes, "stainless_316").empty());
  for (std::size_t i = 0; i < test::library().ids().size(); ++i) {
    const Material m = test::library().at(i);
    for (const AliasNote& each : m.alias_notes) {
      INFO(m.id << ": " << each.alias);
      CHECK(found(each.alias) == m.id);
      CHECK(!each.note.empty());
    }
  }
}
