// SPDX-License-Identifier: Apache-2.0
#ifdef _WIN32

#include "core/base/system/windows_calls.h"

// This needs the types of windows.h.
#include <bcrypt.h>

#include <io.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <map>
#include <mutex>

namespace etak::sys {
namespace {

constexpr std::size_t largest_step = std::size_t{1} << 30;  // bytes of one call that reads or writes

// Locks by the existence of a named object: the system removes it when its holder ends, however that ends.
struct Locks {
  std::mutex lock;
  std::map<int, HANDLE> held;
};
Locks& locks() {
  static Locks all;
  return all;
}

void let_go(int open) {
  Locks& all = locks();
  const std::lock_guard guard(all.lock);
  if (const auto found = all.held.find(open); found != all.held.end()) {
    ::CloseHandle(found->second);
    all.held.erase(found);
  }
}

std::ptrdiff_t moved_bytes(BOOL done, DWORD count) {
  if (done != 0) return static_cast<std::ptrdiff_t>(count);
  const DWORD fault = ::GetLastError();
  errno = errno_of(fault);
  return -1;
}

DWORD step(std::size_t count) {
  return static_cast<DWORD>(std::min(count, largest_step));
}

OVERLAPPED place(std::size_t at) {
  OVERLAPPED out{};
  out.Offset = static_cast<DWORD>(at & 0xFFFFFFFFU);
  out.OffsetHigh = static_cast<DWORD>(std::uint64_t{at} >> 32);
  return out;
}

// A call with an offset moves the place at which read() and write() go on: it is put back.
class KeptPlace {
 public:
  explicit KeptPlace(HANDLE file) : file_(file) {
    kept_ = ::SetFilePointerEx(file_, LARGE_INTEGER{}, &place_, FILE_CURRENT) != 0;
  }
  KeptPlace(const KeptPlace&) = delete;
  KeptPlace& operator=(const KeptPlace&) = delete;
  ~KeptPlace() {
    const DWORD fault = ::GetLastError();
    if (kept_) ::SetFilePointerEx(file_, place_, nullptr, FILE_BEGIN);
    ::SetLastError(fault);
  }

