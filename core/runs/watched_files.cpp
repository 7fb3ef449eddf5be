// SPDX-License-Identifier: Apache-2.0
#include "core/runs/watched_files.h"

#include <algorithm>
#include <filesystem>
#include <thread>

#include "core/base/system.h"

namespace etak {
namespace {

namespace watched = std::filesystem;

constexpr auto shortest_pause = std::chrono::milliseconds(300);
constexpr auto most_settling = std::chrono::seconds(3);
constexpr int pauses_per_look = 4;

// Without links, so that two paths of one file are the same text.
std::string plain_path(const std::string& path) {
  std::error_code failure;
  const watched::path whole = watched::weakly_canonical(path.empty() ? "." : path, failure);
  return failure ? path : sys::path_text(whole);
}

// etak's own files on their way to their places (temporary.h).
bool is_temporary(const std::string& name) {
  return name.starts_with('.') && name.find(".etak-") != name.npos;
}

}  // namespace

void WatchedFiles::add_folder(const std::string& path, bool deep) {
  bool& there = folders_[plain_path(path)];
  there = there || deep;
}

void WatchedFiles::add_file(const std::string& path) {
  if (!path.empty()) files_.insert(plain_path(path));
}

void WatchedFiles::leave_out(const std::string& path) {
  if (!path.empty()) left_out_.insert(plain_path(path));
}

void WatchedFiles::clear() {
  folders_.clear();
  files_.clear();
  left_out_.clear();
}

WatchedFiles::Stamps WatchedFiles::look() const {
  Stamps found;
  for (const auto& [folder, deep] : folders_) {
    std::error_code failure;
    for (watched::recursive_directory_iterator it(folder, failure), end; it != end && !failure;
         it.increment(failure)) {
      const std::string path = sys::path_text(it->path());
      std::error_code gone;
      const bool is_folder = it->is_directory(gone);
      if (is_folder && (!deep || left_out_.contains(path) || it->is_symlink(gone)))
        it.disable_recursion_pending();
      if (left_out_.contains(path) || is_temporary(sys::path_text(it->path().filename()))) continue;
      // Of a folder only that it is there: its time changes with the files that are left out.
      found.emplace(path, is_folder ? FileStamp{} : stamp_of(path));
    }
  }
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
