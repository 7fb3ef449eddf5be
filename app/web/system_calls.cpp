// SPDX-License-Identifier: Apache-2.0
#include <wasi/api.h>

#include <cstdint>
#include <cstdlib>
#include <initializer_list>

// What wasi-libc asks of the system. The program opens its files by core/base/system.h, so nothing is left but the time,
// which the host tells; there are no variables of the environment, and whatever else streams of the C++ library would
// ask for is not supported. Defined here, none of these is an import of the module.

namespace {

constexpr __wasi_errno_t no = __WASI_ERRNO_NOTSUP;

}  // namespace

extern "C" {

/// Milliseconds since 1970.
[[clang::import_module("etak"), clang::import_name("now")]] double etak_now();

/// In place of strtold(), by which CLI11 reads numbers into double and which ends the program in wasi-libc
/// (toolchain.cmake has the linker put it there).
long double __wrap_strtold(const char* text, char** end) {
  return std::strtod(text, end);
}

// As the declarations of wasi-libc name what is imported.
#define ETAK_CALL(name) __imported_wasi_snapshot_preview1_##name

std::int32_t ETAK_CALL(clock_time_get)(std::int32_t, std::int64_t, std::int32_t to) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast,performance-no-int-to-ptr): an address of WASI
  *reinterpret_cast<std::int64_t*>(to) = static_cast<std::int64_t>(etak_now() * 1e6);
  return 0;
}

std::int32_t ETAK_CALL(environ_sizes_get)(std::int32_t count, std::int32_t bytes) {
  for (const std::int32_t to : {count, bytes})
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast,performance-no-int-to-ptr): an address of WASI
    *reinterpret_cast<std::int32_t*>(to) = 0;
  return 0;
}

std::int32_t ETAK_CALL(environ_get)(std::int32_t, std::int32_t) {
  return 0;
}

[[noreturn]] void ETAK_CALL(proc_exit)(std::int32_t) {
  __builtin_trap();
}

std::int32_t ETAK_CALL(fd_close)(std::int32_t) {
  return no;
}

std::int32_t ETAK_CALL(fd_fdstat_get)(std::int32_t, std::int32_t) {
  return no;
}

std::int32_t ETAK_CALL(fd_fdstat_set_flags)(std::int32_t, std::int32_t) {
  return no;
}

std::int32_t ETAK_CALL(fd_prestat_get)(std::int32_t, std::int32_t) {
  return __WASI_ERRNO_BADF;  // the end of the list of folders
}

std::int32_t ETAK_CALL(fd_prestat_dir_name)(std::int32_t, std::int32_t, std::int32_t) {
  return no;
}

std::int32_t ETAK_CALL(fd_read)(std::int32_t, std::int32_t, std::int32_t, std::int32_t) {
  return no;
}

std::int32_t ETAK_CALL(fd_seek)(std::int32_t, std::int64_t, std::int32_t, std::int32_t) {
  return no;
}

std::int32_t ETAK_CALL(fd_write)(std::int32_t, std::int32_t, std::int32_t, std::int32_t) {
  return no;
}

std::int32_t ETAK_CALL(path_open)(std::int32_t, std::int32_t, std::int32_t, std::int32_t, std::int32_t,
                                  std::int64_t, std::int64_t, std::int32_t, std::int32_t) {
  return no;
}

std::int32_t ETAK_CALL(path_filestat_get)(std::int32_t, std::int32_t, std::int32_t, std::int32_t,
                                          std::int32_t) {
  return no;
}

}  // extern "C"
