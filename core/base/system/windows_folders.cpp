// SPDX-License-Identifier: Apache-2.0
#ifdef _WIN32

#include "core/base/system/windows_calls.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace etak::sys {
namespace {

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

// A part of the list, as the system gives it, and the name that was handed out last.
struct FolderList {
  alignas(8) std::array<char, 16384> records;
  std::size_t at = 0;
  bool filled = false, begun = false;
  std::string name;
};

}  // namespace

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
    case OpenIn::lock:
      opened = open_name(folder, name, FILE_GENERIC_READ | FILE_GENERIC_WRITE, FILE_OPEN_IF,
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

bool touch_in(int folder, const char* name) {
  const Handle file(open_name(folder, name, FILE_WRITE_ATTRIBUTES, FILE_OPEN, 0));
  FILETIME now{};
  ::GetSystemTimeAsFileTime(&now);
  FILE_BASIC_INFO wanted{};  // zeros leave the rest as it is
  wanted.LastWriteTime.QuadPart = ticks_of(now);
  return file &&
         (::SetFileInformationByHandle(file.get(), FileBasicInfo, &wanted, sizeof wanted) != 0 || failed());
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

bool exchange_in(int, const std::string&, int, const std::string&) {
  errno = ENOSYS;
  return false;
}

bool make_link_in(int, const std::string&, const std::string&) {
  errno = ENOSYS;
  return false;
}

bool link_in(int from, const std::string& name, int to, const std::string& new_name) {
  return give_name(from, name, to, new_name, true, false);
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
                                         static_cast<DWORD>(list.records.size())) == 0) {
        if (::GetLastError() != ERROR_NO_MORE_FILES) return failed();
        errno = 0;
        return false;
      }
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

}  // namespace etak::sys

#endif
