// SPDX-License-Identifier: Apache-2.0
#include "core/material/library.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <tuple>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/paths.h"
#include "core/base/system.h"
#include "core/base/text/text.h"
#include "core/material/embedded/blob.h"
#include "core/material/embedded/library_words.h"
#include "core/material/json.h"
#include "core/material/names.h"
#include "core/material/optics/alloy.h"
#include "core/material/qualifiers.h"
#include "core/material/stack.h"
#include "core/material/stack_text.h"

namespace etak {
namespace {

FindStackPart part_of(const MaterialLibrary& library) {
  return [&](std::string_view name, const std::string& place) { return library_part(library, name, place); };
}

namespace fs = std::filesystem;

std::string_view builtin_blob() {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): words as bytes
  return {reinterpret_cast<const char*>(library_words), library_bytes};
}

std::vector<std::string> json_files(const std::string& folder, std::vector<std::string>* skipped) {
  std::vector<std::string> files;
  const auto unread = walk_folder(folder, true, [&](const FolderEntry& entry) {
    using Kind = sys::FileInfo::Kind;
    if (fs::path(entry.name).extension() != ".json" || entry.kind == Kind::folder) return;
    if (entry.kind == Kind::file)
      files.push_back(entry.path);
    else if (skipped != nullptr)
      skipped->push_back(entry.path);
  });
  if (unread)
    throw Error::at(unread->path, "cannot be opened: " + reason_of(unread->why),
                    "a folder of material files");
  if (files.empty()) throw Error::at(folder, "no *.json", "material files");
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::string_view name(NameKind kind) {
  constexpr std::array<std::string_view, 5> names{"id", "name", "alias", "formula", "qualified"};
  return names[static_cast<std::size_t>(kind)];
}

MaterialLibrary MaterialLibrary::builtin() {
  MaterialLibrary library;
  BlobIndex index = decode_index(builtin_blob());
  library.ids_.reserve(index.materials.size());
  library.entries_.reserve(index.materials.size());
  for (BlobEntry& e : index.materials) {
    library.ids_.push_back(e.id);
    Entry& entry =
        library.entries_.emplace_back(entry_of(std::move(e.id), std::move(e.name), std::move(e.aliases)));
    entry.blob_offset = e.offset;
  }
  for (BlobEntry& e : index.series) {
    Entry& entry =
        library.series_.emplace_back(entry_of(std::move(e.id), std::move(e.name), std::move(e.aliases)));
    entry.blob_offset = e.offset;
  }
  library.unmeasured_ = std::move(index.unmeasured);
  return library;
}

MaterialLibrary::Entry MaterialLibrary::entry_of(std::string id, std::string name,
                                                 std::vector<std::string> aliases) {
  Entry entry;
  entry.keys = {folded_name(id), folded_name(name)};
  for (const std::string& alias : aliases)
    if (is_formula(alias))
      entry.formulas.push_back(alias);
    else
      entry.keys.push_back(folded_name(alias));
  entry.id = std::move(id);
  entry.name = std::move(name);
  entry.aliases = std::move(aliases);
  return entry;
}

void MaterialLibrary::insert(Entry entry) {
  const auto place = std::lower_bound(ids_.begin(), ids_.end(), entry.id);
  const auto index = place - ids_.begin();
  if (place != ids_.end() && *place == entry.id) {
    entries_[static_cast<std::size_t>(index)] = std::move(entry);
    return;
  }
  ids_.insert(place, entry.id);
  entries_.insert(entries_.begin() + index, std::move(entry));
}

void MaterialLibrary::add_folder(const std::string& folder, std::vector<std::string>* skipped) {
  std::vector<std::pair<std::string, std::string>> seen;  // id, file
  for (const std::string& file : json_files(folder, skipped)) {
    Material material = parse_material(read_file(file), file);
    const auto twin =
        std::find_if(seen.begin(), seen.end(), [&](const auto& s) { return s.first == material.id; });
    if (twin != seen.end())
      throw Error::at(file, "id \"" + material.id + "\" again", "an id not used by " + twin->second);
    seen.emplace_back(material.id, file);
    add(std::move(material));
  }
}

void MaterialLibrary::add(Material material) {
  Entry entry = entry_of(material.id, material.name, material.aliases);
  entry.material = std::make_shared<const Material>(std::move(material));
  insert(std::move(entry));
}

std::optional<FoundName> MaterialLibrary::look_up(std::string_view name) const {
  return look_up(entries_, name);
}

std::optional<FoundName> MaterialLibrary::look_up(const std::vector<Entry>& entries, std::string_view name) {
  const std::string key = folded_name(name);
  if (key.empty()) return std::nullopt;
  std::optional<FoundName> best;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto offer = [&](NameKind kind) {
      if (!best || kind < best->kind) best = FoundName{i, kind};
    };
    const std::vector<std::string>& keys = entries[i].keys;
    if (const auto at = std::find(keys.begin(), keys.end(), key); at != keys.end())
      offer(static_cast<NameKind>(std::min<std::ptrdiff_t>(at - keys.begin(), 2)));
    for (const std::string& formula : entries[i].formulas)
      if (formula == name) offer(NameKind::formula);
    if (best && best->kind == NameKind::id) break;
  }
  return best;
}

std::optional<Material> MaterialLibrary::find(std::string_view name) const {
  if (is_stack_text(name)) return stack_material(name, part_of(*this));
  const auto found = look_up(name);
  if (!found) return alloy_of(name);
  Material out = at(found->index);
  out.body = alias_note(out.bodies, name);
  return out;
}

// What is left of a name without its qualifiers: a material and what the qualifiers change, or a thing
// without a measurement.
struct MaterialLibrary::Base {
  std::optional<LibraryAnswer> answer;
  const Unmeasured* thing = nullptr;
};

MaterialLibrary::Base MaterialLibrary::base_of(std::string_view name) const {
  Base out;
  for (const NameWithQualifiers& each : qualified_names(name)) {
    const Unmeasured* const thing = unmeasured_word(each.base);
    std::string base = each.base;
    if (thing == nullptr && !look_up(base)) continue;
    for (const auto& [word, qualifier] : each.words)
      if (!qualifier->seen.empty()) base = qualifier->seen;
    if (const auto found = look_up(base)) {
      LibraryAnswer answer{at(found->index), NameKind::qualified, {}};
      const std::string changes = qualifier_note(each, answer.material);
      if (changes.empty()) continue;
      answer.note = answer.material.id + "; " + changes;
      if (const std::string_view note = alias_note(answer.material.alias_notes, base); !note.empty())
        append(answer.note, "; ", base, ": ", note);
      answer.material.body = alias_note(answer.material.bodies, base);
      return {std::move(answer), nullptr};
    }
    // A coffee table tells nothing of coffee.
    const auto shape = [](const auto& word) { return word.second->of == solid_families; };
    if (out.thing == nullptr && std::none_of(each.words.begin(), each.words.end(), shape)) out.thing = thing;
  }
  return out;
}

std::optional<LibraryAnswer> MaterialLibrary::answer(std::string_view name) const {
  if (is_stack_text(name)) return LibraryAnswer{*find(name), NameKind::id, {}};
  if (const auto found = look_up(name)) {
    LibraryAnswer out{at(found->index), found->kind, {}};
    out.note = alias_note(out.material.alias_notes, name);
    out.material.body = alias_note(out.material.bodies, name);
    return out;
  }
  if (auto mixed = alloy_of(name)) {
    const std::string note = mixed->preferred_dataset().sample;
    return LibraryAnswer{std::move(*mixed), NameKind::id, note};
  }
  if (unmeasured_word(name) != nullptr) return std::nullopt;
  return base_of(name).answer;
}

std::optional<Material> MaterialLibrary::alloy_of(std::string_view text) const {
  const auto asked = read_alloy(text);
  if (!asked) return std::nullopt;
  // A folder's series goes before one of etak's.
  if (const auto own = look_up(asked->series))
    if (const Material material = as_filed(own->index); is_series(material))
      return alloy(material, asked->fraction, text);
  const auto found = look_up(series_, asked->series);
  if (!found) return std::nullopt;
  return alloy(decode_material(builtin_blob(), series_[found->index].blob_offset), asked->fraction, text);
}

Material MaterialLibrary::at(std::size_t index) const {
  Material out = as_filed(index);
  open_stacks(out, out.id, part_of(*this));
  return out;
}

Material MaterialLibrary::as_filed(std::size_t index) const {
  const Entry& e = entries_.at(index);
  return e.material ? *e.material : decode_material(builtin_blob(), e.blob_offset);
}

std::vector<Suggestion> MaterialLibrary::suggest(std::string_view name, std::size_t count) const {
  struct Ranked {
    NameDistance distance;
    std::string id;
    std::string alias;
  };
  std::vector<Ranked> ranked;
  for (const Entry& e : entries_) {
    std::optional<NameDistance> best;
    std::string alias;
    const auto offer = [&](const std::string& known) {
      const auto distance = name_distance(name, known);
      // "irn" is a misspelt iron rather than In: a formula is suggested only for its letters in another case.
      if (!distance || (distance->kind != NameDistance::Kind::same && is_formula(known))) return;
      if (best && *best <= *distance) return;
      best = distance;
      alias = known;
    };
    offer(e.id);
    offer(e.name);
    for (const std::string& known : e.aliases) offer(known);
    if (best) ranked.push_back({*best, e.id, std::move(alias)});
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
    return std::tie(a.distance, a.id) < std::tie(b.distance, b.id);
  });
  // Where names share a word with what was asked for, those with more than one wrong letter are left out.
  if (!ranked.empty() && ranked.front().distance.kind != NameDistance::Kind::edits)
    std::erase_if(ranked, [](const Ranked& r) {
      return r.distance.kind == NameDistance::Kind::edits && r.distance.amount > 1;
    });
  ranked.resize(std::min(count, ranked.size()));
  std::vector<Suggestion> out;
  for (const Ranked& each : ranked) {
    // An alias that the id contains is not shown beside it.
    const bool plain = folded_name(each.id).find(folded_name(each.alias)) != std::string::npos;
    out.push_back({plain ? each.id : each.id + " (" + each.alias + ")", each.id});
  }
  return out;
}

