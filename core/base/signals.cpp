// SPDX-License-Identifier: Apache-2.0
#include "core/base/signals.h"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstring>

#include "core/base/files/descriptor.h"

namespace etak {
namespace {

// A handler may run at any moment of any thread, also within malloc: all that it calls are system calls, and
// all that it reads is this table of fixed size.
struct Entry {
  enum State : int { free, changing, remembered };
  std::atomic<int> state{free};
  int folder = -1;
  int opened = -1;  // the folder itself; -1 for a file
  std::array<char, 256> name{};
};

constexpr std::size_t most_entries = 64;
std::array<Entry, most_entries> entries;
std::atomic<int> held{0};  // threads that hold signals
thread_local int held_here = 0;
std::atomic<int> ending{0};  // the signal that ends the program

// Removes the files of a folder; false where nothing could be removed.
bool remove_files(int folder) {
  bool removed = false;
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
      const bool dots = std::strcmp(name, ".") == 0 || std::strcmp(name, "..") == 0;
      if (!dots && ::unlinkat(folder, name, 0) == 0) removed = true;
      at += record->d_reclen;
    }
  }
}

void remove_entry(const Entry& entry) {
  const char* const name = entry.name.data();
  if (entry.opened < 0) {
    ::unlinkat(entry.folder, name, 0);
    return;
  }
  // Nothing is removed where the name stands for another folder than the open one by now.
  if (!stands_for(entry.folder, name, entry.opened)) return;
  // Other threads may still make files in the folder for a moment.
  while (::unlinkat(entry.folder, name, AT_REMOVEDIR) != 0) {
    if (!remove_files(entry.opened)) {
      ::unlinkat(entry.folder, name, AT_REMOVEDIR);
      return;
    }
  }
}

[[noreturn]] void clean_and_end() {
  for (const Entry& entry : entries)
    if (entry.state == Entry::remembered) remove_entry(entry);
  const int number = ending;
  ::signal(number, SIG_DFL);
  sigset_t only;
  ::sigemptyset(&only);
  ::sigaddset(&only, number);
  ::pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
  ::raise(number);
  // The first process of a container does not die of a signal.
  ::_exit(128 + number);
}

void handle(int number) {
  int none = 0;
  ending.compare_exchange_strong(none, number);
  if (held == 0) clean_and_end();
}

}  // namespace

void end_by_signals() {
  struct sigaction action {};
  action.sa_handler = handle;
  action.sa_flags = SA_RESTART;
  ::sigemptyset(&action.sa_mask);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    if (::sigaction(number, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
      ::sigaction(number, &action, nullptr);
  }
  ::signal(SIGXFSZ, SIG_IGN);
}

SignalsHeld::SignalsHeld() {
  // A thread that holds signals already must go on to where it lets them go.
  if (held_here++ > 0) return;
  ++held;
  if (ending == 0) return;
  // A signal has come: no new work begins, and the last thread that held it back ends the program.
  if (--held == 0) clean_and_end();
  for (;;) ::pause();
}

SignalsHeld::~SignalsHeld() {
  if (--held_here > 0) return;
  if (--held == 0 && ending != 0) clean_and_end();
}

int remember_temporary(int folder, const char* name, int opened) {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    Entry& entry = entries[i];
    int state = Entry::free;
    if (std::strlen(name) >= entry.name.size() ||
        !entry.state.compare_exchange_strong(state, Entry::changing))
      continue;
    entry.folder = folder;
    entry.opened = opened;
    std::strcpy(entry.name.data(), name);
    entry.state = Entry::remembered;
    return static_cast<int>(i);
  }
  return -1;
}

void forget_temporary(int entry) {
  if (entry >= 0) entries[static_cast<std::size_t>(entry)].state = Entry::free;
}

}  // namespace etak
