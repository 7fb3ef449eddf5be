// SPDX-License-Identifier: Apache-2.0
#ifndef _WIN32

#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <spawn.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <linux/fs.h>
#include <sys/random.h>
#include <sys/syscall.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __APPLE__
#include <mach-o/dyld.h>
#include <sys/random.h>
#endif

#include <array>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <latch>

#include "core/base/system.h"

// Other systems than Linux were never tried: for them the nearest calls of POSIX and macOS are named.

namespace etak::sys {
namespace {

FileInfo::Kind kind_of(mode_t mode) {
  if (S_ISREG(mode)) return FileInfo::Kind::file;
  if (S_ISDIR(mode)) return FileInfo::Kind::folder;
  if (S_ISLNK(mode)) return FileInfo::Kind::link;
  if (S_ISFIFO(mode)) return FileInfo::Kind::pipe;
  return S_ISSOCK(mode) ? FileInfo::Kind::socket : FileInfo::Kind::device;
}

bool told(const struct stat& info, bool good, FileInfo& out) {
  if (!good) return false;
  out.kind = kind_of(info.st_mode);
  out.device = static_cast<std::uint64_t>(info.st_dev);
  out.number = info.st_ino;
  out.size = static_cast<std::uint64_t>(info.st_size);
#ifdef __APPLE__
  const timespec written = info.st_mtimespec, changed = info.st_ctimespec;
#else
  const timespec written = info.st_mtim, changed = info.st_ctim;
#endif
  out.written = {written.tv_sec, written.tv_nsec};
  out.changed = {changed.tv_sec, changed.tv_nsec};
  out.mode = info.st_mode & 07777;
  out.owner = info.st_uid;
  out.group = info.st_gid;
  return true;
}

// Repeats a call that a signal has interrupted.
template <class Call>
std::ptrdiff_t uninterrupted(Call call) {
  for (;;)
    if (const ssize_t result = call(); result >= 0 || errno != EINTR) return result;
}

bool is_dots(const char* name) {
  return std::strcmp(name, ".") == 0 || std::strcmp(name, "..") == 0;
}

#ifdef __linux__
// The C library of some systems has no function for it.
bool rename_with(unsigned flags, int from, const std::string& name, int to, const std::string& new_name) {
  return ::syscall(SYS_renameat2, from, name.c_str(), to, new_name.c_str(), flags) == 0;
}
#endif

}  // namespace

bool file_info(const std::string& path, FileInfo& out) {
  struct stat info {};
  return told(info, ::stat(path.c_str(), &info) == 0, out);
}

bool file_info(int open, FileInfo& out) {
  struct stat info {};
  return told(info, ::fstat(open, &info) == 0, out);
}

bool file_info_in(int folder, const char* name, FileInfo& out, bool follow) {
  struct stat info {};
  return told(info, ::fstatat(folder, name, &info, follow ? 0 : AT_SYMLINK_NOFOLLOW) == 0, out);
}

int open_file(const std::string& path, Open how) {
#ifdef O_PATH
  constexpr int only_names = O_PATH;
#else
  constexpr int only_names = O_RDONLY;
#endif
  int flags = O_CLOEXEC;
  switch (how) {
    case Open::read:
      flags |= O_RDONLY | O_NONBLOCK;
      break;
    case Open::write:
      flags |= O_WRONLY;
      break;
    case Open::folder:
      flags |= O_RDONLY | O_DIRECTORY;
      break;
    case Open::unreadable_folder:
      flags |= only_names | O_DIRECTORY;
      break;
  }
  return ::open(path.c_str(), flags);
}

int open_in(int folder, const std::string& name, OpenIn how, unsigned mode) {
  int flags = O_CLOEXEC | O_NOFOLLOW;
  switch (how) {
    case OpenIn::read:
      flags |= O_RDONLY | O_NONBLOCK;
      break;
    case OpenIn::folder:
      flags |= O_RDONLY | O_DIRECTORY;
      break;
    case OpenIn::create:
      flags |= O_WRONLY | O_CREAT | O_EXCL;
      break;
    case OpenIn::create_temporary:
      flags |= O_RDWR | O_CREAT | O_EXCL;
      break;
  }
  return ::openat(folder, name.c_str(), flags, static_cast<mode_t>(mode));
}

int reopen_folder(int folder) {
  return ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

int duplicate(int open) {
  return ::fcntl(open, F_DUPFD_CLOEXEC, 3);
}

bool close_file(int open) {
  return ::close(open) == 0;
}

std::ptrdiff_t read(int open, void* to, std::size_t count) {
  return uninterrupted([&] { return ::read(open, to, count); });
}

std::ptrdiff_t read_at(int open, void* to, std::size_t count, std::size_t at) {
  return uninterrupted([&] { return ::pread(open, to, count, static_cast<off_t>(at)); });
}

std::ptrdiff_t write(int open, const void* from, std::size_t count) {
  return uninterrupted([&] { return ::write(open, from, count); });
}

std::ptrdiff_t write_at(int open, const void* from, std::size_t count, std::size_t at) {
  return uninterrupted([&] { return ::pwrite(open, from, count, static_cast<off_t>(at)); });
}

bool touch_in(int folder, const char* name) {
  // Without times the kernel, or the server of a share, sets its own, and who may write the file may do so.
  return ::utimensat(folder, name, nullptr, AT_SYMLINK_NOFOLLOW) == 0;
}

bool to_disk(int open) {
  return ::fsync(open) == 0;
}

void begin_to_disk([[maybe_unused]] int open) {
#ifdef SYNC_FILE_RANGE_WRITE
  (void)::sync_file_range(open, 0, 0, SYNC_FILE_RANGE_WRITE);
#endif
}

bool set_mode(int open, unsigned mode) {
  return ::fchmod(open, static_cast<mode_t>(mode)) == 0;
}

void set_owner(int open, const FileInfo& like) {
  (void)!::fchown(open, like.owner, like.group);
}

// The mask can only be read by setting another one, which other threads would see: read once.
unsigned user_mask() {
  static const mode_t mask = [] {
    const mode_t found = ::umask(0);
    ::umask(found);
    return found;
  }();
  return mask;
}

bool make_folder(const std::string& path) {
  return ::mkdir(path.c_str(), 0777) == 0;
}

bool make_folder_in(int folder, const std::string& name, unsigned mode) {
  return ::mkdirat(folder, name.c_str(), static_cast<mode_t>(mode)) == 0;
}

bool remove_folder(const std::string& path) {
  return ::rmdir(path.c_str()) == 0;
}

bool remove_in(int folder, const char* name) {
  return ::unlinkat(folder, name, 0) == 0;
}

bool remove_folder_in(int folder, const char* name) {
  return ::unlinkat(folder, name, AT_REMOVEDIR) == 0;
}

bool remove_files_of(int folder) {
  bool removed = false;
#ifdef __linux__
  ::lseek(folder, 0, SEEK_SET);
  // Aligned as the kernel writes its records.
  alignas(dirent64) std::array<char, 8192> records{};
  for (;;) {
    const long length = ::syscall(SYS_getdents64, folder, records.data(), records.size());
    if (length <= 0) return removed;
    for (long at = 0; at < length;) {
      // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the kernel's records
      const auto* const record = reinterpret_cast<const dirent64*>(records.data() + at);
      const char* const name = static_cast<const char*>(record->d_name);
      if (!is_dots(name) && ::unlinkat(folder, name, 0) == 0) removed = true;
      at += record->d_reclen;
    }
  }
#else
  // Elsewhere there is no system call for it: a signal that comes within malloc() can stop the handler here.
  const int again = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  DIR* const list = again < 0 ? nullptr : ::fdopendir(again);
  if (list == nullptr) return false;
  while (const dirent* const record = ::readdir(list))
    if (!is_dots(record->d_name) && ::unlinkat(folder, record->d_name, 0) == 0) removed = true;
  ::closedir(list);
  return removed;
#endif
}

bool rename_in(int from, const std::string& name, int to, const std::string& new_name) {
  return ::renameat(from, name.c_str(), to, new_name.c_str()) == 0;
}

bool rename_new_in(int from, const std::string& name, int to, const std::string& new_name) {
#if defined(__linux__)
  return rename_with(RENAME_NOREPLACE, from, name, to, new_name);
#elif defined(__APPLE__)
  return ::renameatx_np(from, name.c_str(), to, new_name.c_str(), RENAME_EXCL) == 0;
#else
  errno = ENOSYS;
  return false;
#endif
}

bool can_exchange() {
#if defined(__linux__) || defined(__APPLE__)
  return true;
#else
  return false;
#endif
}

bool exchange_in(int folder, const std::string& a, const std::string& b) {
#if defined(__linux__)
  return rename_with(RENAME_EXCHANGE, folder, a, folder, b);
#elif defined(__APPLE__)
  return ::renameatx_np(folder, a.c_str(), folder, b.c_str(), RENAME_SWAP) == 0;
#else
  errno = ENOSYS;
  return false;
#endif
}

bool link_in(int from, const std::string& name, int to, const std::string& new_name) {
  return ::linkat(from, name.c_str(), to, new_name.c_str(), 0) == 0;
}

bool try_lock(int open) {
  return ::flock(open, LOCK_EX | LOCK_NB) == 0;
}

void unlock(int open) {
  ::flock(open, LOCK_UN);
}

bool may_write(const std::string& path) {
  return ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0;
}

bool may_read(const std::string& path) {
  return ::access(path.c_str(), R_OK) == 0;
}

bool takes_file_name(std::string_view) {
  return true;
}

FolderReader::FolderReader(int folder) : folder_(folder) {
  DIR* const list = folder < 0 ? nullptr : ::fdopendir(folder);
  if (list != nullptr) ::rewinddir(list);
  list_ = list;
}

FolderReader::~FolderReader() {
  if (list_ != nullptr) ::closedir(static_cast<DIR*>(list_));
}

bool FolderReader::next(Entry& out) {
  const dirent* entry = nullptr;
  do entry = ::readdir(static_cast<DIR*>(list_));
  while (entry != nullptr && is_dots(static_cast<const char*>(entry->d_name)));
  if (entry == nullptr) return false;
  out.name = static_cast<const char*>(entry->d_name);
  out.kind.reset();
  switch (entry->d_type) {
    case DT_UNKNOWN:
      break;
    case DT_REG:
      out.kind = FileInfo::Kind::file;
      break;
    case DT_DIR:
      out.kind = FileInfo::Kind::folder;
      break;
    case DT_LNK:
      out.kind = FileInfo::Kind::link;
      break;
    case DT_FIFO:
      out.kind = FileInfo::Kind::pipe;
      break;
    case DT_SOCK:
      out.kind = FileInfo::Kind::socket;
      break;
    default:
      out.kind = FileInfo::Kind::device;
      break;
  }
  return true;
}

bool random_bytes(void* to, std::size_t count) {
#ifdef __linux__
  return ::getrandom(to, count, 0) == static_cast<ssize_t>(count);
#else
  return ::getentropy(to, count) == 0;
#endif
}

int memory_file() {
#ifdef __linux__
  return ::memfd_create("etak-input", MFD_CLOEXEC);
#else
  std::array<char, 32> name{"/tmp/etak-input.XXXXXX"};
  const int open = ::mkstemp(name.data());
  if (open >= 0) {
    ::unlink(name.data());
    ::fcntl(open, F_SETFD, FD_CLOEXEC);
  }
  return open;
#endif
}

int reopen_memory_file(int open) {
#ifdef __linux__
  const std::string folder = "/proc/self/fd/";
#else
  const std::string folder = "/dev/fd/";
#endif
  return ::open((folder + std::to_string(open)).c_str(), O_RDONLY | O_CLOEXEC);
}

void put_in_place_of(int open, int descriptor) {
  ::lseek(open, 0, SEEK_SET);
  ::dup2(open, descriptor);
}

int wait_for_bytes(int open, int milliseconds) {
  pollfd waiting{open, POLLIN, 0};
  return ::poll(&waiting, 1, milliseconds);
}

void let_reading_wait(int open) {
  ::fcntl(open, F_SETFL, ::fcntl(open, F_GETFL) & ~O_NONBLOCK);
}

void on_end(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  ::sigemptyset(&action.sa_mask);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    if (::sigaction(number, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
      ::sigaction(number, &action, nullptr);
  }
  ::signal(SIGXFSZ, SIG_IGN);
}

void end_by(int number) {
  ::signal(number, SIG_DFL);
  sigset_t only;
  ::sigemptyset(&only);
  ::sigaddset(&only, number);
  ::pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
  ::raise(number);
  // The first process of a container does not die of a signal.
  ::_exit(128 + number);
}

void wait_for_end() {
  for (;;) ::pause();
}

std::vector<std::string> start_program(int argc, char** argv) {
  return {argv, argv + argc};
}

std::string program_path() {
  std::array<char, PATH_MAX> path{};
#if defined(__linux__)
  const ssize_t length = ::readlink("/proc/self/exe", path.data(), path.size());
  if (length <= 0 || path[0] != '/' || static_cast<std::size_t>(length) == path.size()) return {};
  return {path.data(), static_cast<std::size_t>(length)};
#elif defined(__APPLE__)
  std::array<char, PATH_MAX> found{};
  auto size = static_cast<std::uint32_t>(found.size());
  if (::_NSGetExecutablePath(found.data(), &size) != 0) return {};
  return ::realpath(found.data(), path.data()) == nullptr ? std::string() : std::string(path.data());
#else
  return {};
#endif
}

std::string program_bytes() {
#if defined(__linux__)
  return "/proc/self/exe";
#else
  return program_path();
#endif
}

bool is_terminal(int open) {
  return ::isatty(open) != 0;
}

unsigned terminal_columns(int open) {
  winsize size{};
  return ::ioctl(open, TIOCGWINSZ, &size) != 0 ? 0 : size.ws_col;
}

std::string settings_folder() {
  return {};
}

std::tm local_time(std::time_t time) {
  std::tm out{};
  ::localtime_r(&time, &out);
  return out;
}

void* map_memory(std::size_t bytes, [[maybe_unused]] bool huge) {
  void* const mapped = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) return nullptr;
#ifdef MADV_HUGEPAGE
  if (huge) (void)::madvise(mapped, bytes, MADV_HUGEPAGE);  // the kernel need not follow it
#endif
  return mapped;
}

void unmap_memory(void* memory, std::size_t bytes) {
  ::munmap(memory, bytes);
}

void keep_freed_memory([[maybe_unused]] int largest, [[maybe_unused]] int kept, [[maybe_unused]] int ahead) {
#ifdef __GLIBC__
  (void)::mallopt(M_MMAP_THRESHOLD, largest);
  (void)::mallopt(M_TRIM_THRESHOLD, kept);
  if (ahead > 0) (void)::mallopt(M_TOP_PAD, ahead);
#endif
}

namespace {

// Threads of the system, since those of the standard library free memory when they end, for which the C library
// would give each a heap of 64 MiB of addresses and keep it.
bool may_start_threads(std::size_t count) {
  std::latch all_started(1);
  std::vector<pthread_t> threads(count);
  std::size_t started = 0;
  const auto wait = [](void* latch) -> void* {
    static_cast<std::latch*>(latch)->wait();
    return nullptr;
  };
  while (started < count && ::pthread_create(&threads[started], nullptr, wait, &all_started) == 0) ++started;
  all_started.count_down();
  for (std::size_t i = 0; i < started; ++i) ::pthread_join(threads[i], nullptr);
  return started == count;
}

bool has_addresses(std::size_t bytes) {
#ifdef MAP_NORESERVE
  constexpr int flags = MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE;
#else
  constexpr int flags = MAP_PRIVATE | MAP_ANONYMOUS;
#endif
  void* const room = ::mmap(nullptr, bytes, PROT_NONE, flags, -1, 0);
  if (room == MAP_FAILED) return false;
  ::munmap(room, bytes);
  return true;
}

}  // namespace

// The threads come first, since the C library keeps their stacks.
bool has_room(std::size_t threads, std::size_t bytes) {
  return may_start_threads(threads) && has_addresses(bytes);
}

bool run_program(const std::vector<std::string>& words, std::string& out, int& status) {
  std::vector<std::string> copies = words;  // posix_spawn takes arguments that may be changed
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) return false;
  for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  pid_t process = 0;
  const int failure =
      ::posix_spawnp(&process, arguments.front(), &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  out.clear();
  std::array<char, 1 << 16> block{};
  while (failure == 0) {
    const ssize_t got = ::read(ends[0], block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    out.append(block.data(), static_cast<std::size_t>(got));
  }
  ::close(ends[0]);
  errno = failure;
  if (failure != 0) return false;
  int ended = 0;
  while (::waitpid(process, &ended, 0) < 0 && errno == EINTR) continue;
  status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
  return true;
}

void* open_library(const std::string& path) {
  return ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
}

void* library_symbol(void* library, const char* name) {
  return ::dlsym(library, name);
}

std::string library_fault() {
  const char* const why = ::dlerror();
  return why == nullptr ? "" : why;
}

}  // namespace etak::sys

#endif
