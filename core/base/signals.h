// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace etak {

// Half-made files are removed when a signal ends the program. A program that wants this calls
// end_by_signals(); a program that only links the library keeps its own handling of signals.

/// From here on INT, TERM and HUP first remove what remember_temporary() names, then end the program as they
/// would by themselves (a shell sees 128 + the signal's number). A signal that was ignored stays
/// so (nohup). XFSZ is ignored: growth of a file beyond the limit is then an error of the call that writes.
void end_by_signals();

/// While an object of this class lives, in any thread, INT, TERM and HUP wait. A thread may hold them more than
/// once; it must not wait for another thread meanwhile.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;
};

/// Names a file, or a folder of files, that a signal is to remove. A folder that holds folders stays, with
/// the folders in it.
///   folder   open as long as the entry is remembered
///   name     in it, at most 255 bytes
///   opened   the folder that is to be removed, open as long as the entry is remembered; -1 for a file
/// Returns what forget_temporary() takes; -1 where the table of names is full.
int remember_temporary(int folder, const char* name, int opened);
void forget_temporary(int entry);

}  // namespace etak
