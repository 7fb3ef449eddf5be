// SPDX-License-Identifier: Apache-2.0
#include "core/runs/cache_folder.h"

#include <cassert>
#include <cerrno>
#include <new>

#include "core/base/bytes/hex.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/paths.h"
#include "core/base/hash/content_hash.h"
#include "core/base/hash/sha256.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/base/signals.h"
#include "core/base/text/ascii.h"
#include "core/base/text/text.h"
#include "core/runs/cache_state.h"

namespace etak {
namespace {

// A text is in memory before its seal can be looked at, so that an entry that somebody has made takes no more of it
// than this.
constexpr std::uint64_t largest_text = std::uint64_t{64} << 20;
constexpr std::size_t shortest_key = 16, longest_key = 4096;

std::string folder_name(std::string_view digest) {
  return std::string(digest.substr(0, folder_digits));
}

std::string entry_name(std::string_view digest) {
  return std::string(digest.substr(folder_digits)) + std::string(entry_ending);
}

// Whether an entry that cannot be put in place says nothing of the next one: somebody has put another thing in
// its place, or has removed a folder.
bool is_of_one_entry(int error) {
  return error == EEXIST || error == ENOTDIR || error == EISDIR || error == ENOTEMPTY || error == ELOOP ||
         error == ENOENT;
}

}  // namespace

std::string CacheFolder::State::seal(std::string_view digest, std::string_view sizes,
                                     std::string_view text) const {
  std::string sealed;
  sealed.reserve(longest_head + (options.key.empty() ? 0 : text.size()));
  sealed += cache_format;
  for (const std::string_view part : {std::string_view(options.kind), digest, sizes}) (sealed += ' ') += part;
  sealed += '\n';
  if (!options.key.empty()) return hmac_sha256(options.key, sealed += text);
  Sha256 hash;
  hash.add(sealed);
  hash.add(text);
  return hash.finish();
}

int CacheFolder::State::folder_of(std::string_view digest, bool make) {
  const std::lock_guard guard(lock);
  Descriptor& folder = folders[static_cast<std::size_t>(16 * hex_digit(digest[0]) + hex_digit(digest[1]))];
  if (!folder) {
    if (make) (void)sys::make_folder_in(root.get(), folder_name(digest), 0777);
    folder = open_folder(root.get(), folder_name(digest));
  }
  return folder.get();
}

int CacheFolder::State::folder_of_new() {
  const std::lock_guard guard(lock);
  if (!fresh) {
    (void)sys::make_folder_in(root.get(), folder_of_new_entries, 0777);
    fresh = open_folder(root.get(), folder_of_new_entries);
  }
  return fresh.get();
}

void CacheFolder::State::fail(int error) {
  ++not_written;
  if (is_of_one_entry(error)) return;
  const std::lock_guard guard(lock);
  if (why.empty()) why = reason_of(error);
  closed = true;
}

bool CacheFolder::NewEntry::Open::create() {
  std::uint64_t random = 0;
  folder = state.folder_of_new();
  if (folder < 0 || !sys::random_bytes(&random, sizeof random)) return false;
  const std::string unique = hex(random);
  const SignalsHeld held;
  file = Descriptor(sys::open_in(folder, unique, sys::OpenIn::create, 0666));
  if (!file) return false;
  name = unique;
  remembered = remember_temporary(folder, name.c_str(), -1);
  return true;
}

void CacheFolder::NewEntry::Open::add(std::string_view bytes) {
  constexpr std::size_t piece = std::size_t{256} << 10;
  got += bytes.size();
  waiting += bytes;
  if (waiting.size() >= piece) flush();
}

void CacheFolder::NewEntry::Open::flush() {
  if (error == 0 && !write_all(file.get(), waiting)) error = errno;
  waiting.clear();
}

bool CacheFolder::NewEntry::Open::rename_to(int to, const std::string& final_name) {
  flush();
  if (error == 0 && !file.close()) error = errno;
  if (error != 0) return false;
  const SignalsHeld held;
  if (!sys::rename_in(folder, name, to, final_name)) {
    error = errno;
    return false;
  }
  name.clear();
  forget_temporary(std::exchange(remembered, -1));
  return true;
}

void CacheFolder::NewEntry::Open::remove() {
  if (name.empty()) return;
  const SignalsHeld held;
  sys::remove_in(folder, name.c_str());
  name.clear();
  forget_temporary(std::exchange(remembered, -1));
}

CacheFolder::CacheFolder(CacheOptions options) : state_(std::make_unique<State>(std::move(options))) {
  State& s = *state_;
  const std::string& path = s.options.path;
  const bool made = make_folders(path);
  const int why = errno;
  s.root = Descriptor(sys::open_file(path, sys::Open::folder));
  if (s.root) {
    s.own_folder();
    if (s.options.key.empty()) s.take_secret();
    return;
  }
  const int error = errno;
  if (is_there(path) && !is_folder(path))
    throw Error::at(setting("cache"), printable(path, 200) + " is no folder", "a folder");
  s.why = reason_of(made ? error : why);
  s.closed = true;
}

CacheFolder::~CacheFolder() {
  try {
    settle();
  } catch (const std::bad_alloc&) {
    // The account is right again when the entries are counted the next time.
  }
}

std::optional<CacheEntry> CacheFolder::State::read_entry(const std::string& digest, std::string_view bytes,
                                                         std::uint64_t size, int file) const {
  const std::size_t end = bytes.substr(0, longest_head).find('\n');
  if (end == bytes.npos) return std::nullopt;
  std::string_view head = bytes.substr(0, end);
  if (take_word(head) != cache_format || take_word(head) != options.kind) return std::nullopt;
  const std::string seal_there(take_word(head)), sizes(head);
  const auto text_size = whole_number<std::uint64_t>(take_word(head)),
             rest_size = whole_number<std::uint64_t>(head);
  if (!text_size || !rest_size || *text_size > largest_text || *rest_size > size ||
      size != end + 1 + *text_size + *rest_size)
    return std::nullopt;
  CacheEntry out;
  out.rest_at = end + 1 + *text_size;
  out.rest_size = *rest_size;
  out.text = bytes.substr(end + 1, static_cast<std::size_t>(*text_size));
  const std::size_t have = out.text.size();
  out.text.resize(static_cast<std::size_t>(*text_size));
  if (!fill_from(file, std::span(out.text).subspan(have))) return std::nullopt;
  if (!same_digest(seal_there, seal(digest, sizes, out.text))) return std::nullopt;
  return out;
}

std::optional<CacheEntry> CacheFolder::State::look_up(const std::string& digest, bool& damaged) {
  const int folder = root ? folder_of(digest, false) : -1;
  if (folder < 0) return std::nullopt;
  const std::string name = entry_name(digest);
  Descriptor file(sys::open_in(folder, name, sys::OpenIn::read));
  damaged = file || errno != ENOENT;
  sys::FileInfo info;
  if (!file || !sys::file_info(file.get(), info) || info.kind != sys::FileInfo::Kind::file)
    return std::nullopt;
  std::array<char, usual_entry> usual;
  const std::span<char> begin(usual.data(),
                              static_cast<std::size_t>(std::min<std::uint64_t>(info.size, usual.size())));
  if (!fill_from(file.get(), begin)) return std::nullopt;
  const std::string_view bytes(begin.data(), begin.size());
  auto out = read_entry(digest, bytes, info.size, file.get());
  if (!out) return std::nullopt;
  if (is_old(info.written)) (void)sys::touch_in(folder, name.c_str());
  out->file = std::move(file);
  return out;
}

std::optional<CacheEntry> CacheFolder::find(const std::string& digest) {
  assert(digest.size() == digest_digits && are_hex_digits(digest));
  bool damaged = false;
  auto out = state_->look_up(digest, damaged);
  ++(out ? state_->hits : state_->misses);
  if (damaged && !out) ++state_->refused;
  return out;
}

std::optional<CacheEntry> CacheFolder::find_part(const std::string& digest) {
  bool damaged = false;
  auto out = state_->look_up(digest, damaged);
  if (damaged && !out) ++state_->refused;
  return out;
}

void CacheFolder::count_miss() {
  ++state_->misses;
}

void CacheFolder::refuse_hit() {
  --state_->hits;
  ++state_->misses;
  ++state_->refused;
}

void CacheFolder::keep(const std::string& digest, std::string_view text) {
  if (auto entry = begin(digest, text, 0)) entry->keep();
}

void CacheFolder::NewEntry::Close::operator()(Open* open) const {
  delete open;
}

CacheFolder::NewEntry::NewEntry(std::unique_ptr<Open> open) : open_(open.release()) {}

std::optional<CacheFolder::NewEntry> CacheFolder::begin(const std::string& digest, std::string_view text,
                                                        std::uint64_t rest_size) {
  assert(digest.size() == digest_digits && are_hex_digits(digest));
  State& s = *state_;
  if (s.closed) {
    ++s.not_written;
    return std::nullopt;
  }
  const std::string sizes = std::to_string(text.size()) + ' ' + std::to_string(rest_size);
  std::string head = std::string(cache_format) + ' ' + s.options.kind + ' ' + s.seal(digest, sizes, text) +
                     ' ' + sizes + '\n';
  const std::uint64_t all = head.size() + text.size() + rest_size;
  if (text.size() > largest_text || in_blocks(all) > s.options.most_bytes / 4) {
    ++s.too_large;
    return std::nullopt;
  }
  auto open = std::make_unique<NewEntry::Open>(s);
  if (!open->create()) {
    s.fail(errno);
    return std::nullopt;
  }
  open->digest = digest;
  open->expected = all;
  open->add(head);
  open->add(text);
  return NewEntry(std::move(open));
}

void CacheFolder::NewEntry::add(std::string_view bytes) {
  open_->add(bytes);
}

void CacheFolder::NewEntry::keep() {
  const std::unique_ptr<Open, Close> open = std::move(open_);
  State& s = open->state;
  if (open->got != open->expected) return;
  const int folder = s.folder_of(open->digest, true);
  if (folder < 0) return s.fail(errno);
  const std::string name = entry_name(open->digest);
  if (!open->rename_to(folder, name)) {
    // Windows does not replace a file that another program has open; the entry that is there holds the same result.
    sys::FileInfo there;
    if (open->error == EACCES && sys::file_info_in(folder, name.c_str(), there)) {
      ++s.not_written;
      return;
    }
    return s.fail(open->error);
  }
  ++s.written;
  s.added += in_blocks(open->expected);
}

std::string CacheFolder::hash_of(const std::string& path, sys::FileInfo& info, SeenAsFile seen,
                                 std::string* sha256) const {
  const bool by_secret = !state_->secret.empty(), by_sha256 = !by_secret || sha256 != nullptr;
  ContentHash content(state_->secret);
  Sha256 sha;
  if (!take_bytes(path, info, seen, [&](std::string_view bytes) {
        if (by_secret) content.add(bytes);
        if (by_sha256) sha.add(bytes);
      }))
    return {};
  const std::string digits = by_sha256 ? sha.finish() : "";
  if (sha256 != nullptr) *sha256 = digits;
  return by_secret ? content.hex() : digits;
}

std::string read_cache_key(const std::string& path) {
  std::string out = read_file(path, longest_key);
  if (out.size() < shortest_key)
    throw Error::at(path, "a key of " + std::to_string(out.size()) + " bytes",
                    "at least " + std::to_string(shortest_key) + " bytes, best of head -c 32 /dev/urandom");
  return out;
}

std::string program_fingerprint(const std::string& version) {
  return version + ' ' + sha256_of_file(sys::program_bytes());
}

}  // namespace etak
