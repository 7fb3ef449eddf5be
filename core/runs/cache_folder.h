// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/files/descriptor.h"
#include "core/base/files/input.h"
#include "core/base/files/temporary.h"
#include "core/runs/cache_use.h"

namespace etak {

/// An entry that was found: its text, and where there is a rest, an open file that holds it from `rest_at` on.
struct CacheEntry {
  std::string text;
  Descriptor file;
  std::uint64_t rest_at = 0, rest_size = 0;
};

/// A folder of results of earlier runs, a file for each, that any number of programs on any number of
/// machines read and write at the same time. Any thread may call.
///   owner    the folder is the cache's own: DIR/CACHEDIR.TAG marks it. A folder without that file is marked
///            where it is empty or holds only names that a cache makes, as caches of earlier versions do; any
///            other one is refused. In a marked folder too, only names that a cache makes are ever removed, and
///            DIR/account and DIR/secret are replaced only where a cache has written them
///   names    an entry is found by a digest: 64 hexadecimal digits that tell all that its content depends on.
///            Of the files among that, hash_of() tells: with a key by SHA-256, else by XXH3 with the secret in
///            DIR/secret, which is drawn once. Who cannot read the folder can make no two files that it takes
///            for one, however many he sends
///   seals    it begins with a checksum of its text and of that digest, so that damage and an entry under
///            another's name count as none. With a key the checksum is an HMAC, so that entries of writers
///            without the key count as none too. Without one any writer can make any entry: the folder is then
///            for trusted writers only
///   writing  to a temporary in DIR/new, then renamed: others see a whole entry or none. Nothing waits for the
///            disk, because an entry that a power cut destroys is only made again. What a killed run leaves
///            in DIR/new is removed by a later one when it is an hour old
///   size     every run adds what it wrote to the number in DIR/account. Where the sum is above the bound, the
///            entries that were used longest ago go until nine tenths are left. Every 256th time, and where
///            there is no number, all entries are counted anew, because runs that were killed have not
///            added theirs
///   use      a hit sets the time of an entry where that is more than an hour old. Times are compared with
///            those that the folder's own file system gives, so clocks of machines do not matter. A time in
///            its future is set to now, so that such an entry ages like others
/// No link below the folder is followed, neither to read nor to write. An entry that is gone is a miss. A
/// folder that cannot be written is read only, and use() says why; nothing throws but the constructor.
class CacheFolder {
 public:
  /// Throws Error where the path leads to something that is no folder, or to a folder that is not a cache's own.
  explicit CacheFolder(CacheOptions options);
  ~CacheFolder();
  CacheFolder(const CacheFolder&) = delete;
  CacheFolder& operator=(const CacheFolder&) = delete;

  /// What tells the bytes of a file in a digest; empty where it cannot be read.
  ///   info     what was known of the file before its bytes were read
  ///   sha256   gets the SHA-256 of the file where it is not null
  std::string hash_of(const std::string& path, sys::FileInfo& info, SeenAsFile seen = SeenAsFile::no,
                      std::string* sha256 = nullptr) const;

  /// The entry of that digest; none where there is none that counts.
  std::optional<CacheEntry> find(const std::string& digest);
  /// The same for an entry that only leads to another one: it is neither a hit nor a miss. count_miss() counts
  /// where the other one is not looked up after all.
  std::optional<CacheEntry> find_part(const std::string& digest);
  void count_miss();
  /// To be called for an entry whose rest turns out to be damaged: it was no hit.
  void refuse_hit();

  /// Keeps an entry of a text alone.
  void keep(const std::string& digest, std::string_view text);

  /// An entry with a rest, which comes piece by piece. It is kept where all of it was written.
  class NewEntry {
   public:
    NewEntry(NewEntry&&) = default;
    NewEntry& operator=(NewEntry&&) = default;
    void add(std::string_view bytes);
    void keep();

   private:
    friend class CacheFolder;
    struct Open;
    explicit NewEntry(std::unique_ptr<Open> open);
    struct Close {
      void operator()(Open* open) const;
    };
    std::unique_ptr<Open, Close> open_;
  };
  /// None where it would take more than a quarter of the cache, or where the folder takes nothing.
  std::optional<NewEntry> begin(const std::string& digest, std::string_view text, std::uint64_t rest_size);

  /// Adds what was written to the account, and removes entries where there are too many. The destructor does
  /// the same.
  void settle();

  /// What was done so far, settled.
  CacheUse use();

  /// For the sources of this class.
  struct State;

 private:
  std::unique_ptr<State> state_;
};

/// The bytes of a file with the key of a cache. Throws Error, also for fewer than 16 bytes.
std::string read_cache_key(const std::string& path);

/// The version and a hash of the running program: a rebuilt etak may give other results under the same version.
std::string program_fingerprint(const std::string& version);

}  // namespace etak