 private:
  HANDLE file_;
  LARGE_INTEGER place_{};
  bool kept_;
};

// The end of a file or pipe is no failure.
bool at_end() {
  const DWORD fault = ::GetLastError();
  return fault == ERROR_HANDLE_EOF || fault == ERROR_BROKEN_PIPE;
}

}  // namespace

bool file_info(const std::string& path, FileInfo& out, bool follow) {
  const Handle file(open_path(path, FILE_READ_ATTRIBUTES, follow ? 0 : FILE_FLAG_OPEN_REPARSE_POINT));
  return file && told(file.get(), out);
}

bool file_info(int open, FileInfo& out) {
  return told(handle_of(open), out);
}

bool file_info_in(int folder, const char* name, FileInfo& out, bool follow) {
  const Handle file(open_name(folder, name, FILE_READ_ATTRIBUTES, FILE_OPEN, follow ? follow_links : 0));
  return file && told(file.get(), out);
}

int open_file(const std::string& path, Open how) {
  const bool folder = how == Open::folder || how == Open::unreadable_folder;
  const DWORD access = how == Open::write    ? GENERIC_WRITE
                       : how == Open::read   ? GENERIC_READ
                       : how == Open::folder ? FILE_LIST_DIRECTORY | FILE_READ_ATTRIBUTES | FILE_TRAVERSE
                                             : FILE_READ_ATTRIBUTES | FILE_TRAVERSE;
  Handle file(open_path(path, access | SYNCHRONIZE));
  FileInfo info;
  if (!file || !told(file.get(), info)) return -1;
  if (folder && info.kind != FileInfo::Kind::folder) {
    errno = ENOTDIR;
    return -1;
  }
  return file.release();
}

int duplicate(int open) {
  HANDLE out = INVALID_HANDLE_VALUE;
  const HANDLE here = ::GetCurrentProcess();
  if (::DuplicateHandle(here, handle_of(open), here, &out, 0, FALSE, DUPLICATE_SAME_ACCESS) == 0) {
    (void)failed();
    return -1;
  }
  return Handle(out).release();
}

bool close_file(int open) {
  let_go(open);
  return ::_close(open) == 0;
}

std::ptrdiff_t read(int open, void* to, std::size_t count) {
  DWORD got = 0;
  const BOOL done = ::ReadFile(handle_of(open), to, step(count), &got, nullptr);
  return done == 0 && at_end() ? 0 : moved_bytes(done, got);
}

std::ptrdiff_t read_at(int open, void* to, std::size_t count, std::size_t at) {
  DWORD got = 0;
  OVERLAPPED from = place(at);
  const KeptPlace kept(handle_of(open));
  const BOOL done = ::ReadFile(handle_of(open), to, step(count), &got, &from);
  return done == 0 && at_end() ? 0 : moved_bytes(done, got);
}

std::ptrdiff_t write(int open, const void* from, std::size_t count) {
  DWORD wrote = 0;
  const BOOL done = ::WriteFile(handle_of(open), from, step(count), &wrote, nullptr);
  const std::ptrdiff_t out = moved_bytes(done, wrote);
  // A reader of the output that stops early ends the program without a word, as SIGPIPE does elsewhere.
  constexpr UINT ended_by_sigpipe = 128 + 13;
  if (out < 0 && errno == EPIPE && open == standard_output)
    ::TerminateProcess(::GetCurrentProcess(), ended_by_sigpipe);
  return out;
}

std::ptrdiff_t write_at(int open, const void* from, std::size_t count, std::size_t at) {
  DWORD wrote = 0;
  OVERLAPPED to = place(at);
  const KeptPlace kept(handle_of(open));
  const BOOL done = ::WriteFile(handle_of(open), from, step(count), &wrote, &to);
  return moved_bytes(done, wrote);
}

// The file system keeps the lists of folders itself.
bool to_disk(int open) {
  FileInfo info;
  if (file_info(open, info) && info.kind == FileInfo::Kind::folder) return true;
  return ::FlushFileBuffers(handle_of(open)) != 0 || failed();
}

void begin_to_disk(int) {}

bool set_mode(int open, unsigned mode) {
  FILE_BASIC_INFO basic{};
  if (::GetFileInformationByHandleEx(handle_of(open), FileBasicInfo, &basic, sizeof basic) == 0)
    return failed();
  if ((basic.FileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0) return true;
  const bool read_only = (mode & 0222) == 0;
  if (((basic.FileAttributes & FILE_ATTRIBUTE_READONLY) != 0) == read_only) return true;
  FILE_BASIC_INFO wanted{};  // zeros leave the times as they are
  wanted.FileAttributes = (basic.FileAttributes & ~DWORD{FILE_ATTRIBUTE_READONLY}) |
                          (read_only ? FILE_ATTRIBUTE_READONLY : FILE_ATTRIBUTE_NORMAL);
  return ::SetFileInformationByHandle(handle_of(open), FileBasicInfo, &wanted, sizeof wanted) != 0 ||
         failed();
}

void set_owner(int, const FileInfo&) {}

unsigned user_mask() {
  return 0;
}

bool try_lock(int open) {
  FileInfo info;
  if (!file_info(open, info)) return false;
  const std::wstring name =
      L"Local\\etak-lock-" + std::to_wstring(info.device) + L"-" + std::to_wstring(info.number);
  Locks& all = locks();
  const std::lock_guard guard(all.lock);
  if (all.held.count(open) != 0) return true;
  const HANDLE object = ::CreateMutexW(nullptr, FALSE, name.c_str());
  if (object == nullptr) return failed();
  if (::GetLastError() == ERROR_ALREADY_EXISTS) {
    ::CloseHandle(object);
    errno = EWOULDBLOCK;
    return false;
  }
  all.held.emplace(open, object);
  return true;
}

void unlock(int open) {
  let_go(open);
}

bool may_write(const std::string& path) {
  FileInfo info;
  return file_info(path, info) && (info.mode & 0222) != 0;
}

bool may_read(const std::string& path) {
  const Handle file(open_path(path, GENERIC_READ));
  return static_cast<bool>(file);
}

bool random_bytes(void* to, std::size_t count) {
  return ::BCryptGenRandom(nullptr, static_cast<PUCHAR>(to), static_cast<ULONG>(count),
                           BCRYPT_USE_SYSTEM_PREFERRED_RNG) >= 0;
}

int memory_file() {
  std::array<WCHAR, MAX_PATH + 1> folder{};
  const DWORD length = ::GetTempPathW(static_cast<DWORD>(folder.size()), folder.data());
  std::array<std::uint64_t, 2> numbers{};
  if (length == 0 || length >= folder.size() || !random_bytes(numbers.data(), sizeof numbers)) {
    (void)failed();
    return -1;
  }
  const std::wstring path = std::wstring(folder.data()) + L"etak-input-" + std::to_wstring(numbers[0]) +
                            std::to_wstring(numbers[1]);
  Handle file(::CreateFileW(path.c_str(), GENERIC_READ | GENERIC_WRITE, share_all, nullptr, CREATE_NEW,
                            FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, nullptr));
  if (!file) (void)failed();
  return file.release();
}

int reopen_memory_file(int open) {
  Handle file(::ReOpenFile(handle_of(open), GENERIC_READ, share_all, 0));
  if (!file) (void)failed();
  return file.release();
}

void put_in_place_of(int open, int descriptor) {
  ::_lseeki64(open, 0, SEEK_SET);
  ::_dup2(open, descriptor);
}

// Windows waits for the bytes of a pipe only by reading them.
int wait_for_bytes(int, int) {
  return 1;
}

void let_reading_wait(int) {}

}  // namespace etak::sys

#endif
