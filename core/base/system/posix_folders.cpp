// SPDX-License-Identifier: Apache-2.0
#if !defined(_WIN32) && !defined(__wasm__)

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#ifdef __linux__
#include <linux/fs.h>
#include <sys/syscall.h>
#endif

#include <array>
#include <cerrno>
#include <cstring>

#include "core/base/system.h"

// Other systems than Linux were never tried: for them the nearest calls of POSIX and macOS are named.

namespace etak::sys {
namespace {

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
    case OpenIn::lock:
      flags |= O_RDWR | O_CREAT | O_NONBLOCK;
      break;
  }
  return ::openat(folder, name.c_str(), flags, static_cast<mode_t>(mode));
}

int reopen_folder(int folder) {
  return ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

bool touch_in(int folder, const char* name) {
  // Without times the kernel, or the server of a share, sets its own, and who may write the file may do so.
  return ::utimensat(folder, name, nullptr, AT_SYMLINK_NOFOLLOW) == 0;
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

bool exchange_in(int from, const std::string& name, int to, const std::string& other) {
#if defined(__linux__)
  return rename_with(RENAME_EXCHANGE, from, name, to, other);
#elif defined(__APPLE__)
  return ::renameatx_np(from, name.c_str(), to, other.c_str(), RENAME_SWAP) == 0;
#else
  errno = ENOSYS;
  return false;
#endif
}

bool link_in(int from, const std::string& name, int to, const std::string& new_name) {
  return ::linkat(from, name.c_str(), to, new_name.c_str(), 0) == 0;
}

bool make_link_in(int folder, const std::string& target, const std::string& name) {
  return ::symlinkat(target.c_str(), folder, name.c_str()) == 0;
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
  errno = 0;  // which tells the end from a failure
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

}  // namespace etak::sys

#endif
