// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/files/cache_folder.h"
#include "core/base/system.h"
#include "core/judge/finding.h"
#include "core/validate/files/find_targets.h"

namespace etak {

/// The key of a result.
///   digest   SHA-256 of the bytes of the files, their labels and roles, the settings, and this program:
///            whatever could change the result. Empty when a file cannot be read: no result is kept then
///   hashes   SHA-256 of each file
///   files    what was known of the files before their bytes were read
struct CacheKey {
  std::string digest;
  std::vector<std::string> hashes;
  std::vector<sys::FileInfo> files;
};

/// Results of earlier runs in a CacheFolder. To look one up, the files of its target are read, but no picture
/// is decoded. Any thread may call.
class ResultCache {
 public:
  /// Throws Error.
  ///   settings   the settings that the findings depend on, as text
  ///   version    of the program: results of other versions, and of other builds, count as none
  ResultCache(CacheOptions options, const std::string& settings, const std::string& version);

  /// The key of a target. Reads all of its files.
  CacheKey key_of(const FoundTarget& found) const;

  /// The result of that key; nullopt: there is none that counts.
  std::optional<CheckedFile> find(const CacheKey& key);

  /// Keeps a result, except when the files have changed since key_of(): it may then belong to other bytes.
  void keep(const CacheKey& key, const FoundTarget& found, const CheckedFile& file);

  CacheFolder& folder() { return folder_; }

 private:
  CacheFolder folder_;
  std::string settings_;
};

/// All that decides the result of a target besides the bytes of its files and the settings, as text.
std::string identity_of(const FoundTarget& found);

/// Whether the files are what they were: device, inode, size and times, which change when a file is written.
bool are_unchanged(const std::vector<std::string>& paths, const std::vector<sys::FileInfo>& before);

/// A CheckedFile as bytes and back: doubles come back equal. Nothing where the bytes are not of that form.
std::string result_text(const CheckedFile& file);
std::optional<CheckedFile> read_result_text(std::string_view bytes);

}  // namespace etak
