// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace etak {

/// Something that a run writes: whole on the disk, under a name of its own, before it is put in its place.
class Output {
 public:
  Output() = default;
  virtual ~Output() = default;
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Puts this output in place, alone. Throws Error; the target is then as it was. Once.
  void commit();

 private:
  friend void put_in_place(std::span<Output* const> outputs);
  /// All that takes time or is likely to fail. Throws Error.
  virtual void prepare() = 0;
  /// One step. Throws Error.
  virtual void place() = 0;
  /// Removes what is not needed any more.
  virtual void tidy() {}
};

/// Puts the outputs of one run in place, one directly after the other and each in one step, when all of them
/// are ready. Nothing but a kill, or a disk that fails between two steps, can separate them: other signals
/// wait (signals.h). Null pointers are left out. Throws Error.
void put_in_place(std::span<Output* const> outputs);

}  // namespace etak
