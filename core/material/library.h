// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/material/material.h"

namespace etak {

/// All materials known to a run: those built into the program, and those of folders laid over them.
/// Built-in entries are decoded when asked for, so that one look-up touches one material.
class MaterialLibrary {
 public:
  /// The library inside the program (materials/**.json, preparsed when etak was built).
  static MaterialLibrary builtin();

  /// Adds every *.json below `folder`, in path order; a material whose id is known already replaces the old
  /// one. Throws Error for an unreadable or broken file, for a folder without any, and for an id twice in the
  /// folder.
  void add_folder(const std::string& folder);

  /// Lays one material over what is there, as add_folder() does.
  void add(Material material);

  /// Sorted by id.
  const std::vector<std::string>& ids() const { return ids_; }

  /// By id, alias or name; case, spaces, '-' and '_' do not matter. An id wins over an alias.
  /// "ID/DATASET" is the caller's business.
  std::optional<Material> find(std::string_view name) const;

  Material at(std::size_t index) const;

  /// The `count` names (ids) nearest to `name` by edit distance over ids, names and aliases, nearest first.
  std::vector<std::string> nearest(std::string_view name, std::size_t count = 3) const;

 private:
  struct Entry {
    std::string id, name;
    std::vector<std::string> aliases;
    std::vector<std::string> keys;  // folded id, name and aliases; the id's first
    std::size_t blob_offset = 0;    // into the built-in bytes, when material is empty
    std::optional<Material> material;
  };
  void insert(Entry entry);
  const Entry* entry(std::string_view name) const;

  std::vector<Entry> entries_;  // sorted by id
  std::vector<std::string> ids_;
};

}  // namespace etak
