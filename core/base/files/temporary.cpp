// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/temporary.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <thread>

#include "core/base/signals.h"

namespace etak {
namespace {

using namespace std::chrono_literals;

constexpr std::string_view mark = ".etak-";
constexpr std::size_t letters = 6;
constexpr std::string_view alphabet = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
constexpr std::size_t longest_name = 255;

std::string prefix_of(std::string_view name) {
  constexpr std::size_t most = longest_name - 1 - mark.size() - letters;
  std::string shown(name);
  if (name.size() > most) {
    // FNV-1a: tells names apart whose beginnings are the same.
    std::uint64_t hash = 14695981039346656037U;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    std::array<char, 18> digits{};
    const int length =
        std::snprintf(digits.data(), digits.size(), "-%016llx", static_cast<unsigned long long>(hash));
    std::size_t cut = most - static_cast<std::size_t>(length);
    while (cut > 0 && (static_cast<unsigned char>(name[cut]) & 0xC0) == 0x80) --cut;
    shown = std::string(name.substr(0, cut)) + digits.data();
  }
  return "." + shown + std::string(mark);
}

std::string random_letters() {
  std::array<std::uint32_t, letters> numbers{};
  if (!sys::random_bytes(numbers.data(), sizeof numbers)) return {};
  std::string out;
  for (const std::uint32_t number : numbers) out += alphabet[number % alphabet.size()];
  return out;
}

std::vector<std::string> names_of(sys::FolderReader& listing) {
  std::vector<std::string> out;
  for (sys::FolderReader::Entry entry; listing.next(entry);) out.emplace_back(entry.name);
  std::sort(out.begin(), out.end());
  return out;
}

// Moves a folder home, in one step. OutputFolder leaves a link to the folder at its place there, which goes then.
void move_home(int from, const std::string& name, int home) {
  sys::FileInfo there, behind, folder;
  if (sys::rename_new_in(from, name, home, name) || !sys::file_info_in(home, name.c_str(), there) ||
      there.kind != sys::FileInfo::Kind::link || !sys::file_info_in(home, name.c_str(), behind, true) ||
      !sys::file_info_in(from, name.c_str(), folder) || behind.device != folder.device ||
      behind.number != folder.number)
    return;
  if (sys::exchange_in(from, name, home, name)) sys::remove_in(from, name.c_str());
}

// Needs no descriptor but `open`, the folder itself, so that it works where no file can be opened any more.
// Folders in it belong to others and were on their way to a new target: they are moved (back) to `home`.
// Where that fails, everything that is left stays.
void remove_folder(int parent, const std::string& name, int home, Descriptor open) {
  if (!stands_for(parent, name.c_str(), open.get())) return;
  if (sys::FolderReader listing(open.get()); listing) {
    const int folder = open.release();
    for (const std::string& entry : names_of(listing)) {
      if (!is_folder(folder, entry))
        sys::remove_in(folder, entry.c_str());
      else if (home >= 0)
        move_home(folder, entry, home);
    }
    sys::remove_folder_in(parent, name.c_str());
    return;  // the lock goes with the descriptor
  }
  sys::remove_folder_in(parent, name.c_str());
}

bool same_owner(int a, int b) {
  sys::FileInfo one, other;
  return sys::file_info(a, one) && sys::file_info(b, other) && one.owner == other.owner;
}

// Removes what a killed run has left: it has the form of a temporary's name, the owner of `fresh`, which this run has
// made there, and nobody holds its lock. A temporary that another run has just made is not locked yet: that run sees
// that its file was locked or removed, and takes another name.
void remove_remains(int parent, const std::string& prefix, int home, int fresh) {
  sys::FileInfo own;
  if (!sys::file_info(fresh, own)) return;
  for (const std::string& entry : names_in(parent)) {
    if (!entry.starts_with(prefix) || entry.size() != prefix.size() + letters ||
        entry.find_first_not_of(alphabet, prefix.size()) != entry.npos)
      continue;
    Descriptor remains(sys::open_in(parent, entry, sys::OpenIn::read));
    sys::FileInfo info;
    if (!remains || !sys::file_info(remains.get(), info) || info.owner != own.owner ||
        !sys::try_lock(remains.get()))
      continue;
    if (info.kind == sys::FileInfo::Kind::folder)
      remove_folder(parent, entry, home, std::move(remains));
    else if (info.kind == sys::FileInfo::Kind::file)
      sys::remove_in(parent, entry.c_str());
  }
}

}  // namespace

Descriptor open_folder(int at, const std::string& name) {
  return Descriptor(sys::open_in(at, name, sys::OpenIn::folder));
}

bool is_folder(int at, const std::string& name) {
  sys::FileInfo info;
  return sys::file_info_in(at, name.c_str(), info) && info.kind == sys::FileInfo::Kind::folder;
}

std::vector<std::string> names_in(int folder) {
  Descriptor reopened(sys::reopen_folder(folder));
  sys::FolderReader listing(reopened.get());
  if (!listing) return {};
  (void)reopened.release();
  return names_of(listing);
}

unsigned mode_of_new_file() {
  return 0666 & ~sys::user_mask();
}

unsigned mode_of_new_folder() {
  return 0777 & ~sys::user_mask();
}

bool rename_where_free(int from, const std::string& name, int to, const std::string& new_name) {
  if (sys::rename_new_in(from, name, to, new_name)) return true;
  if (errno != EINVAL && errno != ENOSYS) return false;
  if (sys::FileInfo info; !sys::file_info_in(to, new_name.c_str(), info))
    return sys::rename_in(from, name, to, new_name);
  errno = EEXIST;
  return false;
}

FolderLock::FolderLock(int folder, std::chrono::milliseconds most, std::string_view name, int made)
    : folder_(folder), name_(prefix_of(name) + "lock") {
  const auto end = std::chrono::steady_clock::now() + most;
  auto pause = 1ms;
  for (;;) {
    {
      // So that at a signal the file is either remembered or not yet made.
      const SignalsHeld held;
      Descriptor file(sys::open_in(folder, name_, sys::OpenIn::lock, 0600));
      if (!file) return;
      if (sys::try_lock(file.get())) {
        if (!stands_for(folder, name_.c_str(), file.get())) continue;  // its last holder has just removed it
        file_ = std::move(file);
        taken_ = false;
        remembered_ = remember_temporary(folder, name_.c_str(), -1);
        return;
      }
      const bool locked = errno == EWOULDBLOCK;
      taken_ = locked && (made < 0 || same_owner(made, file.get()));
      if (!locked) sys::remove_in(folder, name_.c_str());  // a file system without locks
      if (!taken_ || std::chrono::steady_clock::now() >= end) return;
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, 20ms);
  }
}

FolderLock::~FolderLock() {
  if (!file_) return;
  const SignalsHeld held;
  sys::remove_in(folder_, name_.c_str());
  forget_temporary(remembered_);
  (void)file_.close();
}

Temporary::Temporary(int folder, std::string_view name, Kind kind, int home) : folder_(folder), kind_(kind) {
  const std::string prefix = prefix_of(name);
  constexpr int most_tries = 100;
  for (int i = 0; i < most_tries; ++i) {
    const std::string random = random_letters();
    if (random.empty()) return;
    const std::string candidate = prefix + random;
    // So that at a signal the temporary is either remembered or not yet made.
    const SignalsHeld held;
    if (kind == Kind::file) {
      open_ = Descriptor(sys::open_in(folder, candidate, sys::OpenIn::create_temporary, 0600));
      if (!open_ && errno == EEXIST) continue;
    } else {
      if (!sys::make_folder_in(folder, candidate, 0700)) {
        if (errno == EEXIST) continue;
        return;
      }
      open_ = open_folder(folder, candidate);
      if (!open_) {
        const int why = errno;
        sys::remove_folder_in(folder, candidate.c_str());
        errno = why;
        if (why == ENOENT) continue;  // another run has taken it for remains
      }
    }
    if (!open_) return;
    if (!sys::try_lock(open_.get()) && errno == EWOULDBLOCK) continue;
    if (!stands_for(folder, candidate.c_str(), open_.get())) continue;
    name_ = candidate;
    remembered_ = remember_temporary(folder, candidate.c_str(), kind == Kind::folder ? open_.get() : -1);
    break;
  }
  if (name_.empty())
    errno = EEXIST;
  else
    remove_remains(folder, prefix, home, open_.get());
}

Temporary::Temporary(Temporary&& other) noexcept
    : folder_(other.folder_),
      kind_(other.kind_),
      name_(std::exchange(other.name_, {})),
      open_(std::move(other.open_)),
      remembered_(std::exchange(other.remembered_, -1)) {}

Temporary& Temporary::operator=(Temporary&& other) noexcept {
  std::swap(folder_, other.folder_);
  std::swap(kind_, other.kind_);
  std::swap(name_, other.name_);
  std::swap(open_, other.open_);
  std::swap(remembered_, other.remembered_);
  return *this;
}

Descriptor Temporary::exchanged(Descriptor other) {
  const SignalsHeld held;
  std::swap(open_, other);
  forget_temporary(remembered_);
  remembered_ = remember_temporary(folder_, name_.c_str(), open_.get());
  return other;
}

void Temporary::remove(int home) {
  if (name_.empty()) return;
  const int before = errno;
  const SignalsHeld held;  // the handler uses the open folder, too
  if (kind_ == Kind::folder)
    remove_folder(folder_, name_, home, std::move(open_));
  else
    sys::remove_in(folder_, name_.c_str());
  (void)keep();
  errno = before;
}

bool Temporary::keep() {
  name_.clear();
  forget_temporary(std::exchange(remembered_, -1));
  return open_.close();
}

}  // namespace etak
