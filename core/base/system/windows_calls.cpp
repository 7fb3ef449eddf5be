// SPDX-License-Identifier: Apache-2.0
#ifdef _WIN32

#include "core/base/system/windows_calls.h"

#include <fcntl.h>
#include <io.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <cwchar>

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

namespace etak::sys {

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

int Handle::release() {
  if (!*this) return -1;
  // NOLINTNEXTLINE: the C library takes handles as numbers
  const int open = ::_open_osfhandle(reinterpret_cast<intptr_t>(handle_), _O_BINARY | _O_NOINHERIT);
  if (open >= 0) handle_ = INVALID_HANDLE_VALUE;
  return open;
}

HANDLE open_path(const std::string& path, DWORD access, DWORD flags) {
  const HANDLE out = ::CreateFileW(wide(path).c_str(), access, share_all, nullptr, OPEN_EXISTING,
                                   FILE_FLAG_BACKUP_SEMANTICS | flags, nullptr);
  if (out == INVALID_HANDLE_VALUE) (void)failed();
  return out;
}

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

namespace {

// Windows counts steps of 100 ns from the year 1601 on.
FileInfo::Time time_of(std::int64_t ticks) {
  constexpr std::int64_t per_second = 10'000'000, until_1970 = 11'644'473'600;
  return {ticks / per_second - until_1970, ticks % per_second * 100};
}

}  // namespace

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

}  // namespace etak::sys

#endif
