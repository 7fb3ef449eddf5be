// SPDX-License-Identifier: Apache-2.0
#if !defined(_WIN32) && !defined(__wasm__)

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/mman.h>
#include <sys/random.h>
#endif
#ifdef __APPLE__
#include <sys/random.h>
#endif

#include <array>
#include <cerrno>
#include <cstdlib>

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

}  // namespace

bool file_info(const std::string& path, FileInfo& out, bool follow) {
  struct stat info {};
  return told(info, (follow ? ::stat(path.c_str(), &info) : ::lstat(path.c_str(), &info)) == 0, out);
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

}  // namespace etak::sys

#endif
