// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/cache_folder.h"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <new>
#include <tuple>
#include <vector>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/hash/sha256.h"
#include "core/base/hex.h"
#include "core/base/json_text.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/base/signals.h"
#include "core/base/text.h"

namespace etak {
namespace {

constexpr std::string_view cache_format = "etak-cache/1", account_file = "account",
                           folder_of_new_entries = "new";
constexpr std::string_view entry_ending = ".entry";
// Entries of etak before there was a size: they are never found, and are the first to go.
constexpr std::string_view old_entry_ending = ".json";
constexpr std::uint64_t disk_block = 4096;
constexpr std::uint64_t largest_text = std::uint64_t{256} << 20;
constexpr std::size_t longest_head = 256, folder_digits = 2, digest_digits = 64;
constexpr std::size_t shortest_key = 16, longest_key = 4096;
constexpr std::int64_t hour = 3600;
constexpr std::uint64_t runs_between_counts = 256;
// Another program may hold the lock of the folder for ever. Without it nothing breaks: two programs then do
// the same work, or the account is wrong until entries are counted again.
constexpr std::chrono::seconds most_wait_to_settle{2};

std::uint64_t in_blocks(std::uint64_t bytes) {
  return (bytes + disk_block - 1) / disk_block * disk_block;
}

bool are_hex_digits(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

std::string folder_name(std::string_view digest) {
  return std::string(digest.substr(0, folder_digits));
}

std::string entry_name(std::string_view digest) {
  return std::string(digest.substr(folder_digits)) + std::string(entry_ending);
}

bool is_entry_name(std::string_view name) {
  constexpr std::size_t digits = digest_digits - folder_digits;
  return name.size() > digits && are_hex_digits(name.substr(0, digits)) &&
         (name.substr(digits) == entry_ending || name.substr(digits) == old_entry_ending);
}

// The next word of `text`, which ends at a blank or at the end.
std::string_view take_word(std::string_view& text) {
  const std::string_view word = text.substr(0, text.find(' '));
  text.remove_prefix(std::min(text.size(), word.size() + 1));
  return word;
}

std::optional<std::uint64_t> whole_number(std::string_view text) {
  constexpr std::size_t most_digits = 18;
  if (text.empty() || text.size() > most_digits) return std::nullopt;
  std::uint64_t out = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    out = 10 * out + static_cast<std::uint64_t>(c - '0');
  }
  return out;
}

// Reads until `out` is full; false where the file ends before.
bool fill_from(int file, std::string& out, std::size_t from) {
  while (from < out.size()) {
    const std::ptrdiff_t got = sys::read(file, out.data() + from, out.size() - from);
    if (got <= 0) return false;
    from += static_cast<std::size_t>(got);
  }
  return true;
}

// Whether an entry that cannot be put in place says nothing of the next one: somebody has put another thing in
// its place, or has removed a folder.
bool is_of_one_entry(int error) {
  return error == EEXIST || error == ENOTDIR || error == EISDIR || error == ENOTEMPTY || error == ELOOP ||
         error == ENOENT;
}

std::int64_t clock_seconds() {
  return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

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

bool same_time(const sys::FileInfo::Time& a, const sys::FileInfo::Time& b) {
  return a.seconds == b.seconds && a.nanoseconds == b.nanoseconds;
}

}  // namespace

struct CacheFolder::State {
  explicit State(CacheOptions asked) : options(std::move(asked)) {}

  CacheOptions options;
  Descriptor root;
  std::mutex lock;  // of what follows
  std::array<Descriptor, 256> folders;
  Descriptor fresh;  // DIR/new
  std::string why;

  std::atomic<bool> closed{false};  // nothing is kept any more
  std::atomic<std::uint64_t> hits{0}, misses{0}, refused{0}, written{0}, too_large{0}, not_written{0},
      evicted{0};
  std::atomic<std::uint64_t> added{0};  // bytes that the account does not hold yet
  std::mutex settling;

  std::string seal(std::string_view digest, std::string_view sizes, std::string_view text) const {
    std::string sealed(cache_format);
    for (const std::string_view part : {std::string_view(options.kind), digest, sizes})
      (sealed += ' ') += part;
    sealed += '\n';
    sealed += text;
    return options.key.empty() ? sha256(sealed) : hmac_sha256(options.key, sealed);
  }