const Unmeasured* MaterialLibrary::unmeasured(std::string_view word) const {
  if (const Unmeasured* thing = unmeasured_word(word)) return thing;
  return look_up(word) ? nullptr : base_of(word).thing;
}

const Unmeasured* MaterialLibrary::unmeasured_word(std::string_view word) const {
  const std::string key = folded_name(word);
  for (const Unmeasured& each : unmeasured_)
    for (const std::string& known : each.words)
      if (folded_name(known) == key) return &each;
  return nullptr;
}

MaterialLibrary::Missing MaterialLibrary::missing(std::string_view name) const {
  Missing out;
  if (const auto asked = read_alloy(name)) {
    out.found = printable(asked->series) + " is no series of compositions";
    out.expected = "one of " + joined(series_, ", ", &Entry::id);
    return out;
  }
  if (const Unmeasured* thing = unmeasured(name)) {
    out.found = "no open measurement known: " + thing->why;
    if (!thing->nearest.empty()) out.expected = "what is measured and near: " + joined(thing->nearest);
    return out;
  }
  std::vector<std::string> near;
  for (Suggestion& each : suggest(name)) near.push_back(std::move(each.text));
  if (!near.empty()) out.expected = "one of the nearest names: " + joined(near);
  return out;
}

std::vector<std::string> environment_libraries() {
  const char* const paths = std::getenv("ETAK_LIBRARY");
  return parts_of(paths == nullptr ? "" : paths, ':');
}

MaterialLibrary known_library(const std::vector<std::string>& folders, std::vector<std::string>* skipped) {
  MaterialLibrary out = MaterialLibrary::builtin();
  for (const std::string& folder : environment_libraries()) out.add_folder(folder, skipped);
  for (const std::string& folder : folders) out.add_folder(folder, skipped);
  return out;
}

}  // namespace etak
