// SPDX-License-Identifier: Apache-2.0
// etak_embed OUT FOLDER UNMEASURED: reads every material file below FOLDER and the list of words without a
// measurement, and writes the bytes that become the built-in library. Run by the build; a broken, twice named
// or misplaced material fails it, and so does an unknown id near to such a word.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/material/embedded/blob.h"
#include "core/material/json.h"

namespace fs = std::filesystem;

namespace {

void check_place(const etak::Material& m, const fs::path& file) {
  const std::string expected =
      m.material_class + "/" + (m.group.empty() ? "" : m.group + "/") + m.id + ".json";
  if (!file.generic_string().ends_with("/" + expected))
    throw etak::Error::at(
        file.string(),
        "id " + m.id + " of class " + m.material_class + (m.group.empty() ? "" : ", group " + m.group),
        "the file " + expected);
}

std::vector<etak::Unmeasured> read_unmeasured(const std::string& file,
                                              const std::map<std::string, etak::Material>& by_id) {
  std::vector<etak::Unmeasured> out = etak::parse_unmeasured(etak::read_file(file), file);
  for (const etak::Unmeasured& each : out)
    for (const std::string& id : each.nearest)
      if (by_id.count(id) == 0)
        throw etak::Error::at(file, "\"" + id + "\" near to " + each.words.front(), "ids of materials");
  return out;
}

void embed(const std::string& out, const std::string& folder, const std::string& unmeasured_file) {
  std::map<std::string, etak::Material> by_id;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    const std::string file = entry.path().string();
    etak::Material m = etak::parse_material(etak::read_file(file), file);
    check_place(m, entry.path());
    const auto [place, is_new] = by_id.emplace(m.id, std::move(m));
    if (!is_new) throw etak::Error::at(file, "id \"" + place->first + "\" again", "each id once");
  }
  const std::vector<etak::Unmeasured> unmeasured = read_unmeasured(unmeasured_file, by_id);
  std::vector<etak::Material> materials;
  for (auto& [id, material] : by_id) materials.push_back(std::move(material));
  etak::write_file(out, etak::encode_library(materials, unmeasured), true);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: etak_embed OUT FOLDER UNMEASURED\n");
    return 2;
  }
  try {
    embed(argv[1], argv[2], argv[3]);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "etak_embed: %s\n", e.what());
    return 2;
  }
}
