// SPDX-License-Identifier: Apache-2.0
// etak_embed OUT FOLDER: reads every material file below FOLDER and writes the bytes that become the built-in
// library. Run by the build; a broken, twice named or misplaced material fails it.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/material/blob.h"
#include "core/material/json.h"

namespace fs = std::filesystem;

namespace {

void check_place(const etak::Material& m, const fs::path& file) {
  if (file.stem() != m.id || file.parent_path().filename() != m.material_class)
    throw etak::Error::at(file.string(), "id " + m.id + " of class " + m.material_class,
                          "the file " + m.material_class + "/" + m.id + ".json");
}

void embed(const std::string& out, const std::string& folder) {
  std::map<std::string, etak::Material> by_id;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    const std::string file = entry.path().string();
    etak::Material m = etak::parse_material(etak::read_file(file), file);
    check_place(m, entry.path());
    const auto [place, is_new] = by_id.emplace(m.id, std::move(m));
    if (!is_new) throw etak::Error::at(file, "id \"" + place->first + "\" again", "each id once");
  }
  std::vector<etak::Material> materials;
  for (auto& [id, material] : by_id) materials.push_back(std::move(material));
  etak::write_file(out, etak::encode_library(materials), true);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: etak_embed OUT FOLDER\n");
    return 2;
  }
  try {
    embed(argv[1], argv[2]);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "etak_embed: %s\n", e.what());
    return 2;
  }
}
