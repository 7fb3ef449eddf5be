// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/base/system.h"
#include "core/judge/finding.h"
#include "core/validate/files/find_targets.h"

namespace etak {

/// Results in the memory of a program that checks the same files again and again. A target is only checked
/// again where one of its files, or something else that decides its result, is not as it was. Any thread may
/// call.
class CheckedBefore {
 public:
  /// To be called at the beginning of a run, by the settings of which results count from here on.
  void begin(const std::string& settings);
  /// Forgets what this run has not asked for, or not kept.
  void end();

  std::optional<CheckedFile> find(const FoundTarget& found);

  /// What is known of the files of a target, to be asked before they are read.
  static std::vector<sys::FileInfo> look_at(const FoundTarget& found);
  /// Keeps a result, except where it could not be told or a file has changed since look_at().
  void keep(const FoundTarget& found, const std::vector<sys::FileInfo>& before, const CheckedFile& file);

  /// All files that the kept results depend on.
  std::vector<std::string> files() const;

 private:
  struct Kept {
    std::vector<std::string> depends;
    std::vector<sys::FileInfo> files;
    CheckedFile file;
    bool used = true;
  };
  mutable std::mutex lock_;
  std::string settings_;
  std::map<std::string, Kept> kept_;  // by identity_of()
};

}  // namespace etak
