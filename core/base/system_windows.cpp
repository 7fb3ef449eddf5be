// SPDX-License-Identifier: Apache-2.0
#ifdef _WIN32

#define WIN32_LEAN_AND_MEAN
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
// These need the types of windows.h.
#include <bcrypt.h>
#include <shellapi.h>
#include <winternl.h>

#include <fcntl.h>
#include <io.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <cwchar>
#include <map>
#include <mutex>

#include "core/base/system.h"

// libstdc++ makes a std::filesystem::path of narrow text by mbrtowc(), and Microsoft's C library knows no locale of
// UTF-8 for it. The linker puts this function in its place (CMakeLists.txt), which reads UTF-8 always. A character
// beyond the first 65,536 gives its two halves in two calls; the second half waits in the state meanwhile.
extern "C" std::size_t __wrap_mbrtowc(wchar_t* to, const char* from, std::size_t count,
                                      std::mbstate_t* state);
extern "C" std::size_t __wrap_mbrtowc(wchar_t* to, const char* from, std::size_t count,
                                      std::mbstate_t* state) {
  constexpr auto broken = static_cast<std::size_t>(-1), unfinished = static_cast<std::size_t>(-2);
  static_assert(sizeof *state >= sizeof(std::uint16_t));
  std::uint16_t waiting = 0;
  if (state != nullptr) std::memcpy(&waiting, state, sizeof waiting);
  const auto give = [&](std::uint32_t code, std::uint16_t next, std::size_t length) {
    if (to != nullptr) *to = static_cast<wchar_t>(code);
    if (state != nullptr) std::memcpy(state, &next, sizeof next);
    return length;
  };
  if (from == nullptr) return 0;
  if (count == 0) return unfinished;
  if (waiting != 0) return give(waiting, 0, 1);
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(from[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return give(first, 0, first == 0 ? 0 : 1);
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4) return broken;
  if (count < length) return unfinished;
  std::uint32_t code = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return broken;
    code = code << 6 | (byte(i) & 0x3FU);
  }
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < least[length] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return broken;
  if (length < 4) return give(code, 0, length);
  code -= 0x10000;
  return give(0xD800 + (code >> 10), static_cast<std::uint16_t>(0xDC00 + (code & 0x3FF)), 3);
}

// Descriptors are those of Microsoft's C library, each of them around a handle. Files are opened so that other
// programs may read, write, rename and delete them meanwhile, as POSIX systems have it; names in an open folder
// are looked up by the kernel relative to its handle, so that nobody can lead them elsewhere by a rename or a link.

