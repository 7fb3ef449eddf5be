// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>

namespace etak {

class ReadPlaces;
namespace sys {
struct FileInfo;
}

/// Something that a run writes: whole on the disk, under a name of its own, before it is put in its place.
class Output {
 public:
  Output() = default;
  virtual ~Output() = default;
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Puts this output in place, alone. Throws Error; the target is then as it was. Once.
  void commit();

  /// What this output must not be written over, which prepare() looks at.
  void keep_off(std::shared_ptr<const ReadPlaces> read) { read_ = std::move(read); }

 protected:
  /// Throws Error where the file or folder at `path` is an input of the run.
  void refuse_input(const sys::FileInfo& info, const std::string& path) const;
  /// Waits until the names in an open folder are on the disk. False only where the system says that they may be lost:
  /// some file systems cannot flush a folder, and a folder that may not be read cannot be flushed.
  static bool names_to_disk(int folder);

 private:
  friend void put_in_place(std::span<Output* const> outputs);
  /// All that takes time or is likely to fail. Throws Error.
  virtual void prepare() = 0;
  /// One step. Throws Error.
  virtual void place() = 0;
  /// Brings the new names to the disk, so that they survive a power cut. Throws Error.
  virtual void flush() {}
  /// Removes what is not needed any more.
  virtual void tidy() {}

  std::shared_ptr<const ReadPlaces> read_;
};

/// Puts the outputs of one run in place, one directly after the other and each in one step, when all of them
/// are ready. They are made ready in their order and put in place in the reverse order: what goes to a pipe stands
/// last, and a file for a folder that is exchanged stands behind that folder. Nothing but a kill, or a disk that
/// fails between two steps, can separate them: other signals wait (signals.h). What is in place is on the disk, names
/// included. Null pointers are left out. Throws Error.
void put_in_place(std::span<Output* const> outputs);

}  // namespace etak
