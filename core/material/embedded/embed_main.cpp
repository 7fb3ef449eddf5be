// SPDX-License-Identifier: Apache-2.0
// etak_embed OUT FOLDER SERIES UNMEASURED: reads every material file below FOLDER, every series of compositions below SERIES
// and the list of words without a measurement, and writes the C++ source of the built-in library (library_words.h). Run by the
// build; a broken, twice named or misplaced material fails it, and so does an unknown id near to such a word.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/system.h"
#include "core/material/embedded/blob.h"
#include "core/material/json.h"
#include "core/material/optics/alloy.h"

namespace fs = std::filesystem;

namespace {

void check_place(const etak::Material& m, const fs::path& file) {
  // Stacks of layers stand together, whatever their bases are.
  const std::string folder = m.group == "film" ? m.group
                             : m.group.empty() ? m.material_class
                                               : m.material_class + "/" + m.group;
  const std::string expected = folder + "/" + m.id + ".json";
  if (!file.generic_string().ends_with("/" + expected))
    throw etak::Error::at(
        etak::sys::path_text(file),
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

// This program runs on the machine that the library is for, or on one that imitates it, so that words have the
// order of bytes that they need.
std::string source_of(std::string_view bytes) {
  std::string out =
      "#include \"core/material/embedded/library_words.h\"\nnamespace etak {\nconst std::size_t library_bytes = " +
      std::to_string(bytes.size()) + ";\nconst std::uint64_t library_words[] = {\n";
  constexpr std::size_t word_bytes = sizeof(std::uint64_t), words_of_line = 8;
  for (std::size_t at = 0; at < bytes.size(); at += word_bytes) {
    const std::string_view part = bytes.substr(at, word_bytes);
    std::uint64_t word = 0;
    std::memcpy(&word, part.data(), part.size());
    std::array<char, 20> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), word, 16).ptr;
    out.append("0x")
        .append(digits.data(), end)
        .append(at / word_bytes % words_of_line == words_of_line - 1 ? ",\n" : ",");
  }
  return out + "};\n}  // namespace etak\n";
}

// All below a folder, by their ids.
//   check   of each, with its file
std::map<std::string, etak::Material> read_folder(const std::string& folder,
                                                  void (*check)(const etak::Material&, const fs::path&)) {
  std::map<std::string, etak::Material> by_id;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    const std::string file = etak::sys::path_text(entry.path());
    etak::Material m = etak::parse_material(etak::read_file(file), file);
    check(m, entry.path());
    const auto [place, is_new] = by_id.emplace(m.id, std::move(m));
    if (!is_new) throw etak::Error::at(file, "id \"" + place->first + "\" again", "each id once");
  }
  return by_id;
}

void check_series(const etak::Material& m, const fs::path& file) {
  if (!etak::is_series(m) || file.stem() != m.id)
    throw etak::Error::at(etak::sys::path_text(file), "no series of compositions " + m.id,
                          "tables of n and k with fractions as their ids, in the file of the series' id");
}

std::vector<etak::Material> values_of(std::map<std::string, etak::Material> by_id) {
  std::vector<etak::Material> out;
  for (auto& [id, material] : by_id) out.push_back(std::move(material));
  return out;
}

void embed(const std::string& out, const std::string& folder, const std::string& series,
           const std::string& unmeasured_file) {
  auto by_id = read_folder(folder, check_place);
  const std::vector<etak::Unmeasured> unmeasured = read_unmeasured(unmeasured_file, by_id);
  const std::string bytes = etak::encode_library(values_of(std::move(by_id)),
                                                 values_of(read_folder(series, check_series)), unmeasured);
  etak::write_file(out, source_of(bytes), true);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fprintf(stderr, "usage: etak_embed OUT FOLDER SERIES UNMEASURED\n");
    return 2;
  }
  try {
    embed(argv[1], argv[2], argv[3], argv[4]);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "etak_embed: %s\n", e.what());
    return 2;
  }
}
