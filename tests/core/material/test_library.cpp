// SPDX-License-Identifier: Apache-2.0
#include "core/material/library.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "core/material/json.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;
namespace fs = std::filesystem;

namespace {

Material small_material(const std::string& id, const std::string& name, std::vector<std::string> aliases) {
  Material m;
  m.id = id;
  m.name = name;
  m.aliases = std::move(aliases);
  m.material_class = "metal";
  m.datasets.resize(1);
  m.datasets[0].id = "author-2000";
  m.datasets[0].optics = OpticalConstants{Spectrum{{300, 900}, {1.5, 1.5}}, {}};
  m.datasets[0].citation = {{"A. Author"}, "Title", "Journal 1", 2000, "", "", "CC0-1.0", "nowhere"};
  m.preferred_reason = "The only one.";
  return m;
}

void put_material(const TempFolder& folder, const std::string& file, const Material& m) {
  fs::create_directories(fs::path(folder.file(file)).parent_path());
  spit(folder.file(file), format_material(m));
}

}  // namespace

TEST_CASE("the built-in library holds every material file, value for value") {
  const auto library = MaterialLibrary::builtin();
  CHECK(std::is_sorted(library.ids().begin(), library.ids().end()));
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(source_folder() + "/materials")) {
    if (entry.path().extension() != ".json") continue;
    ++files;
    const Material m = parse_material(slurp(entry.path().string()), entry.path().string());
    INFO(m.id);
    const auto found = library.look_up(m.id);
    REQUIRE(found);
    CHECK((library.as_filed(found->index) == m));
  }
  CHECK(library.ids().size() == files);
  CHECK(files >= 401);  // 186 with n and k, 215 measured reflectances
  for (std::size_t i = 0; i < library.ids().size(); ++i) CHECK(library.at(i).id == library.ids()[i]);
}

TEST_CASE("a material is found by id, name and alias whatever case, spaces, hyphens and underscores") {
  const auto library = MaterialLibrary::builtin();
  for (const auto* name : {"gold", "Gold", "GOLD", "Au", " g-o_l d "}) {
    INFO(name);
    const auto found = library.find(name);
    REQUIRE(found);
    CHECK(found->id == "gold");
  }
  for (const auto& id : library.ids()) {
    const auto found = library.find(id);
    REQUIRE(found);
    CHECK(found->id == id);
  }
  CHECK(!library.find("unobtainium"));
  CHECK(!library.find(""));
  CHECK(!library.find("gold/johnson-1972"));
}

TEST_CASE("every dataset of the library says who measured it, and what its licence is") {
  const auto library = MaterialLibrary::builtin();
  for (std::size_t i = 0; i < library.ids().size(); ++i) {
    const Material m = library.at(i);
    INFO(m.id);
    CHECK(!m.preferred_reason.empty());
    for (const Dataset& d : m.datasets) {
      INFO(d.id);
      CHECK(!d.citation.licence.empty());
      CHECK(!d.citation.via.empty());
      CHECK(!one_line(d.citation).empty());
    }
  }
}

TEST_CASE("a folder adds materials and replaces those whose id is known") {
  const TempFolder folder;
  put_material(folder, "metal/gold.json", small_material("gold", "My gold", {"my-au"}));
  put_material(folder, "deep/er/testium.json", small_material("testium", "Testium", {"Tt"}));
  spit(folder.file("readme.txt"), "not a material");
  auto library = MaterialLibrary::builtin();
  const auto count = library.ids().size();
  library.add_folder(folder.path());
  CHECK(library.ids().size() == count + 1);
  CHECK(std::is_sorted(library.ids().begin(), library.ids().end()));
  CHECK(library.find("gold")->name == "My gold");
  CHECK(library.find("MY AU")->id == "gold");
  CHECK(library.find("tt")->id == "testium");
  CHECK(library.suggest("testiun").at(0).id == "testium");
  CHECK(library.find("silver")->id == "silver");
  for (std::size_t i = 0; i < library.ids().size(); ++i) CHECK(library.at(i).id == library.ids()[i]);
}

TEST_CASE("an id wins over another material's alias") {
  const TempFolder folder;
  put_material(folder, "a.json", small_material("aaa", "First", {"zzz"}));
  put_material(folder, "z.json", small_material("zzz", "Second", {}));
  auto library = MaterialLibrary::builtin();
  library.add_folder(folder.path());
  CHECK(library.find("zzz")->name == "Second");
}

TEST_CASE("a folder that cannot be used is an error that names the file") {
  const TempFolder folder;
  auto library = MaterialLibrary::builtin();
  const auto adding = [&](const std::string& path) { return error_of([&] { library.add_folder(path); }); };
  CHECK(contains(adding(folder.file("absent")), folder.file("absent")));
  CHECK(contains(adding(folder.path()), folder.path()));  // no *.json in it
  put_material(folder, "a.json", small_material("same", "A", {}));
  put_material(folder, "b.json", small_material("same", "B", {}));
  const std::string twice = adding(folder.path());
  CHECK(contains(twice, folder.file("b.json")));
  CHECK(contains(twice, "same"));
  spit(folder.file("b.json"), "{");
  CHECK(contains(adding(folder.path()), folder.file("b.json")));
  CHECK(contains(adding(folder.file("a.json")), folder.file("a.json")));  // a file, not a folder
}
