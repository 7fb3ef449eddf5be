// SPDX-License-Identifier: Apache-2.0
#include "core/base/output_folder.h"

#include <dirent.h>
#include <fcntl.h>
#include <linux/fs.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/descriptor.h"
#include "core/base/error.h"
#include "core/base/output_target.h"
#include "core/base/parallel.h"

namespace etak {
namespace {

constexpr std::string_view mark = ".etak-";

std::string reason() {
  return std::strerror(errno);
}

Descriptor open_folder(int at, const std::string& name) {
  return Descriptor(::openat(at, name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW));
}

std::vector<std::string> names_in(int folder) {
  std::vector<std::string> out;
  DIR* listing = ::fdopendir(::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (listing == nullptr) return out;
  while (const dirent* entry = ::readdir(listing)) {
    const std::string name = entry->d_name;
    if (name != "." && name != "..") out.push_back(name);
  }
  ::closedir(listing);
  std::sort(out.begin(), out.end());
  return out;
}

bool is_folder(int at, const std::string& name) {
  struct stat info {};
  return ::fstatat(at, name.c_str(), &info, AT_SYMLINK_NOFOLLOW) == 0 && S_ISDIR(info.st_mode);
}

// Removes a folder of files. Folders in it were somebody else's, on their way to the new target: they go
// (back) to `home`, and where that cannot be everything that is left stays.
void remove_folder(int parent, const std::string& name, int home) {
  if (const Descriptor folder = open_folder(parent, name))
    for (const std::string& entry : names_in(folder.get())) {
      if (!is_folder(folder.get(), entry))
        ::unlinkat(folder.get(), entry.c_str(), 0);
      else if (home >= 0)
        ::syscall(SYS_renameat2, folder.get(), entry.c_str(), home, entry.c_str(), RENAME_NOREPLACE);
    }
  ::unlinkat(parent, name.c_str(), AT_REMOVEDIR);
}

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

// Brings written files to the disk while others are still being made: to wait for each in turn would cost
// a large set a fifth of its time.
class DiskQueue {
 public:
  ~DiskQueue() { finish(); }

  void add(Descriptor file, const std::string& name) {
    std::unique_lock lock(lock_);
    // Few descriptors are open at any time.
    room_.wait(lock, [&] { return waiting_.size() < most_waiting; });
    waiting_.emplace_back(std::move(file), name);
    if (thread_.empty() && !start_thread(thread_, [this] { work(); })) {
      // Without a thread of its own the queue brings each file to the disk at once.
      bring_first(lock);
      return;
    }
    added_.notify_one();
  }

  /// Waits until all is on the disk. The name and errno of the first file that cannot be brought there.
  std::optional<std::pair<std::string, int>> finish() {
    {
      const std::lock_guard lock(lock_);
      ended_ = true;
      added_.notify_one();
    }
    for (std::thread& thread : thread_)
      if (thread.joinable()) thread.join();
    return failure_;
  }

 private:
  static constexpr std::size_t most_waiting = 64;

  void work() {
    std::unique_lock lock(lock_);
    for (;;) {
      added_.wait(lock, [&] { return ended_ || !waiting_.empty(); });
      if (waiting_.empty()) return;
      bring_first(lock);
    }
  }

  void bring_first(std::unique_lock<std::mutex>& lock) {
    auto [file, name] = std::move(waiting_.front());
    waiting_.pop_front();
    room_.notify_one();
    lock.unlock();
    const bool good = ::fsync(file.get()) == 0 && file.close();
    const int error = errno;
    lock.lock();
    if (!good && !failure_) failure_.emplace(name, error);
  }

  std::mutex lock_;
  std::condition_variable added_, room_;
  std::deque<std::pair<Descriptor, std::string>> waiting_;
  std::optional<std::pair<std::string, int>> failure_;
  bool ended_ = false;
  std::vector<std::thread> thread_;  // none or one
};

}  // namespace

bool is_plain_file_name(std::string_view name) {
  constexpr std::string_view separators("/\0", 2);
  return !name.empty() && name != "." && name != ".." && name.find_first_of(separators) == name.npos;
}

struct OutputFolder::State {
  std::string path;         // as the caller wrote it, for messages
  std::string parent_path;  // without links
  std::string name;         // of the target in its parent
  bool overwrite = false;
  bool inside = false;    // the new folder is made in the target, not beside it
  bool exchanges = true;  // else files are renamed one by one
  Descriptor parent;      // where the new folder is made: of the target, or the target itself
  std::string made_name;  // the new folder's name in it; empty once committed
  Descriptor made;        // locked as long as it lives
  std::mutex lock;        // of the two sets
  std::set<std::string> files, removed;
  DiskQueue disk;

