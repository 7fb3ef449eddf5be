// SPDX-License-Identifier: Apache-2.0
#ifdef __wasm__

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "core/base/system.h"

// A program that is the only one, without signals, terminals, threads and libraries (memory_nodes.h tells of its files).

namespace etak::sys {

void on_end(void (*)(int)) {}

void end_by(int) {
  std::abort();
}

void wait_for_end() {
  std::abort();
}

std::vector<std::string> start_program(int argc, char** argv) {
  return {argv, argv + argc};
}

std::string program_path() {
  return "/etak";  // there is no such file
}

std::string program_bytes() {
  return program_path();
}

bool is_terminal(int) {
  return false;
}

unsigned terminal_columns(int) {
  return 0;
}

std::string settings_folder() {
  return {};
}

std::tm local_time(std::time_t time) {
  std::tm out{};
  ::gmtime_r(&time, &out);
  return out;
}

void* map_memory(std::size_t bytes, bool) {
  return std::calloc(bytes, 1);
}

void unmap_memory(void* memory, std::size_t) {
  std::free(memory);
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

void* open_library(const std::string&) {
  return nullptr;
}

void* library_symbol(void*, const char*) {
  return nullptr;
}

std::string library_fault() {
  return "there are no shared libraries";
}

// Asked for names of temporaries only, which nobody else can take: that they differ is enough.
bool random_bytes(void* to, std::size_t count) {
  static std::uint64_t state = 0x9E3779B97F4A7C15;
  auto* out = static_cast<unsigned char*>(to);
  for (; count > 0; --count) {
    state = state * 6364136223846793005 + 1442695040888963407;
    *out++ = static_cast<unsigned char>(state >> 56);
  }
  return true;
}

}  // namespace etak::sys

#endif
