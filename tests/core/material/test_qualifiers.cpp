// SPDX-License-Identifier: Apache-2.0
#include "core/material/qualifiers.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <sstream>

#include "core/material/names.h"
#include "tests/core/material/library_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

std::string answered_by(std::string_view name) {
  const auto found = library().answer(name);
  return found ? found->material.id : "";
}

std::string note_on(std::string_view name) {
  const auto found = library().answer(name);
  return found ? found->note : "";
}

std::string near_to(std::string_view name) {
  std::string out;
  for (const Suggestion& each : library().suggest(name)) out += (out.empty() ? "" : ", ") + each.text;
  return out;
}

}  // namespace

TEST_CASE(
    "a word that changes something else than the material is answered by it, with what the word changes") {
  CHECK(answered_by("brushed aluminium") == "aluminum");
  CHECK(note_on("brushed aluminium") == "aluminum; brushed: a roughness, not an F0");
  CHECK(library().answer("Brushed-Aluminium")->by == NameKind::qualified);
  CHECK(answered_by("aluminium, anodized") == "aluminum");
  CHECK(contains(note_on("anodized aluminium"), "anodized: a layer of oxide"));
  CHECK(answered_by("tarnished silver") == "silver");
  CHECK(contains(note_on("tarnished silver"), "tarnished: a change of the surface"));
  CHECK(answered_by("polished TiN") == "titanium_nitride");
  CHECK(answered_by("wet polished concrete") == "concrete");
  CHECK(contains(note_on("wet polished concrete"), "wet: darker"));
  CHECK(contains(note_on("wet polished concrete"), "polished: a roughness"));
  // The note of the name that is left is said too.
  CHECK(contains(note_on("brushed steel"), "steel: AISI 316"));
  CHECK(answered_by("car paint").empty());
  CHECK(answered_by("red car paint") == "pigment_cadmium_red");
  CHECK(contains(note_on("red car paint"), "car: a lacquer"));
}

TEST_CASE("a coat is what is seen of a plated, gilded, rusty or painted thing") {
  CHECK(answered_by("chrome plating") == "chromium");
  CHECK(answered_by("chrome plated steel") == "chromium");
  CHECK(answered_by("gold-plated brass") == "gold");
  CHECK(answered_by("gilded wood") == "gold");
  CHECK(answered_by("rusty iron") == "rust");
  CHECK(answered_by("painted wood") == "painted_metal_grey");
  CHECK(answered_by("painted plastic") == "painted_metal_grey");
  CHECK(contains(note_on("painted wood"), "painted: it is what is seen"));
  CHECK(answered_by("plated steel").empty());
  CHECK(answered_by("painted qwertzuiop").empty());
}

TEST_CASE("a word of which the answer to the rest would mislead is not set aside") {
  CHECK(answered_by("blue glass") == "glass_bk7");
  CHECK(answered_by("black steel").empty());  // its oxide has another F0
  CHECK(answered_by("green apple").empty());  // the measured one is yellow
  CHECK(answered_by("white rice").empty());   // the measured one is brown
  CHECK(answered_by("copper pipe") == "copper");
  CHECK(answered_by("water pipe").empty());
  CHECK(answered_by("bread board").empty());
  CHECK(answered_by("polished white gold").empty());
  REQUIRE(library().unmeasured("polished white gold") != nullptr);
  CHECK(library().unmeasured("polished white gold")->words.front() == "white gold");
  CHECK(library().unmeasured("coffee table") == nullptr);
  CHECK(answered_by("dry ice").empty());
  CHECK(answered_by("brushed").empty());
  CHECK(answered_by("brushed polished").empty());
  CHECK(answered_by("a b c d e brushed gold").empty());
  CHECK(!library().find("brushed aluminium"));  // documents name materials exactly
}