  std::string target_path() const { return parent_path + (parent_path == "/" ? "" : "/") + name; }
  Descriptor open_target() const {
    return inside ? Descriptor(::openat(parent.get(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC))
                  : open_folder(parent.get(), name);
  }
  std::string prefix() const { return inside ? std::string(mark) : "." + name + std::string(mark); }
  [[noreturn]] void fail(const char* what, const std::string& file = {}) const {
    const std::string why = reason();
    throw Error::at(file.empty() ? path : path + "/" + file, std::string(what) + ": " + why);
  }

  void expect_plain(const std::string& file) const {
    if (!is_plain_file_name(file))
      throw Error::at(path, "cannot hold a file named " + printable(file), "a name without folders");
  }

  void find_target();
  void remove_remains();
  bool make_folder();
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

void OutputFolder::State::remove_remains() {
  const std::string begin = prefix();
  const Descriptor home = open_target();
  for (const std::string& entry : names_in(parent.get())) {
    if (!entry.starts_with(begin) || entry.size() != begin.size() + 6) continue;
    const Descriptor remains = open_folder(parent.get(), entry);
    if (remains && ::flock(remains.get(), LOCK_EX | LOCK_NB) == 0)
      remove_folder(parent.get(), entry, home.get());
  }
}

bool OutputFolder::State::make_folder() {
  const std::string where = inside ? target_path() : parent_path;
  std::string made_path = where + "/" + prefix() + "XXXXXX";
  if (::mkdtemp(made_path.data()) == nullptr) return false;
  made_name = made_path.substr(made_path.rfind('/') + 1);
  made = open_folder(parent.get(), made_name);
  return made && (::flock(made.get(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK);
}

OutputFolder::OutputFolder(const std::string& path, bool overwrite) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.path = path;
  s.overwrite = overwrite;
  s.find_target();
  // The parent's lock: between making a folder and locking it, it looks like remains. Where locks do not work
  // nothing is removed.
  if (::flock(s.parent.get(), LOCK_EX) == 0) s.remove_remains();
  const bool made = s.make_folder();
  if (!made) {
    const std::string why = reason();
    if (!s.made_name.empty()) remove_folder(s.parent.get(), s.made_name, -1);
    throw Error::at(path, "cannot be written: " + why, "a folder that can be made or changed");
  }
  ::flock(s.parent.get(), LOCK_UN);
}

OutputFolder::~OutputFolder() {
  if (!state_->made_name.empty()) remove_folder(state_->parent.get(), state_->made_name, -1);
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
  ::unlinkat(open_->folder.made.get(), open_->name.c_str(), 0);
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
  return (s.inside ? s.target_path() : s.parent_path) + "/" + s.made_name + "/" + name;
}

std::unique_ptr<OutputFolder::File> OutputFolder::open(const std::string& name) {
  State& s = *state_;
  s.expect_plain(name);
  {
    const std::lock_guard lock(s.lock);
    if (!s.files.insert(name).second) throw Error::at(s.path + "/" + name, "is written twice");
  }
  // From here on the file takes its name out again.
  std::unique_ptr<File> out(new File(std::make_unique<File::Open>(File::Open{s, name, Descriptor(), {}})));
  out->open_->file =
      Descriptor(::openat(s.made.get(), name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
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
    if (::linkat(target, entry.c_str(), made.get(), entry.c_str(), 0) != 0) return false;
    linked.push_back(entry);
  }
  for (const std::string& entry : all) {
    if (!is_folder(target, entry)) continue;
    if (::renameat(target, entry.c_str(), made.get(), entry.c_str()) != 0) return false;
    moved.push_back(entry);
  }
  return true;
}

void OutputFolder::State::put_back(int target, const std::vector<std::string>& linked,
                                   const std::vector<std::string>& moved) {
  for (const std::string& entry : linked) ::unlinkat(made.get(), entry.c_str(), 0);
  for (const std::string& entry : moved) ::renameat(made.get(), entry.c_str(), target, entry.c_str());
}

void OutputFolder::State::exchange() {
  const auto rename2 = [&](unsigned flags) {
    return ::syscall(SYS_renameat2, parent.get(), made_name.c_str(), parent.get(), name.c_str(), flags) == 0;
  };
  struct stat old {};
  const Descriptor target = open_target();
  const mode_t mask = ::umask(0);
  ::umask(mask);
  const bool there = target && ::fstat(target.get(), &old) == 0;
  // Mode and owner of the old folder; who may not give it away keeps it.
  if (there) (void)!::fchown(made.get(), old.st_uid, old.st_gid);
  if (::fchmod(made.get(), there ? old.st_mode & 07777 : 0777 & ~mask) != 0) fail("cannot be put in place");

  if (!there) {
    if (::fsync(made.get()) != 0) fail("cannot be put in place");
    // Without RENAME_NOREPLACE (old kernels, some network file systems): what has appeared meanwhile, if it
    // holds anything, stops a plain rename too.
    if (!rename2(RENAME_NOREPLACE) &&
        ((errno != EINVAL && errno != ENOSYS) ||
         ::renameat(parent.get(), made_name.c_str(), parent.get(), name.c_str()) != 0))
      fail("cannot be put in place");
    made_name.clear();
    ::fsync(parent.get());
    return;
  }

  std::vector<std::string> linked, moved;
  const bool whole = bring_along(target.get(), linked, moved) && ::fsync(made.get()) == 0;
  if (!whole || !rename2(RENAME_EXCHANGE)) {
    put_back(target.get(), linked, moved);
    rename_one_by_one();
    return;
  }
  ::fsync(parent.get());
  remove_folder(parent.get(), std::exchange(made_name, {}), made.get());
}

void OutputFolder::State::rename_one_by_one() {
  const Descriptor target = open_target();
  if (!target) fail("cannot be put in place");
  std::vector<std::string> order(files.begin(), files.end());
  std::stable_partition(order.begin(), order.end(), [](const std::string& file) { return !is_layout(file); });
  for (const std::string& file : order)
    if (is_folder(target.get(), file)) throw Error::at(path + "/" + file, "is a folder", "a file to replace");
  for (const std::string& file : order)
    if (::renameat(made.get(), file.c_str(), target.get(), file.c_str()) != 0)
      fail("cannot be put in place (files before it in the alphabet have been)", file);
  for (const std::string& old : removed)
    if (files.count(old) == 0) ::unlinkat(target.get(), old.c_str(), 0);
  ::fsync(target.get());
  remove_folder(parent.get(), std::exchange(made_name, {}), target.get());
}

void OutputFolder::commit() {
  State& s = *state_;
  assert(!s.made_name.empty());
  if (const auto failure = s.disk.finish()) {
    errno = failure->second;
    s.fail("cannot be written", failure->first);
  }
  // One commit into this parent at a time, so that nobody's files are left behind between looking and
  // exchanging.
  ::flock(s.parent.get(), LOCK_EX);
  struct Unlock {
    int fd;
    ~Unlock() { ::flock(fd, LOCK_UN); }
  } const unlock{s.parent.get()};
  struct stat info {};
  if (!s.inside && ::fstatat(s.parent.get(), s.name.c_str(), &info, AT_SYMLINK_NOFOLLOW) == 0 &&
      !S_ISDIR(info.st_mode))
    throw Error::at(s.path, "is a file by now", "a folder to write to");
  if (const Descriptor target = s.open_target())
    for (const std::string& file : s.files) {
      if (::fstatat(target.get(), file.c_str(), &info, AT_SYMLINK_NOFOLLOW) != 0) continue;
      if (S_ISDIR(info.st_mode)) throw Error::at(s.path + "/" + file, "is a folder", "a file to replace");
      if (!s.overwrite) throw exists_already(s.path + "/" + file);
    }
  if (s.exchanges)
    s.exchange();
  else
    s.rename_one_by_one();
}

}  // namespace etak
