// SPDX-License-Identifier: Apache-2.0
// How large the folder of a cache is: its account, and what goes where it is too large.
#include <cerrno>
#include <tuple>

#include "core/runs/cache_state.h"

namespace etak {
namespace {

constexpr std::uint64_t runs_between_counts = 256;

}  // namespace

// The time that the file system of the folder gives a file now: all programs that share it get the same one.
sys::FileInfo::Time CacheFolder::State::now() {
  NewEntry::Open probe(*this);
  sys::FileInfo info;
  if (probe.create() && sys::file_info(probe.file.get(), info)) return info.written;
  return {clock_seconds(), 0};
}

std::vector<FoundEntry> CacheFolder::State::list(std::vector<Descriptor>& opened) {
  std::vector<FoundEntry> out;
  if (!root) return out;
  for (const std::string& folder : names_in(root.get())) {
    const IsOwnName is_own = folder == folder_of_new_entries ? nullptr : own_names_of(folder);
    if (is_own == nullptr) continue;
    Descriptor again = open_folder(root.get(), folder);
    sys::FolderReader reader(again ? sys::reopen_folder(again.get()) : -1);
    if (!reader) continue;
    for (sys::FolderReader::Entry entry; reader.next(entry);) {
      sys::FileInfo info;
      if (!is_own(entry.name) || !sys::file_info_in(again.get(), entry.name, info) ||
          info.kind != sys::FileInfo::Kind::file)
        continue;
      out.push_back(
          {opened.size(), entry.name, info.number, in_blocks(info.size), info.written, info.written});
    }
    opened.push_back(std::move(again));
  }
  return out;
}

// Removes what killed runs have left.
void CacheFolder::State::clean_new(const sys::FileInfo::Time& now) {
  const int folder = folder_of_new();
  if (folder < 0) return;
  for (const std::string& name : names_in(folder)) {
    sys::FileInfo info;
    if (!is_new_name(name) || !sys::file_info_in(folder, name.c_str(), info) ||
        info.kind != sys::FileInfo::Kind::file)
      continue;
    const std::int64_t age = now.seconds - info.written.seconds;
    if (age > hour) (void)sys::remove_in(folder, name.c_str());
    if (age < -hour) (void)sys::touch_in(folder, name.c_str());
  }
}

// Counts the entries and removes those used longest ago where there are too many. Any number of programs may
// do so at once: all of them remove in the same order, and stop at the same place.
std::uint64_t CacheFolder::State::count_and_trim() {
  const sys::FileInfo::Time moment = now();
  clean_new(moment);
  std::vector<Descriptor> opened;
  std::vector<FoundEntry> entries = list(opened);
  std::uint64_t total = 0;
  for (FoundEntry& entry : entries) {
    total += entry.bytes;
    if (entry.used.seconds <= moment.seconds + hour) continue;
    entry.used = moment;
    const int folder = opened[entry.folder].get();
    sys::FileInfo info;
    if (sys::touch_in(folder, entry.name.c_str()) && sys::file_info_in(folder, entry.name.c_str(), info))
      entry.written = info.written;
  }
  if (total <= options.most_bytes) return total;
  std::ranges::sort(entries, {}, [](const FoundEntry& entry) {
    return std::tie(entry.used.seconds, entry.used.nanoseconds, entry.folder, entry.name);
  });
  const std::uint64_t goal = options.most_bytes - options.most_bytes / 10;
  for (const FoundEntry& entry : entries) {
    if (total <= goal) break;
    const int folder = opened[entry.folder].get();
    sys::FileInfo info;
    if (sys::file_info_in(folder, entry.name.c_str(), info)) {
      // Written or used by another program since it was counted: its turn has not come.
      if (info.number != entry.number || !same_time(info.written, entry.written)) continue;
      if (!sys::remove_in(folder, entry.name.c_str())) {
        if (errno != ENOENT) continue;
      } else {
        ++evicted;
      }
    }
    total -= entry.bytes;
  }
  return total;
}

void CacheFolder::settle() {
  State& s = *state_;
  const std::lock_guard guard(s.settling);
  const std::uint64_t mine = s.added.exchange(0);
  if (!s.root || mine == 0) return;
  const FolderLock lock(s.root.get(), most_wait_for_lock);
  const auto text = first_bytes_of(s.root.get(), account_file);
  sys::FileInfo info;
  const bool foreign = text ? !is_account(*text) : sys::file_info_in(s.root.get(), account_file, info);
  const auto account = text ? read_account(*text) : std::nullopt;
  std::uint64_t total = account ? account->bytes + mine : 0;
  const std::uint64_t runs = account ? account->runs + 1 : 1;
  if (!account || total > s.options.most_bytes || runs % runs_between_counts == 0) total = s.count_and_trim();
  NewEntry::Open file(s);
  if (foreign || !file.create()) return;
  file.add(std::string(cache_format) + ' ' + std::to_string(total) + ' ' + std::to_string(runs) + '\n');
  (void)file.rename_to(s.root.get(), account_file);
}

CacheUse CacheFolder::use() {
  settle();
  State& s = *state_;
  CacheUse out;
  out.counts = {s.hits, s.misses, s.refused, s.written, s.too_large, s.not_written, s.evicted};
  if (s.options.counted) {
    std::vector<Descriptor> opened;
    CacheSize& size = out.size.emplace();
    for (const FoundEntry& entry : s.list(opened)) {
      ++size.entries;
      size.bytes += entry.bytes;
    }
  }
  const std::lock_guard guard(s.lock);
  out.fault = s.why;
  out.missing = !s.root;
  return out;
}

}  // namespace etak
