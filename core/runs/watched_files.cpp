// SPDX-License-Identifier: Apache-2.0
#include "core/runs/watched_files.h"

#include <algorithm>
#include <thread>

#include "core/base/files/paths.h"
#include "core/base/system.h"

namespace etak {
namespace {

constexpr auto shortest_pause = std::chrono::milliseconds(300);
constexpr auto most_settling = std::chrono::seconds(3);
constexpr int pauses_per_look = 4;

// Without links, so that two paths of one file are the same text.
std::string watched_path(const std::string& path) {
  return sys::path_text(plain_path(path.empty() ? "." : path));
}

// etak's own files on their way to their places (temporary.h).
bool is_temporary(std::string_view name) {
  return name.starts_with('.') && name.find(".etak-") != name.npos;
}

}  // namespace

void WatchedFiles::add_folder(const std::string& path, bool deep) {
  bool& there = folders_[watched_path(path)];
  there = there || deep;
}

void WatchedFiles::add_file(const std::string& path) {
  if (!path.empty()) files_.insert(watched_path(path));
}

void WatchedFiles::leave_out(const std::string& path) {
  if (!path.empty()) left_out_.insert(watched_path(path));
}

void WatchedFiles::clear() {
  folders_.clear();
  files_.clear();
  left_out_.clear();
}

WatchedFiles::Stamps WatchedFiles::look() const {
  Stamps found;
  const auto look_into = [&](const std::string& folder, bool deep, auto again) -> void {
    (void)walk_folder(folder, false, [&](const FolderEntry& entry) {
      if (left_out_.contains(entry.path)) return;
      const bool is_folder = entry.kind == sys::FileInfo::Kind::folder;
      if (deep && is_folder && !entry.linked) again(entry.path, deep, again);
      // A folder counts by its presence alone: its time changes with the files that are left out.
      if (!is_temporary(entry.name))
        found.emplace(entry.path, is_folder ? FileStamp{} : stamp_of(entry.path));
    });
  };
  for (const auto& [folder, deep] : folders_) look_into(folder, deep, look_into);
  for (const std::string& file : files_)
    if (!left_out_.contains(file)) found.emplace(file, stamp_of(file));
  return found;
}

void WatchedFiles::wait_for_change() {
  using Clock = std::chrono::steady_clock;
  std::chrono::nanoseconds pause = shortest_pause;
  const auto look_now = [&] {
    const auto start = Clock::now();
    Stamps out = look();
    pause = std::max<std::chrono::nanoseconds>(shortest_pause, pauses_per_look * (Clock::now() - start));
    return out;
  };
  Stamps now = look_now();
  if (seen_) {
    while (now == *seen_) {
      std::this_thread::sleep_for(pause);
      now = look_now();
    }
    for (const auto end = Clock::now() + most_settling; Clock::now() < end;) {
      std::this_thread::sleep_for(pause);
      Stamps next = look_now();
      const bool settled = next == now;
      now = std::move(next);
      if (settled) break;
    }
  }
  seen_ = std::move(now);
}

}  // namespace etak
