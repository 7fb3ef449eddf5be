// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/files/steady_file.h"

namespace etak {

/// Files that are looked at again and again, until one of them changes: its bytes, its time, another file under
/// its name, a new one, one that is gone. By looking, because notices of the system do not come from other
/// machines of a share. To look takes at most a fifth of the time.
class WatchedFiles {
 public:
  /// Everything in a folder, and with `deep` below it. A folder that is not there is watched for.
  void add_folder(const std::string& path, bool deep);
  /// One file, which may not be there yet.
  void add_file(const std::string& path);
  /// A file or folder that is not looked at, because the program itself writes it.
  void leave_out(const std::string& path);

  /// Waits until something has changed since the state that the last call has seen, and then until nothing changes
  /// any more, at most for some seconds: a file that is being written is best read when it is whole. The first
  /// call returns at once.
  void wait_for_change();

  /// Forgets what was added, not what was seen: files to watch may differ from one time to the next.
  void clear();

 private:
  using Stamps = std::map<std::string, FileStamp>;
  Stamps look() const;

  std::map<std::string, bool> folders_;  // and whether deep
  std::set<std::string> files_, left_out_;
  std::optional<Stamps> seen_;
};

}  // namespace etak