  // The open folder of an entry, -1 where it is missing; errno tells why. A link in its place is not followed.
  int folder_of(std::string_view digest, bool make) {
    const auto digit = [&](std::size_t i) {
      const char c = digest[i];
      return static_cast<std::size_t>(c <= '9' ? c - '0' : c - 'a' + 10);
    };
    const std::lock_guard guard(lock);
    Descriptor& folder = folders[16 * digit(0) + digit(1)];
    if (!folder) {
      if (make) (void)sys::make_folder_in(root.get(), folder_name(digest), 0777);
      folder = open_folder(root.get(), folder_name(digest));
    }
    return folder.get();
  }
  int folder_of_new() {
    const std::lock_guard guard(lock);
    if (!fresh) {
      (void)sys::make_folder_in(root.get(), std::string(folder_of_new_entries), 0777);
      fresh = open_folder(root.get(), std::string(folder_of_new_entries));
    }
    return fresh.get();
  }

  void fail(int error) {
    ++not_written;
    if (is_of_one_entry(error)) return;
    const std::lock_guard guard(lock);
    if (why.empty()) why = reason_of(error);
    closed = true;
  }

  std::optional<CacheEntry> look_up(const std::string& digest, bool& damaged);
  std::vector<FoundEntry> list(std::vector<Descriptor>& opened);
  sys::FileInfo::Time now();
  void clean_new(const sys::FileInfo::Time& now);
  std::uint64_t count_and_trim();
};

// A file in DIR/new that becomes an entry, or the account.
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
  bool create() {
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

  void add(std::string_view bytes) {
    constexpr std::size_t piece = std::size_t{256} << 10;
    got += bytes.size();
    waiting += bytes;
    if (waiting.size() >= piece) flush();
  }
  void flush() {
    if (error == 0 && !write_all(file.get(), waiting)) error = errno;
    waiting.clear();
  }
  // False where it cannot be put in place; `error` tells why.
  bool rename_to(int to, const std::string& final_name) {
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
  void remove() {
    if (name.empty()) return;
    const SignalsHeld held;
    sys::remove_in(folder, name.c_str());
    name.clear();
    forget_temporary(std::exchange(remembered, -1));
  }
};

CacheFolder::CacheFolder(CacheOptions options) : state_(std::make_unique<State>(std::move(options))) {
  State& s = *state_;
  std::error_code failure, ignored;
  const std::string& path = s.options.path;
  std::filesystem::create_directories(path, failure);
  s.root = Descriptor(sys::open_file(path, sys::Open::folder));
  if (s.root) return;
  const int error = errno;
  if (std::filesystem::exists(path, ignored) && !std::filesystem::is_directory(path, ignored))
    throw Error::at(setting("cache"), printable(path, 200) + " is no folder", "a folder");
  s.why = failure ? failure.message() : reason_of(error);
  s.closed = true;
}

CacheFolder::~CacheFolder() {
  try {
    settle();
  } catch (const std::bad_alloc&) {
    // The account is right again when the entries are counted the next time.
  }
}

std::optional<CacheEntry> CacheFolder::State::look_up(const std::string& digest, bool& damaged) {
  const int folder = root ? folder_of(digest, false) : -1;
  if (folder < 0) return std::nullopt;
  const std::string name = entry_name(digest);
  CacheEntry out;
  out.file = Descriptor(sys::open_in(folder, name, sys::OpenIn::read));
  damaged = errno != ENOENT;
  if (!out.file) return std::nullopt;
  damaged = true;
  sys::FileInfo info;
  if (!sys::file_info(out.file.get(), info) || info.kind != sys::FileInfo::Kind::file) return std::nullopt;
  // Most entries are read by one call.
  constexpr std::uint64_t usual = 16 << 10;
  std::string bytes(static_cast<std::size_t>(std::min(info.size, usual)), '\0');
  if (!fill_from(out.file.get(), bytes, 0)) return std::nullopt;
  const std::size_t end = std::string_view(bytes).substr(0, longest_head).find('\n');
  if (end == std::string::npos) return std::nullopt;
  std::string_view head(bytes.data(), end);
  if (take_word(head) != cache_format || take_word(head) != options.kind) return std::nullopt;
  const std::string seal_there(take_word(head)), sizes(head);
  const auto text_size = whole_number(take_word(head)), rest_size = whole_number(head);
  if (!text_size || !rest_size || *text_size > largest_text || info.size != end + 1 + *text_size + *rest_size)
    return std::nullopt;
  const std::size_t have = bytes.size();
  out.rest_at = end + 1 + *text_size;
  out.rest_size = *rest_size;
  bytes.resize(static_cast<std::size_t>(out.rest_at));
  if (!fill_from(out.file.get(), bytes, have)) return std::nullopt;
  bytes.erase(0, end + 1);
  if (!same_digest(seal_there, seal(digest, sizes, bytes))) return std::nullopt;
  out.text = std::move(bytes);
  // By this machine's clock: a wrong one costs a call, no more.
  const std::int64_t age = clock_seconds() - info.written.seconds;
  if (age > hour || age < -hour) (void)sys::touch_in(folder, name.c_str());
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
    if (folder.size() != folder_digits || !are_hex_digits(folder)) continue;
    Descriptor again = open_folder(root.get(), folder);
    sys::FolderReader reader(again ? sys::reopen_folder(again.get()) : -1);
    if (!reader) continue;
    for (sys::FolderReader::Entry entry; reader.next(entry);) {
      sys::FileInfo info;
      if (!is_entry_name(entry.name) || !sys::file_info_in(again.get(), entry.name, info) ||
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
    if (!sys::file_info_in(folder, name.c_str(), info) || info.kind != sys::FileInfo::Kind::file) continue;
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
  const FolderLock lock(s.root.get(), most_wait_to_settle);
  const auto account = [&]() -> std::optional<std::pair<std::uint64_t, std::uint64_t>> {
    const Descriptor file(sys::open_in(s.root.get(), std::string(account_file), sys::OpenIn::read));
    sys::FileInfo info;
    if (!file || !sys::file_info(file.get(), info) || info.kind != sys::FileInfo::Kind::file ||
        info.size > longest_head)
      return std::nullopt;
    std::string text(static_cast<std::size_t>(info.size), '\0');
    if (!fill_from(file.get(), text, 0) || !text.ends_with('\n')) return std::nullopt;
    std::string_view line(text.data(), text.size() - 1);
    if (take_word(line) != cache_format) return std::nullopt;
    const auto bytes = whole_number(take_word(line)), runs = whole_number(line);
    if (!bytes || !runs) return std::nullopt;
    return std::pair(*bytes, *runs);
  }();
  std::uint64_t total = account ? account->first + mine : 0;
  const std::uint64_t runs = account ? account->second + 1 : 1;
  if (!account || total > s.options.most_bytes || runs % runs_between_counts == 0) total = s.count_and_trim();
  NewEntry::Open file(s);
  if (!file.create()) return;
  file.add(std::string(cache_format) + ' ' + std::to_string(total) + ' ' + std::to_string(runs) + '\n');
  (void)file.rename_to(s.root.get(), std::string(account_file));
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
  return out;
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

std::string cache_text(const CacheUse& use) {
  const CacheCounts& counts = use.counts;
  std::string out = grouped(counts.hits) + " hits, " + grouped(counts.misses) + " misses (" +
                    grouped(counts.refused) + " damaged or foreign), " + grouped(counts.written) +
                    " written, " + grouped(counts.evicted) + " evicted, " + grouped(counts.too_large) +
                    " too large, " + grouped(counts.not_written) + " not written";
  if (use.size)
    out += "; now " + grouped(use.size->entries) + " entries of " + grouped(use.size->bytes) + " bytes";
  return out;
}

std::string cache_json(const CacheUse& use) {
  const CacheCounts& counts = use.counts;
  std::vector<JsonMember> members{
      {"schema", json("etak-cache-use/1")},  {"hits", json(counts.hits)},
      {"misses", json(counts.misses)},       {"refused", json(counts.refused)},
      {"written", json(counts.written)},     {"evicted", json(counts.evicted)},
      {"too_large", json(counts.too_large)}, {"not_written", json(counts.not_written)}};
  if (use.size) {
    members.push_back({"entries", json(use.size->entries)});
    members.push_back({"bytes", json(use.size->bytes)});
  }
  if (!use.fault.empty()) members.push_back({"fault", json(use.fault)});
  return json_object(members, 0) + '\n';
}

}  // namespace etak
