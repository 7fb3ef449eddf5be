// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/files/descriptor.h"

namespace etak {

/// Opens the folder `name` in `at` without following a link; nothing is open where that fails.
Descriptor open_folder(int at, const std::string& name);
/// Whether `name` in the open folder `at` is a folder itself and not a link to one.
bool is_folder(int at, const std::string& name);
/// What the open folder holds, in the order of bytes, without "." and "..".
std::vector<std::string> names_in(int folder);

/// The modes of new files and folders: 0666 and 0777, less the user's mask.
unsigned mode_of_new_file();
unsigned mode_of_new_folder();

/// Gives a file or folder another name where nothing has it, also where the system cannot look and rename in one step
/// (old kernels, some network file systems). Fails with EEXIST where something has it.
bool rename_where_free(int from, const std::string& name, int to, const std::string& new_name);

/// The lock of a name in an open folder, which etak's runs hold for moments while they place files there. It is a
/// file ".NAME.etak-lock" that only its user may open, because whoever may read a file or a folder can lock it for
/// ever. The file is removed with the lock.
class FolderLock {
 public:
  ///   folder   stays the caller's, open as long as this lives
  ///   most     how long another run that holds the lock is waited for
  ///   made     open, and made in that folder by this run: a lock of another owner is no lock; -1: all owners count
  FolderLock(int folder, std::chrono::milliseconds most, std::string_view name = "folder", int made = -1);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  bool held() const { return static_cast<bool>(file_); }
  /// Whether another run of this user held the lock all the time. Where neither this nor held() is true, there are no
  /// locks: the file cannot be made, was made by somebody else, or its file system has none.
  bool is_taken() const { return taken_; }

 private:
  int folder_;
  std::string name_;
  Descriptor file_;
  int remembered_ = -1;
  bool taken_ = false;
};

/// A new file or folder under a name of its own beside what it is to become: ".NAME.etak-XXXXXX", random and
/// made exclusively. It is removed with the object, by a signal that ends the program (signals.h), or after a
/// kill by the next temporary for the same NAME and of the same owner, which leaves those in use alone: they are
/// locked. A NAME too long to be lengthened is replaced by its beginning and a hash of the whole.
class Temporary {
 public:
  enum class Kind { file, folder };

  Temporary() = default;
  /// Where no temporary can be made, nothing is open, and errno tells why.
  ///   folder    an open folder to make it in; stays the caller's, open as long as this lives
  ///   name      the name of what it is to become
  ///   home      an open folder that takes folders which others put into the remains of a kill; -1: they stay
  Temporary(int folder, std::string_view name, Kind kind, int home = -1);
  ~Temporary() { remove(-1); }
  Temporary(Temporary&& other) noexcept;
  Temporary& operator=(Temporary&& other) noexcept;

  explicit operator bool() const { return !name_.empty(); }
  /// The temporary's name in the folder; empty when there is none (any more).
  const std::string& name() const { return name_; }
  /// Open for writing, or the open folder.
  const Descriptor& open() const { return open_; }
  /// To be called after its name and another were exchanged, with what its name stands for now (`other`).
  /// Returns what its name stood for.
  Descriptor exchanged(Descriptor other);
  /// Removes it now; folders in a folder go to `home`, or stay where that is -1.
  void remove(int home);
  /// Gives up the removal, once it has its final name. False where closing it reports lost bytes.
  bool keep();

 private:
  int folder_ = -1;
  Kind kind_ = Kind::file;
  std::string name_;
  Descriptor open_;
  int remembered_ = -1;
};

}  // namespace etak
