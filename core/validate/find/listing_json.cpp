// SPDX-License-Identifier: Apache-2.0
// The forms of etak validate --list-files.
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/findings/output/formats.h"
#include "core/validate/find/listing.h"

namespace etak {
namespace {

std::vector<std::string> channel_words_of(const ParsedName& parsed) {
  std::vector<std::string> out;
  for (const char letter : parsed.channels) out.emplace_back(channel_word(letter));
  while (!out.empty() && out.back() == "none") out.pop_back();
  return out;
}

// "base-color", "metal-rough (occlusion, roughness, metallic)", "normal (opengl)".
std::string role_text(const ListedFile& file) {
  std::string more = joined(channel_words_of(file.parsed));
  if (file.parsed.green != GreenAxis::unsaid) more = name(file.parsed.green);
  if (file.role.empty()) return file.as == ListedAs::judged ? "texture" : "?";
  return file.role + (more.empty() ? "" : " (" + more + ')');
}

// "4k png, tile 1001, lod0".
std::string form_text(const ParsedName& parsed) {
  std::string out = parsed.resolution;
  const auto add = [&](const std::string& word, const char* between) {
    if (!word.empty()) (out += out.empty() ? "" : between) += word;
  };
  add(parsed.format, " ");
  add(parsed.tile.empty() ? "" : "tile " + parsed.tile, ", ");
  add(parsed.lod, ", ");
  add(parsed.version, ", ");
  add(parsed.number.empty() ? "" : "number " + parsed.number, ", ");
  return out;
}

bool was_read(const ListedFile& file) {
  return !file.set.empty();
}

}  // namespace

std::string file_list_text(const FileList& list) {
  std::string out;
  std::map<ListedAs, std::size_t> counts;
  for (const ListedFile& file : list.files) {
    ++counts[file.as];
    std::string line = shown_path(file.file, list.typed) + ": " + role_text(file);
    if (was_read(file)) {
      line += " of " + shown_path(file.set, list.typed) + ", " + std::string(name(file.parsed.convention));
      if (const std::string form = form_text(file.parsed); !form.empty()) line += ", " + form;
    }
    line += "; " + std::string(name(file.as));
    if (!file.note.empty()) line += ": " + file.note;
    out += line_text(line) + '\n';
  }
  std::string sum;
  for (const auto& [as, count] : counts)
    (sum += sum.empty() ? "" : ", ") += grouped(count) + ' ' + std::string(name(as));
  if (list.others > 0) (sum += sum.empty() ? "" : ", ") += grouped(list.others) + " of other kinds";
  return out + (sum.empty() ? "no files" : sum) + ".\n";
}

std::string file_list_json(const FileList& list) {
  using Json = nlohmann::ordered_json;
  Json out = Json::object();
  out["schema"] = "etak-files/1";
  out["files"] = Json::array();
  for (const ListedFile& file : list.files) {
    Json row = Json::object();
    row["file"] = file.file;
    row["state"] = name(file.as);
    row["role"] = file.role.empty() ? Json(nullptr) : Json(file.role);
    row["note"] = file.note;
    if (was_read(file)) {
      const ParsedName& parsed = file.parsed;
      row["set"] = file.set;
      row["convention"] = name(parsed.convention);
      row["channels"] = channel_words_of(parsed);
      row["green"] = name(parsed.green);
      row["resolution"] = parsed.resolution;
      row["format"] = parsed.format;
      row["tile"] = parsed.tile;
      row["lod"] = parsed.lod;
      row["version"] = parsed.version;
      row["number"] = parsed.number;
    }
    out["files"].push_back(std::move(row));
  }
  out["others"] = list.others;
  return quiet_json(out.dump(2, ' ', false, Json::error_handler_t::replace)) + '\n';
}

}  // namespace etak
