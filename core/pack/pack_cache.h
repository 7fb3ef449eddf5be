// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/files/output_folder.h"
#include "core/base/files/steady_file.h"
#include "core/runs/cache_folder.h"

namespace etak {

struct PackResult;

/// What is said of an atlas once it is packed, and said again where it comes from the cache.
///   text, json   the report, without the times of stages
///   verdict      one line; empty: the atlas was not checked
///   page         the HTML page, where it lies outside of the atlas's folder
struct PackTold {
  std::string text, json, findings, findings_in_colour, verdict;
  std::vector<std::string> remarks;
  bool failed = false, incomplete = false;
  std::optional<std::string> page;
};

/// All that decides the result of a job, besides the files that its input names.
///   input, output   paths as typed
///   settings        every setting, label and other value, as text
///   files           what is read besides the input and the files that it names: configurations, a choice
struct PackJobIdentity {
  std::string input, output, settings;
  std::vector<std::string> files;
};

/// An atlas that the cache holds: its files lie one after the other behind the entry's text.
struct KeptAtlas {
  struct File {
    std::string name, sha256;
    std::uint64_t size = 0;
  };
  PackTold told;
  std::vector<File> files;
  std::vector<std::string> inputs;
  CacheEntry entry;
};

/// Atlases of earlier runs. An atlas has two entries: one, found by the settings and the bytes of the input,
/// names the files that were read; the other one is found by the bytes of those as well. To look an atlas up,
/// all of these files are hashed, and none is decoded.
class PackCache {
 public:
  /// Throws Error.
  PackCache(CacheOptions options, const std::string& version, unsigned threads);

  /// The key of a job without the files that its input names; empty where something cannot be read.
  std::string key_of(const PackJobIdentity& job) const;
  std::optional<KeptAtlas> find(const std::string& key);

  /// Whether the folder holds just the files of the atlas, as they are.
  static bool is_in_place(const KeptAtlas& atlas, const std::string& output);

  /// The files of the atlas, ready to be put in place. Null where the entry is damaged, which then counts as a
  /// miss. Throws Error where they may not be written. Files of an earlier atlas that stay are told in `atlas`.
  std::unique_ptr<OutputFolder> restored(KeptAtlas& atlas, const std::string& output, bool overwrite);

  /// An atlas on its way into the cache.
  class Keeping {
   public:
    /// To be called when the atlas is in place and key_of() is still the same.
    void keep();

   private:
    friend class PackCache;
    std::string first_, list_;
    PackCache* cache_ = nullptr;
    std::optional<CacheFolder::NewEntry> atlas_;
  };
  /// Takes the files of an atlas before they are put in place. None where an input has changed since it was
  /// packed, and where there is nothing to keep them in.
  ///   key     of key_of(), from before the atlas was packed
  ///   names   of the files in the folder
  std::optional<Keeping> gather(const std::string& key, const PackResult& result, const PackTold& told,
                                const std::vector<std::string>& names, const OutputFolder& folder);

  CacheFolder& folder() { return folder_; }

 private:
  std::string second_key(const std::string& first, const std::vector<std::string>& files,
                         const std::vector<std::pair<std::string, FileStamp>>* expected) const;

  CacheFolder folder_;
  std::string program_;
  unsigned threads_;
};

}  // namespace etak
