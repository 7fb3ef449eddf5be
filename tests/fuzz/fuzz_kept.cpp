// SPDX-License-Identifier: Apache-2.0
// Whatever lies in a cache's folder: an entry that is found is the one that was written, and else there is none. The
// first byte picks what the bytes take the place of: the account, an entry as it lies in the folder, or the text of an
// atlas's entry, whose seal is right, since anybody can make it without a key.
#include <unistd.h>

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/base/bytes/member_bytes.h"
#include "core/base/error.h"
#include "core/base/hash/sha256.h"
#include "core/pack/pack_cache.h"

using namespace etak;

namespace {

constexpr std::string_view written = "what was written";

// A folder that is removed at the end.
struct Folder {
  std::string path = "/tmp/fuzz_kept.XXXXXX";
  Folder() {
    if (::mkdtemp(path.data()) == nullptr) std::abort();
  }
  ~Folder() { std::filesystem::remove_all(path); }
};
const std::string& folder() {
  static const Folder made;
  return made.path;
}

void put(const std::string& file, std::string_view bytes) {
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

CacheOptions options() {
  CacheOptions out;
  out.path = folder() + "/plain";
  out.kind = "pack";
  return out;
}

void with_account(std::string_view bytes) {
  static const std::string digest = sha256("account");
  { CacheFolder make(options()); }
  put(options().path + "/account", bytes);
  {
    CacheFolder cache(options());
    cache.keep(digest, written);
    (void)cache.use();
  }
  CacheFolder cache(options());
  const auto entry = cache.find(digest);
  assert(!entry || entry->text == written);
}

void with_entry(std::string_view bytes) {
  static const std::string digest = sha256("entry");
  CacheFolder cache(options());
  cache.keep(digest, written);
  assert(cache.find(digest) && cache.find(digest)->text == written);
  put(options().path + "/" + digest.substr(0, 2) + "/" + digest.substr(2) + ".entry", bytes);
  const auto entry = cache.find(digest);
  assert(!entry || entry->text == written);
}

void with_text(std::string_view bytes) {
  static CacheOptions own = options();
  static PackCache cache((own.path += "-atlases", own), "fuzz", 1);
  static const std::string first = sha256("job");
  MemberWriter no_files;
  no_files.member(std::vector<std::string>());
  cache.folder().keep(first, no_files.bytes);
  // The key of an atlas whose input names no files.
  cache.folder().keep(sha256("atlas\n" + first + '\n'), bytes);
  auto atlas = cache.find(first);
  if (!atlas) return;
  for (const KeptAtlas::File& file : atlas->files) assert(is_plain_file_name(file.name) && file.size == 0);
  (void)cache.restored(*atlas, folder() + "/atlas", true);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::vector<char> bytes(data + 1, data + size);
  constexpr void (*places[])(std::string_view) = {with_account, with_entry, with_text};
  try {
    places[data[0] % 3]({bytes.data(), bytes.size()});
  } catch (const Error&) {
  }
  return 0;
}
