// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/names/names.h"
#include "core/names/picture_sets.h"
#include "core/validate/config.h"

namespace etak {

/// Labels of files, and what the names of pictures tell. It remembers the folder it was asked for last, because
/// files of one folder mostly come one after the other: each thread has one of its own.
class PictureNamer {
 public:
  /// Configuration and reader must outlive this object.
  PictureNamer(const ValidateConfig& config, const NameReader& reader) : config_(config), reader_(reader) {}

  /// How reports call a file: relative to the root of the run.
  std::string label(const std::string& path);

  /// The picture with what its name tells; nullopt where that is no role.
  std::optional<NamedPicture> named(const std::string& path);

 private:
  const ValidateConfig& config_;
  const NameReader& reader_;
  std::string labelled_, label_;  // a folder, and how the labels of its files begin
};

}  // namespace etak
