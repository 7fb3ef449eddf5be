// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "app/cli/validate_targets.h"
#include "core/validate/finding.h"

namespace etak::cli {

/// Results of earlier runs, a small file each, by the content of the files they come from.
///   key   a hash of the files' bytes, their labels and roles, the settings, and this program: whatever could
///         change the result. A file is read for it, but no picture decoded.
/// Safe with several runs at once; a broken or foreign entry counts as none. Any thread may call.
class ResultCache {
 public:
  /// Makes the folder. Throws Error.
  ///   settings   hash of what the findings depend on
  ResultCache(const std::string& folder, const std::string& settings);

  /// Empty when a file cannot be read; such a target is not kept.
  std::string key_of(const FoundTarget& found) const;

  std::optional<CheckedFile> find(const std::string& key) const;
  void keep(const std::string& key, const CheckedFile& file) const;

 private:
  std::string entry(const std::string& key) const;
  std::string folder_, settings_;
};

/// A CheckedFile as JSON and back: doubles come back equal. Empty for one with a name that is no UTF-8.
std::string cache_text(const CheckedFile& file);
std::optional<CheckedFile> read_cache_text(const std::string& text);

}  // namespace etak::cli
