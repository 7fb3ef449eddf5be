// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace etak::editor {

/// Milliseconds since this process began, loading of its libraries included.
struct SinceStart {
  double clock_ms = 0;  // in steps of the kernel's ticks, mostly 10 ms; 0 where there is no /proc
  double work_ms = 0;   // of all its threads
};
SinceStart since_start();

}  // namespace etak::editor
