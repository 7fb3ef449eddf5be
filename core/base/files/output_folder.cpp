// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/output_folder.h"

#include <fcntl.h>
#include <linux/fs.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"
#include "core/base/files/disk_queue.h"
#include "core/base/files/output_target.h"
#include "core/base/files/temporary.h"
#include "core/base/setting.h"
#include "core/base/signals.h"

namespace etak {
namespace {

// One run at a time looks at a parent and exchanges folders in it: less than a second for a large set.
constexpr std::chrono::seconds most_wait{10};

// The layout names the textures, so it comes last.
bool is_layout(const std::string& name) {
  return name.starts_with("layout") && name.ends_with(".json");
}

// Whether the process works in the folder or below.
bool holds_working_folder(const std::string& folder) {
  std::error_code failure;
  const std::string here = std::filesystem::current_path(failure).string();
  return here == folder || here.starts_with(folder + "/");
}

}  // namespace

bool is_plain_file_name(std::string_view name) {
  constexpr std::string_view separators("/\0", 2);
  return !name.empty() && name != "." && name != ".." && name.find_first_of(separators) == name.npos;
}

struct OutputFolder::State {
  std::string path;         // as the caller wrote it, for messages
  std::string parent_path;  // without links
  std::string name;         // of the target in its parent
  Replace replace = Replace::nothing;
  bool inside = false;               // the new folder is made in the target, not beside it
  bool exchanges = true;             // else files are renamed one by one
  Descriptor parent;                 // where the new folder is made: of the target, or the target itself
  Temporary fresh;                   // the new folder; the old one, after an exchange
  FolderLock placing;                // of the parent, from the last look on
  std::optional<Descriptor> placed;  // the target, once the set is in place
  std::mutex lock;                   // of the two sets
  std::set<std::string> files, removed;
  DiskQueue disk;

  std::string target_path() const { return parent_path + (parent_path == "/" ? "" : "/") + name; }
  Descriptor open_target() const {
    return inside ? Descriptor(::openat(parent.get(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC))
                  : open_folder(parent.get(), name);
  }
  int fresh_folder() const { return fresh.open().get(); }
  [[noreturn]] void fail(const char* what, const std::string& file = {}) const {
    const int why = errno;
    throw Error::at(file.empty() ? path : path + "/" + file, std::string(what) + ": " + reason_of(why));
  }

  void expect_plain(const std::string& file) const {
    if (!is_plain_file_name(file))
      throw Error::at(path, "cannot hold a file named " + printable(file), "a name without folders");
  }

  void find_target();
  void refuse_read_only() const;
  std::vector<std::string> strangers(int target) const;
  bool bring_along(int target, std::vector<std::string>& linked, std::vector<std::string>& moved);
  void put_back(int target, const std::vector<std::string>& linked, const std::vector<std::string>& moved);
  void exchange();
  void rename_one_by_one();
};

void OutputFolder::State::find_target() {
  namespace fs = std::filesystem;
  std::error_code failure;
  fs::path full = fs::absolute(path, failure);
  if (path.empty() || failure) throw Error::at(path, "is no folder's name");
  if (!full.has_filename()) full = full.parent_path();  // "out/"
  const fs::file_status status = fs::status(full, failure);
  if (fs::exists(status) && !fs::is_directory(status))
    throw Error::at(path, "is a file", "a folder to write to");
  const bool there = fs::exists(status);
  const fs::path whole =
      there ? fs::canonical(full, failure) : fs::canonical(full.parent_path(), failure) / full.filename();
  if (failure)
    throw Error::at(path, "cannot be written: " + failure.message(), "a folder whose parent exists");
  if (!there && (fs::is_symlink(fs::symlink_status(full, failure)) || full.filename() == "." ||
                 full.filename() == ".."))
    throw Error::at(path, "is a link that leads nowhere", "a folder to write to");
  parent_path = whole.parent_path().string();
  name = whole.filename().string();
  struct stat target {
  }, above{};
  const bool mounted = there && ::stat(whole.c_str(), &target) == 0 &&
                       ::stat(parent_path.c_str(), &above) == 0 && target.st_dev != above.st_dev;
  inside =
      there && (name.empty() || mounted || ::faccessat(AT_FDCWD, parent_path.c_str(), W_OK, AT_EACCESS) != 0);
  exchanges = !inside && !(there && holds_working_folder(whole.string()));
  parent =
      Descriptor(::open(inside ? whole.c_str() : parent_path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!parent) fail("cannot be written");
}

// The parent may allow another folder to take the target's place; but a target without any permission to
// write was meant to stay as it is.
void OutputFolder::State::refuse_read_only() const {
  struct stat info {};
  const Descriptor target = open_target();
  const bool there = target && ::fstat(target.get(), &info) == 0;
  if (!there || replace == Replace::anything) return;
  const bool writable =
      (info.st_mode & 0222) != 0 && ::faccessat(AT_FDCWD, target_path().c_str(), W_OK, AT_EACCESS) == 0;
  if (!writable)
    throw Error::at(path, "is read-only",
                    "a folder that may be written, or " + setting("force") + " to replace it");
}

OutputFolder::OutputFolder(const std::string& path, Replace replace) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.path = path;
  s.replace = replace;
  s.find_target();
  s.refuse_read_only();
  const Descriptor home = s.open_target();
  s.fresh = Temporary(s.parent.get(), s.inside ? "" : s.name, Temporary::Kind::folder, home.get());
  if (!s.fresh)
    throw Error::at(path, "cannot be written: " + reason_of(errno), "a folder that can be made or changed");
}

// What was not put in place is removed with the temporary.
OutputFolder::~OutputFolder() {
  tidy();
}

struct OutputFolder::File::Open {
  State& folder;
  std::string name;
  Descriptor file;
  std::string waiting;

