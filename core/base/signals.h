// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace etak {

// What is half-made is gone when a signal ends the program. A program that wants this calls
// end_by_signals(); a program that only links the library keeps its own handling of signals.

/// From here on INT, TERM and HUP first remove what is remembered below, then end the program as they would
/// by themselves (a shell sees 128 + the signal's number). A signal that was ignored stays so (nohup). XFSZ
/// is ignored: a file that grows beyond the limit is then an error of the call that writes it.
void end_by_signals();

/// While one of these lives, in any thread, INT, TERM and HUP wait.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;
};

/// A file, or a folder of files, that a signal removes. Of a folder that holds folders these stay, and so
/// does the folder.
///   folder   open as long as the entry is remembered
///   name     in it, at most 255 bytes
///   opened   the folder that is to be removed, open as long as the entry is remembered; -1 for a file
/// Returns what forget_temporary() takes; -1 where so many are remembered that this one is not.
int remember_temporary(int folder, const char* name, int opened);
void forget_temporary(int entry);

}  // namespace etak
