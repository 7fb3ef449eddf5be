// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>

namespace etak::editor {

/// A new number for a press of a button, handle or key. Edits with the same number are one step of undo.
inline int next_press_id() {
  static int last = 1 << 20;  // viewports count their own presses from 1
  return ++last;
}

/// The press id of turns of a wheel and of repeated steps of a key: steps that follow each other closely have
/// the same one. The pause that ends a press is longer than the time before a held key repeats.
class RepeatedPress {
 public:
  int id() {
    constexpr qint64 pause_ms = 800;
    if (id_ == 0 || !since_.isValid() || since_.elapsed() > pause_ms) id_ = next_press_id();
    since_.start();
    return id_;
  }

 private:
  QElapsedTimer since_;
  int id_ = 0;
};

}  // namespace etak::editor