  void flush() {
    if (!write_all(file.get(), waiting)) folder.fail("cannot be written", name);
    waiting.clear();
  }
};

OutputFolder::File::File(std::unique_ptr<Open> open) : open_(std::move(open)) {}

OutputFolder::File::~File() {
  if (!open_) return;
  ::unlinkat(open_->folder.fresh_folder(), open_->name.c_str(), 0);
  const std::lock_guard lock(open_->folder.lock);
  open_->folder.files.erase(open_->name);
}

void OutputFolder::File::add(std::string_view bytes) {
  constexpr std::size_t piece = std::size_t{64} << 10;
  if (open_->waiting.size() + bytes.size() > piece) open_->flush();
  if (bytes.size() < piece)
    open_->waiting.append(bytes);
  else if (!write_all(open_->file.get(), bytes))
    open_->folder.fail("cannot be written", open_->name);
}

void OutputFolder::File::patch(std::size_t at, std::string_view bytes) {
  open_->flush();
  while (!bytes.empty()) {
    const ssize_t wrote = ::pwrite(open_->file.get(), bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (wrote < 0 && errno != EINTR) open_->folder.fail("cannot be written", open_->name);
    if (wrote <= 0) continue;
    at += static_cast<std::size_t>(wrote);
    bytes.remove_prefix(static_cast<std::size_t>(wrote));
  }
}

void OutputFolder::File::close() {
  open_->flush();
#ifdef SYNC_FILE_RANGE_WRITE
  (void)::sync_file_range(open_->file.get(), 0, 0, SYNC_FILE_RANGE_WRITE);  // begin now, wait later
#endif
  open_->folder.disk.add(std::move(open_->file), open_->name);
  open_.reset();
}

std::string OutputFolder::path_until_commit(const std::string& name) const {
  const State& s = *state_;
  return (s.inside ? s.target_path() : s.parent_path) + "/" + s.fresh.name() + "/" + name;
}

std::unique_ptr<OutputFolder::File> OutputFolder::open(const std::string& name) {
  State& s = *state_;
  s.expect_plain(name);
  {
    const std::lock_guard lock(s.lock);
    if (!s.files.insert(name).second) throw Error::at(s.path + "/" + name, "is written twice");
  }
  // No new file is made once a signal ends the program, so that all files can be removed.
  const SignalsHeld held;
  // From here on the destructor of the file takes the name out of the set again.
  std::unique_ptr<File> out(new File(std::make_unique<File::Open>(File::Open{s, name, Descriptor(), {}})));
  out->open_->file =
      Descriptor(::openat(s.fresh_folder(), name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (!out->open_->file) s.fail("cannot be written", name);
  return out;
}

void OutputFolder::write(const std::string& name,
                         const std::function<void(const std::function<void(std::string_view)>&)>& body) {
  const std::unique_ptr<File> file = open(name);
  body([&](std::string_view bytes) { file->add(bytes); });
  file->close();
}

void OutputFolder::write(const std::string& name, std::string_view bytes) {
  write(name, [&](const auto& sink) { sink(bytes); });
}

void OutputFolder::remove_old(const std::string& name) {
  state_->expect_plain(name);
  const std::lock_guard lock(state_->lock);
  state_->removed.insert(name);
}

// What the target holds that is neither replaced nor removed.
std::vector<std::string> OutputFolder::State::strangers(int target) const {
  std::vector<std::string> out = names_in(target);
  std::erase_if(out, [&](const std::string& entry) {
    return files.count(entry) != 0 || (removed.count(entry) != 0 && !is_folder(target, entry));
  });
  return out;
}

// False where something cannot come along; `linked` and `moved` say what did.
bool OutputFolder::State::bring_along(int target, std::vector<std::string>& linked,
                                      std::vector<std::string>& moved) {
  const std::vector<std::string> all = strangers(target);
  for (const std::string& entry : all) {
    if (is_folder(target, entry)) continue;
    if (::linkat(target, entry.c_str(), fresh_folder(), entry.c_str(), 0) != 0) return false;
    linked.push_back(entry);
  }
  for (const std::string& entry : all) {
    if (!is_folder(target, entry)) continue;
    if (::renameat(target, entry.c_str(), fresh_folder(), entry.c_str()) != 0) return false;
    moved.push_back(entry);
  }
  return true;
}

void OutputFolder::State::put_back(int target, const std::vector<std::string>& linked,
                                   const std::vector<std::string>& moved) {
  for (const std::string& entry : linked) ::unlinkat(fresh_folder(), entry.c_str(), 0);
  for (const std::string& entry : moved) ::renameat(fresh_folder(), entry.c_str(), target, entry.c_str());
}

void OutputFolder::State::exchange() {
  const auto rename2 = [&](unsigned flags) {
    return ::syscall(SYS_renameat2, parent.get(), fresh.name().c_str(), parent.get(), name.c_str(), flags) ==
           0;
  };
  struct stat old {};
  Descriptor target = open_target();
  const bool there = target && ::fstat(target.get(), &old) == 0;
  // The new folder gets mode and owner of the old one; an owner that cannot be changed stays.
  if (there) (void)!::fchown(fresh_folder(), old.st_uid, old.st_gid);
  if (::fchmod(fresh_folder(), there ? old.st_mode & 07777 : mode_of_new_folder()) != 0)
    fail("cannot be put in place");

  if (!there) {
    if (::fsync(fresh_folder()) != 0) fail("cannot be put in place");
    // Without RENAME_NOREPLACE (old kernels, some network file systems): what has appeared meanwhile, if it
    // holds anything, stops a plain rename too.
    if (!rename2(RENAME_NOREPLACE) &&
        ((errno != EINVAL && errno != ENOSYS) ||
         ::renameat(parent.get(), fresh.name().c_str(), parent.get(), name.c_str()) != 0))
      fail("cannot be put in place");
    (void)fresh.keep();
    ::fsync(parent.get());
    return;
  }

  std::vector<std::string> linked, moved;
  const bool whole = bring_along(target.get(), linked, moved) && ::fsync(fresh_folder()) == 0;
  if (!whole || !rename2(RENAME_EXCHANGE)) {
    put_back(target.get(), linked, moved);
    rename_one_by_one();
    return;
  }
  ::fsync(parent.get());
  // A folder that somebody has put into the old target meanwhile is moved to the new one.
  placed = fresh.exchanged(std::move(target));
}

void OutputFolder::State::rename_one_by_one() {
  Descriptor target = open_target();
  if (!target) fail("cannot be put in place");
  std::vector<std::string> order(files.begin(), files.end());
  std::stable_partition(order.begin(), order.end(), [](const std::string& file) { return !is_layout(file); });
  for (const std::string& file : order)
    if (is_folder(target.get(), file)) throw Error::at(path + "/" + file, "is a folder", "a file to replace");
  for (const std::string& file : order)
    if (::renameat(fresh_folder(), file.c_str(), target.get(), file.c_str()) != 0)
      fail("cannot be put in place (files before it in the alphabet have been)", file);
  for (const std::string& old : removed)
    if (files.count(old) == 0) ::unlinkat(target.get(), old.c_str(), 0);
  ::fsync(target.get());
  placed = std::move(target);
}

void OutputFolder::prepare() {
  State& s = *state_;
  assert(s.fresh);
  if (const auto failure = s.disk.finish()) {
    errno = failure->second;
    s.fail("cannot be written", failure->first);
  }
  // One commit into this parent at a time, so that no file is left behind that appears between the look
  // and the exchange.
  s.placing = FolderLock(s.parent.get(), most_wait);
  if (s.placing.is_taken())
    throw Error::at(s.path, "cannot be put in place: another program holds the lock of its folder");
  struct stat info {};
  if (!s.inside && ::fstatat(s.parent.get(), s.name.c_str(), &info, AT_SYMLINK_NOFOLLOW) == 0 &&
      !S_ISDIR(info.st_mode))
    throw Error::at(s.path, "is a file by now", "a folder to write to");
  s.refuse_read_only();
  if (const Descriptor target = s.open_target())
    for (const std::string& file : s.files) {
      if (::fstatat(target.get(), file.c_str(), &info, AT_SYMLINK_NOFOLLOW) != 0) continue;
      if (S_ISDIR(info.st_mode)) throw Error::at(s.path + "/" + file, "is a folder", "a file to replace");
      if (s.replace == Replace::nothing) throw exists_already(s.path + "/" + file);
    }
}

void OutputFolder::place() {
  if (state_->exchanges)
    state_->exchange();
  else
    state_->rename_one_by_one();
  state_->placing.release();
}

void OutputFolder::tidy() {
  if (state_->placed) state_->fresh.remove(state_->placed->get());
}

}  // namespace etak
