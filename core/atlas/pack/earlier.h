// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/atlas/layout.h"
#include "core/base/files/output_target.h"

namespace etak {

/// An atlas of etak that a folder holds already.
struct EarlierAtlas {
  std::string folder;
  std::optional<AtlasLayout>
      layout;                      // none: no layout of ours lies there, so nothing there is ours to replace
  std::vector<std::string> files;  // that are of it

  /// Whether every file of it is there still.
  bool is_whole() const;
};

EarlierAtlas earlier_atlas(const std::string& folder);

/// Files of an earlier atlas are replaced; which others may be says refuse_stranger().
inline Replace may_replace(bool overwrite) {
  return overwrite ? Replace::anything : Replace::files;
}

/// Throws Error where `name` lies in the folder, is of no earlier atlas and may not be overwritten.
void refuse_stranger(const EarlierAtlas& earlier, const std::string& name, bool overwrite);

/// Before the work: whether the folder can be made or changed, and files that are not ours stay. Throws
/// Error.
void check_place(const EarlierAtlas& earlier, bool overwrite);

}  // namespace etak
