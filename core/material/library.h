// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/material/embedded/unmeasured.h"
#include "core/material/material.h"

namespace etak {

/// The kind of name by which a material was found; qualified: by a name with qualifiers around it.
enum class NameKind { id, name, alias, formula, qualified };
std::string_view name(NameKind kind);

/// The material that a name means, and what kind of name of it that is.
struct FoundName {
  std::size_t index = 0;  // into MaterialLibrary::ids()
  NameKind kind = NameKind::id;
};

/// What a name that a person typed is answered with.
struct LibraryAnswer {
  Material material;
  NameKind by = NameKind::id;
  std::string note;  // what must be said of the name: its alias_note(), and what its qualifiers change
};

/// A name that comes near to one that is not known.
struct Suggestion {
  std::string text;  // the id, with the alias that comes near in brackets
  std::string id;
};

/// All materials known to a run: those built into the program, and those of folders laid over them.
/// Built-in entries are decoded when asked for, so that one look-up touches one material.
class MaterialLibrary {
 public:
  /// The library inside the program (materials/**.json and resources/unmeasured.json, preparsed when etak was
  /// built).
  static MaterialLibrary builtin();

  /// Adds every *.json below `folder`, in path order; a material whose id is known already replaces the old
  /// one. Throws Error for an unreadable or broken file, for a folder without any, and for an id twice in the
  /// folder.
  ///   skipped   where given, gets the paths of what is called *.json and is no regular file, such as a pipe
  void add_folder(const std::string& folder, std::vector<std::string>* skipped = nullptr);

  /// Lays one material over what is there, as add_folder() does.
  void add(Material material);

  /// Sorted by id.
  const std::vector<std::string>& ids() const { return ids_; }

  /// Finds a material by id, then name, then alias, for which case, spaces, '-' and '_' do not matter, then by an alias that
  /// is a chemical formula (is_formula()), in its own case. "ID/DATASET" is the caller's business.
  std::optional<FoundName> look_up(std::string_view name) const;
  /// The material of that name. A text of layers ("water:2mm/copper") is a material of its own, and so is a composition of a
  /// series ("silver_gold:0.35", alloy.h); throws Error where a layer is not known, and as alloy() does.
  std::optional<Material> find(std::string_view name) const;

  /// find(), and where no material has the name the one that is left when the words around it are set aside
  /// that change something else than the material: "brushed aluminium". For names that a person asks for and
  /// that the note is shown to; documents name materials exactly.
  std::optional<LibraryAnswer> answer(std::string_view name) const;

  /// With the media of stacks looked up (open_stacks() in stack.h).
  Material at(std::size_t index) const;

  /// As its file has it: at() without what a stack's names stand for.
  Material as_filed(std::size_t index) const;

  /// Ids, names and aliases that come near to `name` (name_distance()), nearest first, each material once;
  /// none where nothing is near.
  std::vector<Suggestion> suggest(std::string_view name, std::size_t count = 5) const;

  /// The thing without a measurement that is called `word`, which may have qualifiers; null: none is.
  const Unmeasured* unmeasured(std::string_view word) const;

  /// What a message says of a name that find() does not know. Of a word without a measurement: why, and what
  /// is measured and near.
  ///   found      "no open measurement known: ..."; empty where the name is no such word
  ///   expected   "one of the nearest names: ..."; empty where nothing is near
  struct Missing {
    std::string found, expected;
  };
  Missing missing(std::string_view name) const;

 private:
  struct Entry {
    std::string id, name;
    std::vector<std::string> aliases;
    std::vector<std::string> keys;      // folded id, name and aliases that are no formulas, in this order
    std::vector<std::string> formulas;  // aliases that are
    std::size_t blob_offset = 0;        // into the built-in bytes, when there is no material
    std::shared_ptr<const Material> material;  // of a folder; apart, since the built-in ones have none
  };
  // A composition of a series; nothing for a text of another form, and of an unknown series.
  std::optional<Material> alloy_of(std::string_view text) const;
  struct Base;
  Base base_of(std::string_view name) const;
  const Unmeasured* unmeasured_word(std::string_view word) const;
  static std::optional<FoundName> look_up(const std::vector<Entry>& entries, std::string_view name);
  static Entry entry_of(std::string id, std::string name, std::vector<std::string> aliases);
  void insert(Entry entry);

  std::vector<Entry> entries_;  // sorted by id
  std::vector<Entry> series_;   // of compositions (alloy.h)
  std::vector<std::string> ids_;
  std::vector<Unmeasured> unmeasured_;
};

/// Gives the library when the first name is looked up, because most work on files never asks for one.
using LibraryWhenAsked = std::function<const MaterialLibrary&()>;

/// The folders that the environment variable ETAK_LIBRARY names, with ':' between.
std::vector<std::string> environment_libraries();

/// The materials that a program knows: the built-in ones, over them those of environment_libraries(), over
/// them those of `folders`. Throws Error as MaterialLibrary::add_folder() does.
///   skipped   where given, gets what add_folder() skips
MaterialLibrary known_library(const std::vector<std::string>& folders,
                              std::vector<std::string>* skipped = nullptr);

}  // namespace etak