TEST_CASE("a word says what it changes of those bodies only that it can be said of") {
  CHECK(answered_by("car tyre") == "tire");
  CHECK(note_on("car tyre").empty());  // a tire has no lacquer
  CHECK(answered_by("car leather").empty());
  CHECK(answered_by("toasted bread") == "bread");
  CHECK(answered_by("baked clay") == "terracotta");
  CHECK(answered_by("baked sand").empty());
  CHECK(answered_by("fried egg").empty());  // what is measured is the shell
  CHECK(library().unmeasured("fried egg") != nullptr);
  CHECK(contains(note_on("leather shoe"), "shoe: a thing made of it"));
  // A floor of marble is as opaque as marble.
  CHECK(contains(library().answer("marble floor")->material.body, "marble is opaque"));
  CHECK(contains(library().answer("vinyl flooring")->material.body, "dyed or filled"));
}

TEST_CASE("a qualifier is one word, in any case of letters") {
  for (const char* word : {"brushed", "Polished", "ANODISED", "plated"}) CHECK(qualifier(word) != nullptr);
  for (const char* word : {"", "brush", "gold", "brushed polished"}) CHECK(qualifier(word) == nullptr);
}

TEST_CASE("names are suggested by a whole word or one wrong letter, and nothing instead of nonsense") {
  CHECK(near_to("glod") == "gold");
  CHECK(near_to("alumnium") == "aluminum");
  CHECK(near_to("chromuimm") == "chromium");  // from eight letters on two mistakes
  for (const char* word : {"foil", "bacon", "flour", "steak", "petal", "carpet", "ink", "slime", "dust",
                           "lime", "cloud", "cheese", "gldo", "old red", "ham", "beef"}) {
    INFO(word);
    CHECK(near_to(word).empty());
  }
  CHECK(contains(near_to("silver spoon"), "silver"));
  CHECK(!contains(near_to("cherry"), "not measured"));
}

TEST_CASE("names that surprised are answered by what is meant, or say what they are answered by") {
  const std::map<std::string, std::string> wanted{{"polyester", "polyester_black"},
                                                  {"nylon", "nylon_red"},
                                                  {"rubber", "tire"},
                                                  {"walnut", "wood_walnut"},
                                                  {"walnuts", "walnut_nut"},
                                                  {"white paint", "pigment_titanium_white"},
                                                  {"paint black", "pigment_bone_black"},
                                                  {"ceramic tile", "porcelain"},
                                                  {"styrofoam", "foam_board"},
                                                  {"18k gold", "gold_18k_like"},
                                                  {"mirror", "silver"},
                                                  {"sea water", "water"}};
  for (const auto& [word, id] : wanted) {
    INFO(word);
    CHECK(answered_by(word) == id);
    CHECK(!note_on(word).empty());
  }
  for (const char* word : {"newspaper", "felt", "sponge"}) {
    INFO(word);
    CHECK(answered_by(word).empty());
    CHECK(library().unmeasured(word) != nullptr);
  }
}

TEST_CASE(
    "300 words that were listed before the library knew them: most are answered, and none by another material") {
  const std::string list = GENERATE("words.csv", "words_second.csv");
  std::ifstream table(source_folder() + "/tests/data/" + list);
  std::string line;
  REQUIRE(std::getline(table, line));
  CHECK(line == "word,group,answer");
  std::size_t words = 0, answered = 0;
  std::map<std::string, std::size_t> groups;
  while (std::getline(table, line)) {
    std::istringstream fields(line);
    std::string word, group, wanted;
    std::getline(fields, word, ',');
    std::getline(fields, group, ',');
    std::getline(fields, wanted);
    INFO(line);
    ++words;
    ++groups[group];
    answered += wanted != "unknown";
    CHECK(answered_by(word) == (wanted == "unknown" ? "" : wanted));
    if (wanted != "unknown" && library().answer(word)->by == NameKind::qualified)
      CHECK(contains(note_on(word), ": "));
  }
  CHECK(words == 150);
  CHECK(groups.size() == 4);
  CHECK(answered * 10 >= words * 6);
}
