// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/files/descriptor.h"
#include "core/validate/files/find_targets.h"
#include "core/validate/finding.h"

namespace etak {

/// The key of a result.
///   digest   SHA-256 of the bytes of the files, their labels and roles, the settings, and this program:
///            whatever could change the result. Empty when a file cannot be read: no result is kept then
///   stamps   device, inode, size and times of the files before their bytes were read
struct CacheKey {
  std::string digest, stamps;
};

/// The bytes of a --cache-key file. Throws Error, also for fewer than 16 bytes.
std::string read_cache_key(const std::string& path);

/// Results of earlier runs, a small file for each. To look one up, the files of its target are read, but no
/// picture is decoded.
///   seal   each entry begins with a checksum of its text and of the digest it belongs to, so that damage and
///          an entry under another's name count as none. With a key the checksum is an HMAC: entries of
///          writers without the key count as none too. Without one any writer can make any entry, so that the
///          folder is only for writers who are trusted
/// Below the folder no link is followed, neither to read nor to write. Safe with several runs at once. Any
/// thread may call.
class ResultCache {
 public:
  /// Makes the folder. Throws Error.
  ///   settings   the settings that the findings depend on, as text
  ///   version    of the program: results of other versions, and of other builds, count as none
  ///   key        of read_cache_key(); empty: none
  ResultCache(const std::string& folder, const std::string& settings, const std::string& version,
              std::string key);

  /// The key of a target. Reads all of its files.
  CacheKey key_of(const FoundTarget& found) const;

  /// The result of that key; nullopt: there is none that counts.
  std::optional<CheckedFile> find(const CacheKey& key) const;

  /// Keeps a result, except when the files have changed since key_of(): it may then belong to other bytes.
  void keep(const CacheKey& key, const FoundTarget& found, const CheckedFile& file) const;

 private:
  std::string seal_of(const std::string& digest, std::string_view text) const;
  Descriptor folder_of(const std::string& digest) const;
  static std::string name_of(const std::string& digest);

  Descriptor folder_;
  std::string settings_, key_;
};

/// A CheckedFile as JSON and back: doubles come back equal. Empty for one with a name that is no UTF-8.
std::string cache_text(const CheckedFile& file);
std::optional<CheckedFile> read_cache_text(const std::string& text);

}  // namespace etak
