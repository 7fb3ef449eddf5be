// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/system.h"
#include "core/runs/cache_folder.h"

namespace etak {

/// The key of a result.
///   digest   of the bytes of its files, of all else that it depends on, and of this program. Empty when a file
///            cannot be read: no result is kept then
///   sha256   of the file that it was asked for
///   files    what was known of the files before their bytes were read
struct CacheKey {
  std::string digest, sha256;
  std::vector<sys::FileInfo> files;
};

/// Results of earlier runs in a CacheFolder, as texts. To look one up, the files that it depends on are read. Any
/// thread may call.
class ResultCache {
 public:
  /// Throws Error.
  ///   settings   what all results depend on, as text
  ///   version    of the program: results of other versions, and of other builds, count as none
  ResultCache(CacheOptions options, const std::string& settings, const std::string& version);

  /// The key of the result that depends on these files. Reads all of them.
  ///   identity    all else that decides the result, as bytes
  ///   sha256_of   the file whose SHA-256 is wanted as well; null: none
  CacheKey key_of(const std::string& identity, const std::vector<std::string>& files, SeenAsFile seen,
                  const std::string* sha256_of) const;

  /// The result of that key; none where there is none that counts.
  std::optional<std::string> find(const CacheKey& key);
  /// Keeps a result, except when the files have changed since key_of(): it may then belong to other bytes.
  void keep(const CacheKey& key, const std::vector<std::string>& files, const std::string& result);

  CacheFolder& folder() { return folder_; }

 private:
  CacheFolder folder_;
  std::string settings_;
};

/// The facts that the system knows of files, to be asked before they are read.
std::vector<sys::FileInfo> look_at(const std::vector<std::string>& paths);

/// Whether the files are what they were: device, inode, size and times, which change when a file is written.
bool are_unchanged(const std::vector<std::string>& paths, const std::vector<sys::FileInfo>& before);

}  // namespace etak
