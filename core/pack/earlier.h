// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/atlas/layout.h"
#include "core/base/files/output_folder.h"
#include "core/base/files/output_target.h"
#include "core/base/files/read_places.h"

namespace etak {

/// An atlas of etak that a folder holds already.
struct EarlierAtlas {
  std::string folder;
  std::optional<AtlasLayout>
      layout;                      // none: the folder holds no layout of etak, so no file of it is replaced
  std::vector<std::string> files;  // that are of it
  ReadPlaces inputs;               // of the new atlas, which no file of it takes the place of

  /// Whether every file of it is there still.
  bool is_whole() const;
};

EarlierAtlas earlier_atlas(const std::string& folder);

/// Files of an earlier atlas are replaced; refuse_stranger() decides on other files.
inline Replace may_replace(bool overwrite) {
  return overwrite ? Replace::anything : Replace::files;
}

/// Throws Error where `name` lies in the folder and is an input, or is of no earlier atlas and may not be overwritten.
void refuse_stranger(const EarlierAtlas& earlier, const std::string& name, bool overwrite);

/// Has the files of the earlier atlas that the new one lacks removed, where they still hold what their layout says that
/// etak wrote: a layout may come from anyone, and name anything. Returns what is to be said of the others; empty: there
/// are none.
///   names   files of the new atlas
std::string remove_earlier(OutputFolder& folder, const EarlierAtlas& earlier,
                           const std::set<std::string>& names);

/// Throws Error, before the work begins, where the folder cannot be made or changed, or where a file that
/// is of no earlier atlas would be replaced.
void check_place(const EarlierAtlas& earlier, bool overwrite);

}  // namespace etak
