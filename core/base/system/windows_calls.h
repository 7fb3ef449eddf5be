// SPDX-License-Identifier: Apache-2.0
#pragma once

#define WIN32_LEAN_AND_MEAN
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
// This needs the types of windows.h.
#include <winternl.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/system.h"

// What the sources for Windows share: the reason of a failure, text in the system's encoding, handles.
//
// Descriptors are those of Microsoft's C library, each of them around a handle. Files are opened so that other
// programs may read, write, rename and delete them meanwhile, as POSIX systems have it; names in an open folder
// are looked up by the kernel relative to its handle, so that nobody can lead them elsewhere by a rename or a link.

namespace etak::sys {

constexpr DWORD share_all = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

/// The errno for a fault of Windows.
int errno_of(DWORD fault);
/// Keeps the reason of the call that has just failed in errno; returns false.
bool failed();
/// Whether the kernel's call succeeded; keeps the reason in errno where it did not.
bool good(NTSTATUS status);

/// UTF-8 to the system's UTF-16, and back.
std::wstring wide(std::string_view text);
std::string narrow(std::wstring_view text);
/// For the kernel, which knows one kind of slashes only.
std::wstring wide_name(std::string_view name);

HANDLE handle_of(int open);

/// A handle that is closed with the object.
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

  /// The descriptor that owns the handle from here on; -1 where there is none.
  int release();

 private:
  HANDLE handle_;
};

HANDLE open_path(const std::string& path, DWORD access, DWORD flags = 0);

/// Opens or makes a name in an open folder; an empty name stands for the folder. Links are not followed unless
/// `options` say so by follow_links.
constexpr ULONG follow_links = 0x80000000U;
HANDLE open_name(int folder, std::string_view name, ACCESS_MASK access, ULONG disposition, ULONG options);

std::int64_t ticks_of(const FILETIME& time);
bool is_link(HANDLE handle);
/// What is known of what is behind the handle.
bool told(HANDLE handle, FileInfo& out);

}  // namespace etak::sys
