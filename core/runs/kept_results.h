// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/runs/result_cache.h"

namespace etak {

/// Results in the memory of a program that checks the same files again and again. Each is made again only where
/// one of its files, or something else that decides it, is not as it was. Any thread may call.
///   identity   of a result: all that decides it besides the bytes of its files and the settings, as bytes
///   files      that it depends on
template <class Result>
class KeptResults {
 public:
  /// To be called at the beginning of a run, by the settings of which results count from here on.
  void begin(const std::string& settings) {
    const std::lock_guard guard(lock_);
    if (settings != settings_) kept_.clear();
    settings_ = settings;
    for (auto& [identity, kept] : kept_) kept.used = false;
  }
  /// Forgets what this run has not asked for, or not kept.
  void end() {
    const std::lock_guard guard(lock_);
    std::erase_if(kept_, [](const auto& entry) { return !entry.second.used; });
  }

  std::optional<Result> find(const std::string& identity, const std::vector<std::string>& files) {
    Kept* kept = nullptr;
    {
      const std::lock_guard guard(lock_);
      const auto at = kept_.find(identity);
      if (at == kept_.end() || at->second.files != files) return std::nullopt;
      kept = &at->second;
      kept->used = true;
    }
    // Nobody removes an entry while a run goes on.
    return are_unchanged(files, kept->known) ? std::optional(kept->result) : std::nullopt;
  }

  /// Keeps a result, except where a file has changed since look_at() told what is known of them.
  void keep(const std::string& identity, const std::vector<std::string>& files,
            const std::vector<sys::FileInfo>& known, Result result) {
    if (!are_unchanged(files, known)) return;
    const std::lock_guard guard(lock_);
    kept_.insert_or_assign(identity, Kept{files, known, std::move(result)});
  }

  /// All files that the kept results depend on.
  std::vector<std::string> files() const {
    const std::lock_guard guard(lock_);
    std::vector<std::string> out;
    for (const auto& [identity, kept] : kept_) out.insert(out.end(), kept.files.begin(), kept.files.end());
    return out;
  }

 private:
  struct Kept {
    std::vector<std::string> files;
    std::vector<sys::FileInfo> known;
    Result result;
    bool used = true;
  };
  mutable std::mutex lock_;
  std::string settings_;
  std::map<std::string, Kept> kept_;  // by identity
};

}  // namespace etak