namespace etak::sys {
namespace {

constexpr DWORD share_all = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
constexpr std::size_t largest_step = std::size_t{1} << 30;  // bytes of one call that reads or writes

int errno_of(DWORD fault) {
  switch (fault) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_DRIVE:
    case ERROR_BAD_NETPATH:
    case ERROR_BAD_NET_NAME:
    case ERROR_INVALID_NAME:
    case ERROR_BAD_PATHNAME:
      return ENOENT;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
    case ERROR_DELETE_PENDING:
      return EACCES;
    case ERROR_ALREADY_EXISTS:
    case ERROR_FILE_EXISTS:
      return EEXIST;
    case ERROR_DIR_NOT_EMPTY:
      return ENOTEMPTY;
    case ERROR_DIRECTORY:
      return ENOTDIR;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
      return ENOSPC;
    case ERROR_NOT_SAME_DEVICE:
      return EXDEV;
    case ERROR_WRITE_PROTECT:
      return EROFS;
    case ERROR_TOO_MANY_OPEN_FILES:
      return EMFILE;
    case ERROR_NOT_ENOUGH_MEMORY:
    case ERROR_OUTOFMEMORY:
    case ERROR_COMMITMENT_LIMIT:
      return ENOMEM;
    case ERROR_INVALID_HANDLE:
      return EBADF;
    case ERROR_BROKEN_PIPE:
    case ERROR_PIPE_NOT_CONNECTED:
    case ERROR_NO_DATA:
      return EPIPE;
    case ERROR_FILENAME_EXCED_RANGE:
      return ENAMETOOLONG;
    case ERROR_INVALID_FUNCTION:
    case ERROR_NOT_SUPPORTED:
    case ERROR_CALL_NOT_IMPLEMENTED:
      return ENOSYS;
    case ERROR_INVALID_PARAMETER:
      return EINVAL;
    default:
      return EIO;
  }
}

// Keeps the reason of the call that has just failed; returns false.
bool failed() {
  errno = errno_of(::GetLastError());
  return false;
}

bool good(NTSTATUS status) {
  if (status >= 0) return true;
  errno = errno_of(::RtlNtStatusToDosError(status));
  return false;
}

std::wstring wide(std::string_view text) {
  const int count = static_cast<int>(std::min(text.size(), std::size_t{1} << 20));
  std::wstring out(text.size(), L'\0');
  const int length =
      ::MultiByteToWideChar(CP_UTF8, 0, text.data(), count, out.data(), static_cast<int>(out.size()));
  out.resize(static_cast<std::size_t>(std::max(length, 0)));
  return out;
}

// For the kernel, which knows one kind of slashes only.
std::wstring wide_name(std::string_view name) {
  std::wstring out = wide(name);
  std::replace(out.begin(), out.end(), L'/', L'\\');
  return out;
}

std::string narrow(std::wstring_view text) {
  std::string out(3 * text.size(), '\0');
  const int length = text.empty()
                         ? 0
                         : ::WideCharToMultiByte(CP_UTF8, 0, text.data(), static_cast<int>(text.size()),
                                                 out.data(), static_cast<int>(out.size()), nullptr, nullptr);
  out.resize(static_cast<std::size_t>(std::max(length, 0)));
  return out;
}

HANDLE handle_of(int open) {
  // NOLINTNEXTLINE: the C library gives handles as numbers
  return reinterpret_cast<HANDLE>(::_get_osfhandle(open));
}

// A handle that is closed with the object.
class Handle {
 public:
  explicit Handle(HANDLE handle = INVALID_HANDLE_VALUE) : handle_(handle) {}
  ~Handle() {
    if (*this) ::CloseHandle(handle_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  explicit operator bool() const { return handle_ != INVALID_HANDLE_VALUE && handle_ != nullptr; }
  HANDLE get() const { return handle_; }

  // The descriptor that owns the handle from here on; -1 where there is none.
  int release() {
    if (!*this) return -1;
    const int open =
        ::_open_osfhandle(reinterpret_cast<intptr_t>(handle_), _O_BINARY | _O_NOINHERIT);  // NOLINT
    if (open >= 0) handle_ = INVALID_HANDLE_VALUE;
    return open;
  }

 private:
  HANDLE handle_;
};

HANDLE open_path(const std::string& path, DWORD access, DWORD flags = 0) {
  const HANDLE out = ::CreateFileW(wide(path).c_str(), access, share_all, nullptr, OPEN_EXISTING,
                                   FILE_FLAG_BACKUP_SEMANTICS | flags, nullptr);
  if (out == INVALID_HANDLE_VALUE) (void)failed();
  return out;
}

// Opens or makes a name in an open folder; an empty name stands for the folder. Links are not followed unless
// `options` say so by follow_links.
constexpr ULONG follow_links = 0x80000000U;
HANDLE open_name(int folder, std::string_view name, ACCESS_MASK access, ULONG disposition, ULONG options) {
  std::wstring text = wide_name(name);
  UNICODE_STRING unicode{};
  unicode.Buffer = text.data();
  unicode.Length = static_cast<USHORT>(std::min<std::size_t>(2 * text.size(), 65532));
  unicode.MaximumLength = unicode.Length;
  OBJECT_ATTRIBUTES attributes{};
  attributes.Length = sizeof attributes;
  attributes.RootDirectory = handle_of(folder);
  attributes.ObjectName = &unicode;
  attributes.Attributes = OBJ_CASE_INSENSITIVE;
  IO_STATUS_BLOCK status{};
  const ULONG links = (options & follow_links) != 0 ? 0 : FILE_OPEN_REPARSE_POINT;
  HANDLE out = INVALID_HANDLE_VALUE;
  if (!good(::NtCreateFile(&out, access | SYNCHRONIZE, &attributes, &status, nullptr, FILE_ATTRIBUTE_NORMAL,
                           share_all, disposition,
                           (options & ~follow_links) | links | FILE_SYNCHRONOUS_IO_NONALERT, nullptr, 0)))
    return INVALID_HANDLE_VALUE;
  return out;
}

std::int64_t ticks_of(const FILETIME& time) {
  return static_cast<std::int64_t>(std::uint64_t{time.dwHighDateTime} << 32 | time.dwLowDateTime);
}

// Windows counts steps of 100 ns from the year 1601 on.
FileInfo::Time time_of(std::int64_t ticks) {
  constexpr std::int64_t per_second = 10'000'000, until_1970 = 11'644'473'600;
  return {ticks / per_second - until_1970, ticks % per_second * 100};
}

bool is_link(HANDLE handle) {
  FILE_ATTRIBUTE_TAG_INFO tag{};
  return ::GetFileInformationByHandleEx(handle, FileAttributeTagInfo, &tag, sizeof tag) != 0 &&
         (tag.FileAttributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0 &&
         IsReparseTagNameSurrogate(tag.ReparseTag);
}

bool told(HANDLE handle, FileInfo& out) {
  out = {};
  const DWORD type = ::GetFileType(handle);
  if (type == FILE_TYPE_CHAR || type == FILE_TYPE_PIPE) {
    out.kind = type == FILE_TYPE_PIPE ? FileInfo::Kind::pipe : FileInfo::Kind::device;
    out.mode = 0666;
    return true;
  }
  BY_HANDLE_FILE_INFORMATION info{};
  if (::GetFileInformationByHandle(handle, &info) == 0) return failed();
  const bool folder = (info.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
  out.kind = is_link(handle) ? FileInfo::Kind::link : folder ? FileInfo::Kind::folder : FileInfo::Kind::file;
  out.device = info.dwVolumeSerialNumber;
  out.number = std::uint64_t{info.nFileIndexHigh} << 32 | info.nFileIndexLow;
  out.size = folder ? 0 : std::uint64_t{info.nFileSizeHigh} << 32 | info.nFileSizeLow;
  out.written = out.changed = time_of(ticks_of(info.ftLastWriteTime));
  FILE_BASIC_INFO basic{};
  if (::GetFileInformationByHandleEx(handle, FileBasicInfo, &basic, sizeof basic) != 0)
    out.changed = time_of(basic.ChangeTime.QuadPart);
  // "Read-only" says nothing about a folder.
  const bool read_only = !folder && (info.dwFileAttributes & FILE_ATTRIBUTE_READONLY) != 0;
  out.mode = folder ? 0777 : read_only ? 0444 : 0666;
  return true;
}

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

// What NtSetInformationFile takes for a rename and for a hard link, with or without flags in place of `replace`.
struct NewName {
  union {
    BOOLEAN replace;
    ULONG flags;
  };
  HANDLE folder;
  ULONG bytes;
  std::array<WCHAR, 1024> name;
};
constexpr int rename_information = 10, link_information = 11, rename_information_ex = 65;
constexpr ULONG rename_replace = 1, rename_posix = 2, rename_ignore_read_only = 0x40;

// What the kernel calls, with the type of the second number left open.
NTSTATUS set_information(HANDLE handle, void* info, ULONG bytes, int kind) {
  IO_STATUS_BLOCK status{};
  return ::NtSetInformationFile(handle, &status, info, bytes, static_cast<FILE_INFORMATION_CLASS>(kind));
}

bool give_name(int from, const std::string& name, int to, const std::string& new_name, bool link,
               bool replace) {
  const Handle file(
      open_name(from, name, link ? FILE_READ_ATTRIBUTES : DELETE | FILE_READ_ATTRIBUTES, FILE_OPEN, 0));
  if (!file) return false;
  const std::wstring text = wide_name(new_name);
  NewName wanted{};
  if (text.size() > wanted.name.size()) {
    errno = ENAMETOOLONG;
    return false;
  }
  wanted.folder = handle_of(to);
  wanted.bytes = static_cast<ULONG>(2 * text.size());
  std::copy(text.begin(), text.end(), wanted.name.begin());
  if (!link) {
    // This replaces a file that somebody has open, too. Older systems do not know it.
    wanted.flags = rename_posix | (replace ? rename_replace | rename_ignore_read_only : 0);
    const NTSTATUS status = set_information(file.get(), &wanted, sizeof wanted, rename_information_ex);
    const DWORD fault = status >= 0 ? 0 : ::RtlNtStatusToDosError(status);
    if (status >= 0) return true;
    if (fault == ERROR_ALREADY_EXISTS || fault == ERROR_FILE_EXISTS) return good(status);
    wanted.flags = 0;
  }
  wanted.replace = replace ? TRUE : FALSE;
  return good(
      set_information(file.get(), &wanted, sizeof wanted, link ? link_information : rename_information));
}

bool remove_name(int folder, const char* name, bool is_folder) {
  // A link to a folder is removed as a file is.
  const Handle file(
      open_name(folder, name, DELETE | FILE_READ_ATTRIBUTES | FILE_WRITE_ATTRIBUTES, FILE_OPEN, 0));
  if (!file) return false;
  FileInfo info;
  if (!told(file.get(), info)) return false;
  if ((info.kind == FileInfo::Kind::folder) != is_folder) {
    errno = is_folder ? ENOTDIR : EISDIR;
    return false;
  }
  // DELETE, POSIX_SEMANTICS, IGNORE_READONLY_ATTRIBUTE: gone at once, even where somebody has it open.
  ULONG flags = 0x1 | 0x2 | 0x10;
  constexpr int disposition_information = 13, disposition_information_ex = 64;
  const NTSTATUS status = set_information(file.get(), &flags, sizeof flags, disposition_information_ex);
  if (status >= 0) return true;
  if (::RtlNtStatusToDosError(status) == ERROR_DIR_NOT_EMPTY) return good(status);
  BOOLEAN removed = TRUE;
  return good(set_information(file.get(), &removed, sizeof removed, disposition_information));
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

bool file_info(const std::string& path, FileInfo& out) {
  const Handle file(open_path(path, FILE_READ_ATTRIBUTES));
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

int open_in(int folder, const std::string& name, OpenIn how, unsigned) {
  HANDLE opened = INVALID_HANDLE_VALUE;
  switch (how) {
    case OpenIn::read:
      opened = open_name(folder, name, FILE_GENERIC_READ, FILE_OPEN, 0);
      break;
    case OpenIn::folder:
      opened = open_name(folder, name, FILE_LIST_DIRECTORY | FILE_READ_ATTRIBUTES | FILE_TRAVERSE, FILE_OPEN,
                         FILE_DIRECTORY_FILE);
      break;
    case OpenIn::create:
      opened = open_name(folder, name, FILE_GENERIC_WRITE | FILE_READ_ATTRIBUTES, FILE_CREATE,
                         FILE_NON_DIRECTORY_FILE);
      break;
    case OpenIn::create_temporary:
      opened = open_name(folder, name, FILE_GENERIC_READ | FILE_GENERIC_WRITE, FILE_CREATE,
                         FILE_NON_DIRECTORY_FILE);
      break;
  }
  Handle file(opened);
  if (file && is_link(file.get())) {
    errno = ELOOP;
    return -1;
  }
  return file.release();
}

int reopen_folder(int folder) {
  return Handle(open_name(folder, {}, FILE_LIST_DIRECTORY | FILE_READ_ATTRIBUTES | FILE_TRAVERSE, FILE_OPEN,
                          FILE_DIRECTORY_FILE))
      .release();
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

bool touch_in(int folder, const char* name) {
  const Handle file(open_name(folder, name, FILE_WRITE_ATTRIBUTES, FILE_OPEN, 0));
  FILETIME now{};
  ::GetSystemTimeAsFileTime(&now);
  FILE_BASIC_INFO wanted{};  // zeros leave the rest as it is
  wanted.LastWriteTime.QuadPart = ticks_of(now);
  return file &&
         (::SetFileInformationByHandle(file.get(), FileBasicInfo, &wanted, sizeof wanted) != 0 || failed());
}

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

bool make_folder(const std::string& path) {
  return ::CreateDirectoryW(wide(path).c_str(), nullptr) != 0 || failed();
}

bool make_folder_in(int folder, const std::string& name, unsigned) {
  const Handle made(open_name(folder, name, FILE_LIST_DIRECTORY, FILE_CREATE, FILE_DIRECTORY_FILE));
  return static_cast<bool>(made);
}

bool remove_folder(const std::string& path) {
  return ::RemoveDirectoryW(wide(path).c_str()) != 0 || failed();
}

bool remove_in(int folder, const char* name) {
  return remove_name(folder, name, false);
}

bool remove_folder_in(int folder, const char* name) {
  return remove_name(folder, name, true);
}

bool remove_files_of(int folder) {
  bool removed = false;
  const int again = reopen_folder(folder);
  FolderReader list(again);
  if (!list) {
    if (again >= 0) (void)close_file(again);
    return false;
  }
  for (FolderReader::Entry entry; list.next(entry);)
    if (remove_in(folder, entry.name)) removed = true;
  return removed;
}

bool rename_in(int from, const std::string& name, int to, const std::string& new_name) {
  return give_name(from, name, to, new_name, false, true);
}

bool rename_new_in(int from, const std::string& name, int to, const std::string& new_name) {
  return give_name(from, name, to, new_name, false, false);
}

bool can_exchange() {
  return false;
}

bool exchange_in(int, const std::string&, const std::string&) {
  errno = ENOSYS;
  return false;
}

bool link_in(int from, const std::string& name, int to, const std::string& new_name) {
  return give_name(from, name, to, new_name, true, false);
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

// Colons begin the names of streams in a file, the other signs are wildcards, and what ends with a dot or a space
// stands for the name without it. Names of devices stand for these in every folder, whatever their ending.
bool takes_file_name(std::string_view name) {
  for (const char c : name)
    if (static_cast<unsigned char>(c) < 32 || std::strchr("\\/:*?\"<>|", c) != nullptr) return false;
  if (name.empty() || name.ends_with('.') || name.ends_with(' ')) return false;
  std::string stem(name.substr(0, name.find('.')));
  while (stem.ends_with(' ')) stem.pop_back();
  for (char& c : stem)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  for (const char* device : {"CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$"})
    if (stem == device) return false;
  const bool numbered = stem.size() == 4 && stem[3] >= '0' && stem[3] <= '9';
  return !numbered || (!stem.starts_with("COM") && !stem.starts_with("LPT"));
}

namespace {

// A part of the list, as the system gives it, and the name that was handed out last.
struct FolderList {
  alignas(8) std::array<char, 16384> records;
  std::size_t at = 0;
  bool filled = false, begun = false;
  std::string name;
};

}  // namespace

FolderReader::FolderReader(int folder) : folder_(folder) {
  FileInfo info;
  if (folder >= 0 && file_info(folder, info) && info.kind == FileInfo::Kind::folder) list_ = new FolderList();
}

FolderReader::~FolderReader() {
  if (list_ == nullptr) return;
  delete static_cast<FolderList*>(list_);
  (void)close_file(folder_);
}

bool FolderReader::next(Entry& out) {
  FolderList& list = *static_cast<FolderList*>(list_);
  for (;;) {
    if (!list.filled) {
      const auto kind = list.begun ? FileIdBothDirectoryInfo : FileIdBothDirectoryRestartInfo;
      if (::GetFileInformationByHandleEx(handle_of(folder_), kind, list.records.data(),
                                         static_cast<DWORD>(list.records.size())) == 0)
        return false;
      list.begun = list.filled = true;
      list.at = 0;
    }
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the system's records
    const auto* const record = reinterpret_cast<const FILE_ID_BOTH_DIR_INFO*>(list.records.data() + list.at);
    if (record->NextEntryOffset == 0)
      list.filled = false;
    else
      list.at += record->NextEntryOffset;
    list.name = narrow({static_cast<const WCHAR*>(record->FileName), record->FileNameLength / 2});
    if (list.name == "." || list.name == "..") continue;
    out.name = list.name.c_str();
    out.kind.reset();
    if ((record->FileAttributes & FILE_ATTRIBUTE_REPARSE_POINT) == 0)
      out.kind = (record->FileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0 ? FileInfo::Kind::folder
                                                                          : FileInfo::Kind::file;
    return true;
  }
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

namespace {

void (*end_handler)(int) = nullptr;
constexpr int as_ctrl_c = 1;

BOOL WINAPI on_console_event(DWORD event) {
  end_handler(as_ctrl_c);
  // The handler is still here, so somebody holds signals back and ends the program soon. When the function
  // returns from the closing of the console, Windows ends the program itself.
  if (event != CTRL_C_EVENT && event != CTRL_BREAK_EVENT) wait_for_end();
  return TRUE;
}

}  // namespace

void on_end(void (*handler)(int)) {
  end_handler = handler;
  ::SetConsoleCtrlHandler(on_console_event, TRUE);
}

void end_by(int) {
  constexpr UINT ended_by_ctrl_c = 0xC000013A;
  ::TerminateProcess(::GetCurrentProcess(), ended_by_ctrl_c);
  std::_Exit(1);
}

void wait_for_end() {
  for (;;) ::Sleep(INFINITE);
}

std::vector<std::string> start_program(int argc, char** argv) {
  ::SetConsoleOutputCP(CP_UTF8);
  ::SetConsoleCP(CP_UTF8);
  ::SetErrorMode(SEM_FAILCRITICALERRORS);  // no window that asks for a disk
  for (const DWORD which : {STD_OUTPUT_HANDLE, STD_ERROR_HANDLE}) {
    const HANDLE console = ::GetStdHandle(which);
    if (DWORD mode = 0; ::GetConsoleMode(console, &mode) != 0)
      ::SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
  }
  int count = 0;
  wchar_t** const words = ::CommandLineToArgvW(::GetCommandLineW(), &count);
  if (words == nullptr) return {argv, argv + argc};
  std::vector<std::string> out;
  for (int i = 0; i < count; ++i) out.push_back(narrow(words[i]));
  ::LocalFree(words);
  return out;
}

std::string program_path() {
  std::wstring path(32768, L'\0');
  path.resize(::GetModuleFileNameW(nullptr, path.data(), static_cast<DWORD>(path.size())));
  std::replace(path.begin(), path.end(), L'\\', L'/');
  return narrow(path);
}

std::string program_bytes() {
  return program_path();
}

bool is_terminal(int open) {
  DWORD mode = 0;
  return ::GetConsoleMode(handle_of(open), &mode) != 0;
}

unsigned terminal_columns(int open) {
  CONSOLE_SCREEN_BUFFER_INFO info{};
  if (::GetConsoleScreenBufferInfo(handle_of(open), &info) == 0) return 0;
  return static_cast<unsigned>(std::max(0, info.srWindow.Right - info.srWindow.Left + 1));
}

std::string settings_folder() {
  std::wstring path(32768, L'\0');
  const DWORD length = ::GetEnvironmentVariableW(L"APPDATA", path.data(), static_cast<DWORD>(path.size()));
  path.resize(length < path.size() ? length : 0);
  std::replace(path.begin(), path.end(), L'\\', L'/');
  return narrow(path);
}

std::tm local_time(std::time_t time) {
  std::tm out{};
  ::localtime_s(&out, &time);
  return out;
}

void* map_memory(std::size_t bytes, bool) {
  return ::VirtualAlloc(nullptr, bytes, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE);
}

void unmap_memory(void* memory, std::size_t) {
  ::VirtualFree(memory, 0, MEM_RELEASE);
}

void keep_freed_memory(int, int, int) {}

bool has_room(std::size_t, std::size_t) {
  return true;
}

bool run_program(const std::vector<std::string>&, std::string&, int&) {
  errno = ENOSYS;
  return false;
}

void* open_library(const std::string& path) {
  return ::LoadLibraryW(wide_name(path).c_str());
}

void* library_symbol(void* library, const char* name) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the one way from a function to a symbol
  return reinterpret_cast<void*>(::GetProcAddress(static_cast<HMODULE>(library), name));
}

std::string library_fault() {
  return "fault " + std::to_string(::GetLastError()) + " of Windows";
}

}  // namespace etak::sys

#endif
