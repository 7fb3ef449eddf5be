// SPDX-License-Identifier: Apache-2.0
#ifdef _WIN32

#include "core/base/system/windows_calls.h"

// This needs the types of windows.h.
#include <shellapi.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>

namespace etak::sys {
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

std::vector<std::string> environment() {
  return {};
}

bool run_program(const std::vector<std::string>&, const std::vector<std::string>&, std::string&, int&) {
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
