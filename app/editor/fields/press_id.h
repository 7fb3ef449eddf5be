// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>

namespace etak::editor {

/// A number for every press of a button, grip or key: edits that share one are one step of undo.
inline int next_press_id() {
  static int last = 1 << 20;  // viewports count from 1
  return ++last;
}

/// Turns of a wheel and repeated steps of a key that follow each other closely are one press. The pause is
/// longer than the time that passes before a held key repeats.
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
