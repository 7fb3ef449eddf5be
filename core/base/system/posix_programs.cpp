// SPDX-License-Identifier: Apache-2.0
#if !defined(_WIN32) && !defined(__wasm__)

#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <spawn.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif

#include <array>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <latch>

#include "core/base/system.h"

// Other systems than Linux were never tried: for them the nearest calls of POSIX and macOS are named.

namespace etak::sys {

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

std::vector<std::string> environment() {
  std::vector<std::string> out;
  for (char** each = environ; *each != nullptr; ++each) out.emplace_back(*each);
  return out;
}

bool run_program(const std::vector<std::string>& words, const std::vector<std::string>& environment,
                 std::string& out, int& status) {
  std::vector<std::string> word_copies = words, variable_copies = environment;  // posix_spawn may change them
  const auto pointers = [](std::vector<std::string>& texts) {
    std::vector<char*> list;
    for (std::string& text : texts) list.push_back(text.data());
    list.push_back(nullptr);
    return list;
  };
  const std::vector<char*> arguments = pointers(word_copies), variables = pointers(variable_copies);
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) return false;
  for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  pid_t process = 0;
  const int failure =
      ::posix_spawnp(&process, arguments.front(), &actions, nullptr, arguments.data(), variables.data());
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
  // The functions that the library itself calls are found now, because it is linked so. Most functions of the hundreds of
  // libraries behind it are never called.
  return ::dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
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
