// SPDX-License-Identifier: Apache-2.0
#include "core/base/signals.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <type_traits>

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
static_assert(std::is_trivially_destructible_v<decltype(held_here)>);
std::atomic<int> ending{0};  // the signal that ends the program
std::atomic<bool> cleaning{false};

void remove_entry(const Entry& entry) {
  const char* const name = entry.name.data();
  if (entry.opened < 0) {
    sys::remove_in(entry.folder, name);
    return;
  }
  // Nothing is removed where the name stands for another folder than the open one by now.
  if (!stands_for(entry.folder, name, entry.opened)) return;
  // Other threads may still make files in the folder for a moment.
  while (!sys::remove_folder_in(entry.folder, name)) {
    if (!sys::remove_files_of(entry.opened)) {
      sys::remove_folder_in(entry.folder, name);
      return;
    }
  }
}

// Returns where another thread, or what this signal has interrupted, is cleaning already: of two that list one open
// folder each sees a part of its files, and the first to be done would end the program before the other.
void clean_and_end() {
  if (cleaning.exchange(true)) return;
  for (const Entry& entry : entries)
    if (entry.state == Entry::remembered) remove_entry(entry);
  sys::end_by(ending);
}

// Where a signal has come, no new work begins, nor does a thread end the program as if all was well: the last one that
// held the signal back ends it.
void let_go() {
  const bool last = --held == 0;
  if (ending == 0) return;
  if (last) clean_and_end();
  sys::wait_for_end();
}

void handle(int number) {
  int none = 0;
  ending.compare_exchange_strong(none, number);
  if (held == 0) clean_and_end();
}

}  // namespace

void end_by_signals() {
  sys::on_end(handle);
}

SignalsHeld::SignalsHeld() {
  // A thread that holds signals already must go on to where it lets them go.
  if (held_here++ > 0) return;
  ++held;
  if (ending != 0) let_go();
}

SignalsHeld::~SignalsHeld() {
  if (--held_here == 0) let_go();
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
