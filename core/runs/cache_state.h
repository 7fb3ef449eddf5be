// SPDX-License-Identifier: Apache-2.0
// What the sources of CacheFolder share: cache_folder.cpp finds and keeps entries, cache_size.cpp counts them and
// keeps the folder within its bound, cache_names.cpp knows which files of the folder are the cache's own.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/system.h"
#include "core/runs/cache_folder.h"

namespace etak {

inline constexpr std::string_view cache_format = "etak-cache/1", entry_ending = ".entry";
inline constexpr const char *folder_of_new_entries = "new", *account_file = "account",
                            *tag_file = "CACHEDIR.TAG", *secret_file = "secret";
inline constexpr std::size_t folder_digits = 2, digest_digits = 64, longest_head = 256;
inline constexpr std::int64_t hour = 3600;
// Another program may hold the lock of the folder for ever. Without it nothing breaks: two programs then do
// the same work, the account is wrong until entries are counted again, or results are kept that nobody finds.
inline constexpr std::chrono::seconds most_wait_for_lock{2};
// Most entries are not larger, and are read by one call.
inline constexpr std::size_t usual_entry = std::size_t{16} << 10;

// What a file of so many bytes takes on a disk.
inline std::uint64_t in_blocks(std::uint64_t bytes) {
  constexpr std::uint64_t disk_block = 4096;
  return (bytes + disk_block - 1) / disk_block * disk_block;
}

// Digests have their digits in lower case.
inline bool are_hex_digits(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

// The next word of `text`, which ends at a blank or at the end.
inline std::string_view take_word(std::string_view& text) {
  const std::string_view word = text.substr(0, text.find(' '));
  text.remove_prefix(std::min(text.size(), word.size() + 1));
  return word;
}

// Reads until `out` is full; false where the file ends before.
inline bool fill_from(int file, std::span<char> out) {
  while (!out.empty()) {
    const std::ptrdiff_t got = sys::read(file, out.data(), out.size());
    if (got <= 0) return false;
    out = out.subspan(static_cast<std::size_t>(got));
  }
  return true;
}

inline std::int64_t clock_seconds() {
  return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

inline bool same_time(const sys::FileInfo::Time& a, const sys::FileInfo::Time& b) {
  return a.seconds == b.seconds && a.nanoseconds == b.nanoseconds;
}

// Whether a time is so long ago that a use is worth a new one. By this machine's clock: a wrong one costs a call.
inline bool is_old(const sys::FileInfo::Time& time) {
  const std::int64_t age = clock_seconds() - time.seconds;
  return age > hour || age < -hour;
}

// Whether a cache makes files of a name. In DIR/new: what becomes an entry, the account or the tag.
bool is_new_name(std::string_view name);
// Whether a cache makes files of a name in DIR/FOLDER; null: it makes no such folder.
using IsOwnName = bool (*)(std::string_view name);
IsOwnName own_names_of(std::string_view folder);

// The first bytes of a regular file, as many as a line of a cache has at most; none where it cannot be read.
std::optional<std::string> first_bytes_of(int folder, const std::string& name);

// Whether the text of DIR/account was written by a cache, or is what a power cut leaves of one.
bool is_account(std::string_view text);

// What DIR/account tells: the bytes of all entries, and how many runs have added to them.
struct CacheAccount {
  std::uint64_t bytes = 0, runs = 0;
};
std::optional<CacheAccount> read_account(std::string_view text);

// Where an entry is, what it takes, and when it was used.
//   folder    of the list of folders
//   written   the time of the file
//   used      the same, but never in the future
struct FoundEntry {
  std::size_t folder = 0;
  std::string name;
  std::uint64_t number = 0, bytes = 0;
  sys::FileInfo::Time written, used;
};

// A file in DIR/new that becomes an entry, the account, or the tag.
struct CacheFolder::NewEntry::Open {
  State& state;
  int folder = -1;  // DIR/new
  std::string name, digest;
  Descriptor file;
  int remembered = -1;
  std::string waiting;
  std::uint64_t expected = 0, got = 0;
  int error = 0;

  explicit Open(State& of) : state(of) {}
  ~Open() { remove(); }
  Open(const Open&) = delete;
  Open& operator=(const Open&) = delete;

  // False where the folder takes no file; errno tells why.
  bool create();
  void add(std::string_view bytes);
  void flush();
  // False where it cannot be put in place; `error` tells why.
  bool rename_to(int to, const std::string& final_name);
  void remove();
};

struct CacheFolder::State {
  explicit State(CacheOptions asked) : options(std::move(asked)) {}

  CacheOptions options;
  Descriptor root;
  std::string secret;  // of DIR/secret; empty: with a key, or where there is none and none could be written
  std::mutex lock;     // of what follows
  std::array<Descriptor, 256> folders;
  Descriptor fresh;  // DIR/new
  std::string why;

  std::atomic<bool> closed{false};  // nothing is kept any more
  std::atomic<std::uint64_t> hits{0}, misses{0}, refused{0}, written{0}, too_large{0}, not_written{0},
      evicted{0};
  std::atomic<std::uint64_t> added{0};  // bytes that the account does not hold yet
  std::mutex settling;

  // Marks the folder as the cache's own where it may be; throws Error where it may not.
  void own_folder();

  // Takes the secret of the folder, which the first program that finds none draws.
  void take_secret();

  std::string seal(std::string_view digest, std::string_view sizes, std::string_view text) const;

  // The open folder of an entry, -1 where it is missing; errno tells why. A link in its place is not followed.
  int folder_of(std::string_view digest, bool make);
  int folder_of_new();

  // An entry could not be written. Nothing more is kept where that says something of the next one.
  void fail(int error);

  std::optional<CacheEntry> look_up(const std::string& digest, bool& damaged);
  // The entry that begins with `bytes`, whose seal is looked at; none where it does not count.
  //   size   of the whole entry
  //   file   that goes on behind `bytes`; -1: none
  std::optional<CacheEntry> read_entry(const std::string& digest, std::string_view bytes, std::uint64_t size,
                                       int file) const;

  std::vector<FoundEntry> list(std::vector<Descriptor>& opened);
  sys::FileInfo::Time now();
  void clean_new(const sys::FileInfo::Time& now);
  std::uint64_t count_and_trim();
};

}  // namespace etak
